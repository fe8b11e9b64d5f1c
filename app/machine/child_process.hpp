// This program again, as a process of its own.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// Where a process writes to; both may be the same file. Former contents are replaced.
struct ProcessFiles {
    std::filesystem::path output, messages;
};

/// Whether Ctrl-C in the terminal reaches the process as well, or only its parent, which tells it on; the
/// system then asks it to stop when the parent is killed.
enum class ProcessTie { shares_terminal, ends_with_parent };

/// Start this program with the words. Throws FileError where the system starts no process.
pid_t start_program(std::vector<std::string> words, const ProcessFiles& files, ProcessTie tie);

/// How a process has ended: its exit code, or less than 0 minus the signal that ended it; none while it runs.
std::optional<int> end_code(pid_t child);

} // namespace quicksand
