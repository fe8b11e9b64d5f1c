// Processes of this program, several at a time.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace quicksand {

/// A process to start: its words, and the file that its output goes to.
struct PoolTask {
    std::vector<std::string> words;
    std::filesystem::path log;
};

/// How a process ended.
struct PoolEnd {
    int code = 0;         // exit code, or less than 0: minus the signal that ended it
    double seconds = 0.0; // wall time [s]
};

/// Run the tasks, `at_once` at a time, and call `ended(k, end)` when the k-th has ended, in any order. Once
/// StopSignal::received() no further one starts, and those that run are asked to stop once. Throws FileError
/// where no process can be started.
void run_pool(const std::vector<PoolTask>& tasks, int at_once,
              const std::function<void(std::size_t, const PoolEnd&)>& ended);

} // namespace quicksand
