// What is left to look at where the soil has not come to rest: a frame for ParaView and a picture.
#pragma once

#include "io/results/results_folder.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <string>

namespace quicksand {

/// Write settling.pvd with one frame of the state and settling.png, its displacement since it was drawn.
/// `title` is that of the scene. Returns what was written, in lines for the log, or why it was not: a run
/// ends for its own reason, whatever becomes of its picture.
std::string leave_settling_evidence(const ResultsFolder& folder, const std::string& title,
                                    const Problem& problem, const State& state);

} // namespace quicksand
