#include "io/scene/state_keys.hpp"

#include "io/scene/stage_changes.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace quicksand {

namespace {

/// changed_keys() of those wanted. What laws derive from keys that are given follows from them.
std::vector<std::string> changes(const std::vector<ResolvedKey>& before, const std::vector<ResolvedKey>& now,
                                 bool (*wanted)(std::string_view path))
{
    std::set<std::string> given;
    for (const std::vector<ResolvedKey>* keys : {&before, &now})
        for (const ResolvedKey& key : *keys)
            if (key.given) given.insert(key.path);
    return changed_keys(before, now,
                        [&](const std::string& path) { return given.contains(path) && wanted(path); });
}

} // namespace

bool only_stops_or_reports(std::string_view path)
{
    constexpr std::array<std::string_view, 12> keys{
        "title",
        "scene_version",
        "base",
        "without",
        "accept",
        "relaxation.tolerance",
        "relaxation.max_steps",
        "run.end_time",
        "output.checkpoint_interval",
        "output.frame_interval",
        "output.history_interval",
        "output.probe_interval",
    };
    if (std::find(keys.begin(), keys.end(), path) != keys.end()) return true;
    if (path.starts_with("figures.")) return true;
    return path.starts_with("stages.") && path.ends_with(".duration");
}

std::string state_text(const std::vector<ResolvedKey>& keys)
{
    std::string text;
    for (const ResolvedKey& key : keys)
        if (!only_stops_or_reports(key.path)) text += key.path + " = " + key.value + '\n';
    return text;
}

std::vector<std::string> state_changes(const std::vector<ResolvedKey>& before,
                                       const std::vector<ResolvedKey>& now)
{
    return changes(before, now, [](std::string_view path) { return !only_stops_or_reports(path); });
}

std::vector<std::string> report_changes(const std::vector<ResolvedKey>& before,
                                        const std::vector<ResolvedKey>& now)
{
    return changes(before, now, only_stops_or_reports);
}

} // namespace quicksand
