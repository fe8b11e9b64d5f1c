// Rows in processes of their own: one that crashes or never ends takes nothing else with it.
#pragma once

#include "app/stress/rows/row_outcome.hpp"

#include <functional>
#include <string>
#include <vector>

namespace quicksand {

struct ProcessLimits {
    int at_once = 1;       // processes
    double seconds = 60.0; // wall time of one; then it is ended
};

/// Start this program with the words of every row, several at once, with their output in the row's files.
/// `ended(k, end)` is called when the k-th has ended, in any order. Throws FileError where no process can be
/// started.
void run_processes(const std::vector<std::vector<std::string>>& words, const std::vector<RowFiles>& files,
                   const ProcessLimits& limits,
                   const std::function<void(std::size_t, const ProcessEnd&)>& ended);

} // namespace quicksand
