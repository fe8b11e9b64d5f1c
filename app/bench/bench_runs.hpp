// Runs of a scene that a benchmark compares.
#pragma once

#include "app/run/choices.hpp"

#include <filesystem>
#include <optional>
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

/// Run a scene with a setting in a folder, in place of what is there; returns the wall time [s], none where
/// the run goes bad, which it tells itself. Throws InputError, and StopRequest when the user stops the run.
std::optional<double> run_setting(const std::string& scene, const Setting& setting, const BenchChoice& choice,
                                  const std::filesystem::path& directory);

} // namespace quicksand
