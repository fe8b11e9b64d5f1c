#include "app/stress/scenes/scene_draft.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace quicksand {

namespace {

/// "materials.soil" and "porosity".
std::pair<std::string, std::string> split(const std::string& path)
{
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos) return {"", path};
    return {path.substr(0, dot), path.substr(dot + 1)};
}

} // namespace

std::string draft_number(double value)
{
    return fmt::format("{:.9g}", value);
}

SceneDraft::Table& SceneDraft::table(const std::string& name)
{
    const auto found = std::find_if(tables_.begin(), tables_.end(),
                                    [&](const Table& candidate) { return candidate.name == name; });
    return found != tables_.end() ? *found : tables_.emplace_back(Table{name, {}});
}

SceneDraft& SceneDraft::put(const std::string& path, std::string value)
{
    const auto [name, key] = split(path);
    auto& keys = table(name).keys;
    const auto found =
        std::find_if(keys.begin(), keys.end(), [&key = key](const auto& pair) { return pair.first == key; });
    if (found != keys.end()) {
        found->second = std::move(value);
    } else {
        keys.emplace_back(key, std::move(value));
    }
    return *this;
}

SceneDraft& SceneDraft::set(const std::string& path, double value)
{
    return put(path, draft_number(value));
}

SceneDraft& SceneDraft::set(const std::string& path, const std::string& text)
{
    return put(path, '"' + text + '"');
}

SceneDraft& SceneDraft::set(const std::string& path, double x, double y)
{
    return put(path, fmt::format("[{}, {}]", draft_number(x), draft_number(y)));
}

SceneDraft& SceneDraft::set_whole(const std::string& path, int x, int y)
{
    return put(path, fmt::format("[{}, {}]", x, y));
}

SceneDraft& SceneDraft::remove(const std::string& path)
{
    std::erase_if(tables_, [&](const Table& candidate) { return candidate.name == path && !path.empty(); });
    const auto [name, key] = split(path);
    std::erase_if(table(name).keys, [&key = key](const auto& pair) { return pair.first == key; });
    return *this;
}

SceneDraft& SceneDraft::add_table(const std::string& name)
{
    table(name);
    return *this;
}

bool SceneDraft::has(const std::string& path) const
{
    const auto [name, key] = split(path);
    return std::any_of(tables_.begin(), tables_.end(), [&name = name, &key = key](const Table& candidate) {
        return candidate.name == name && std::any_of(candidate.keys.begin(), candidate.keys.end(),
                                                     [&](const auto& pair) { return pair.first == key; });
    });
}

std::string SceneDraft::text(const std::string& heading) const
{
    std::string text = "# " + heading + "\n";
    for (const Table& each : tables_) {
        if (!each.name.empty()) text += fmt::format("\n[{}]\n", each.name);
        for (const auto& [key, value] : each.keys) text += fmt::format("{} = {}\n", key, value);
    }
    return text;
}

} // namespace quicksand
