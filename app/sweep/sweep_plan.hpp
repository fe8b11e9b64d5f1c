// What a sweep has to do: its runs, and which of them are done already.
#pragma once

#include "app/run/choices.hpp"
#include "io/sweeps/sweep_outcomes.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

struct SweepPlan {
    Sweep sweep;
    std::vector<CheckedRun> runs;
    std::vector<std::size_t> left; // numbers of the runs that are not finished
    std::filesystem::path folder;  // of the sweep, absolute
    std::string from;              // results that all runs go on from, absolute; empty: from the drawing
    int jobs = 1, threads = 1;     // runs at a time, threads of each
};

/// Read and check everything; writes nothing. Throws InputError where a run cannot be or a folder holds other
/// results.
SweepPlan plan_sweep(const SweepChoice& choice);

/// The words with which this program does a run: "run", the scene and so on.
std::vector<std::string> words_of(const SweepPlan& plan, const CheckedRun& run);

/// The folder in which the runs keep what gmsh made of their drawings.
std::filesystem::path drawings_of(const SweepPlan& plan);

/// A line for every run: its folder, its values, and what is left to do.
std::string describe_plan(const SweepPlan& plan);

} // namespace quicksand
