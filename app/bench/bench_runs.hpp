// Runs of a scene that a benchmark compares.
#pragma once

#include "app/run/choices.hpp"
#include "app/run/session.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// A way to run a scene: keys that replace its own.
struct Setting {
    std::string name;
    std::vector<std::string> overrides; // --set key=value
};

/// A name without commas and spaces.
std::string file_name_of(std::string name);

struct SettingRun {
    SessionEnd end = SessionEnd::finished;
    double seconds = 0.0; // wall time
};

/// Run a scene with a setting in a folder, in place of what is there; reports a run
/// that fails. Throws InputError.
SettingRun run_setting(const std::string& scene, const Setting& setting, const BenchChoice& choice,
                       const std::filesystem::path& directory);

} // namespace quicksand
