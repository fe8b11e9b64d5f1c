#include "io/keys/scene_schema.hpp"

#include "io/keys/scene_document.hpp"

namespace quicksand {

namespace {

bool matches(std::string_view pattern, const KeyPath& path)
{
    for (const std::string& part : path) {
        if (pattern.empty()) return false;
        const auto end = pattern.find('.');
        const std::string_view wanted = pattern.substr(0, end);
        if (wanted != "*" && wanted != part) return false;
        pattern = end == std::string_view::npos ? std::string_view() : pattern.substr(end + 1);
    }
    return pattern.empty();
}

bool is_bare(std::string_view part)
{
    return !part.empty() &&
           part.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
               std::string_view::npos;
}

} // namespace

std::string join_path(const KeyPath& path)
{
    std::string text;
    for (const std::string& part : path) {
        if (!text.empty()) text += '.';
        text += is_bare(part) ? part : toml_text(part);
    }
    return text;
}

const SceneKey* find_key(const KeyTable& table, const KeyPath& path)
{
    for (const SceneKey& key : table.keys) {
        if (matches(key.pattern, path)) return &key;
    }
    return nullptr;
}

std::vector<const SceneKey*> keys_of_table(const KeyTable& table, std::string_view table_pattern)
{
    std::vector<const SceneKey*> keys;
    for (const SceneKey& key : table.keys) {
        if (table_part(key.pattern) == table_pattern) keys.push_back(&key);
    }
    return keys;
}

std::string_view last_part(std::string_view pattern)
{
    const auto dot = pattern.rfind('.');
    return dot == std::string_view::npos ? pattern : pattern.substr(dot + 1);
}

std::string_view table_part(std::string_view pattern)
{
    const auto dot = pattern.rfind('.');
    return dot == std::string_view::npos ? std::string_view() : pattern.substr(0, dot);
}

} // namespace quicksand
