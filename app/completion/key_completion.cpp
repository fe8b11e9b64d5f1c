#include "app/completion/key_completion.hpp"

#include "io/keys/scene_text.hpp"
#include "io/scene/scene_base.hpp"

#include <CLI/StringTools.hpp>

#include <optional>
#include <utility>

namespace quicksand {

namespace {

KeyPath split_path(const std::string& text)
{
    return text.empty() ? KeyPath() : CLI::detail::split(text, '.');
}

/// The file with what it takes over from its base; nothing where it cannot be read.
std::optional<DocumentNode> document_of(const std::filesystem::path& file)
{
    if (!std::filesystem::is_regular_file(file)) return std::nullopt;
    Diagnostics findings;
    const std::optional<std::string> text = read_text_file(file, {}, findings);
    if (!text) return std::nullopt;
    std::optional<DocumentNode> document = read_document(file, *text, {}, findings);
    return document ? merge_with_base(file, std::move(*document), findings) : std::nullopt;
}

/// Names below a table in the file, but those that a shell would need quotes for.
std::vector<std::string> names_in(const std::filesystem::path& file, const std::string& table)
{
    std::vector<std::string> names;
    const std::optional<DocumentNode> document = document_of(file);
    const DocumentNode* node = document ? document->find(table) : nullptr;
    if (node == nullptr) return names;
    for (const DocumentNode& child : node->children) {
        if (join_path({child.name}) == child.name) names.push_back(child.name);
    }
    return names;
}

std::vector<Candidate> value_candidates(const KeyTable& table, const std::string& path)
{
    std::vector<Candidate> candidates;
    const SceneKey* key = find_key(table, split_path(path));
    if (key == nullptr) return candidates;
    for (const std::string_view word : key->words) candidates.push_back({path + "=" + std::string(word), ""});
    return candidates;
}

} // namespace

std::vector<Candidate> key_candidates(const KeyTable& table, const std::filesystem::path& file,
                                      const std::string& word)
{
    if (const auto equals = word.find('='); equals != std::string::npos)
        return value_candidates(table, word.substr(0, equals));
    const auto dot = word.rfind('.');
    const std::string above = dot == std::string::npos ? "" : word.substr(0, dot);
    const std::string stem = dot == std::string::npos ? "" : above + ".";
    const SceneKey* parent = above.empty() ? nullptr : find_key(table, split_path(above));
    std::vector<Candidate> candidates;
    if (parent == nullptr && !above.empty()) return candidates;
    for (const SceneKey* key : keys_of_table(table, parent == nullptr ? "" : parent->pattern)) {
        const std::string name(last_part(key->pattern)), about(key->doc);
        if (name != "*") {
            candidates.push_back({stem + name + (is_table(*key) ? "." : "="), about});
            continue;
        }
        for (const std::string& given : names_in(file, above))
            candidates.push_back({stem + given + ".", about});
    }
    return candidates;
}

} // namespace quicksand
