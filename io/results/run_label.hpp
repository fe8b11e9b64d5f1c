// What every CSV file says of its run in its first lines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// What the comment block above a CSV file tells of the run.
struct RunLabel {
    std::filesystem::path scene_file;
    std::string scene_hash;
};

/// "Quicksand 0.1.0" and the scene with its hash.
std::vector<std::string> run_comments(const RunLabel& label);

} // namespace quicksand
