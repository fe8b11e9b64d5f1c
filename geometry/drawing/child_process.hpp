// Running another program with a time limit.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

enum class ChildEnd { exited, signalled, out_of_time };

struct ChildResult {
    ChildEnd end = ChildEnd::exited;
    int code = 0; // exit code, or the number of the signal [-]
};

/// Run a program without input and output and wait for it; it is killed after `time_limit` [s].
/// Throws FileError when it cannot be started.
ChildResult run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                        double time_limit);

} // namespace quicksand
