// The runs of a sweep: each with its folder, the words after --set, and what the scene makes of them.
#pragma once

#include "io/results/run_manifest.hpp"
#include "io/sweeps/sweep_file.hpp"

#include <string>
#include <vector>

namespace quicksand {

struct SweepRun {
    int number = 0;                     // from 1
    std::string folder;                 // "run_0001", in that of the sweep
    std::vector<std::string> overrides; // path=value: the fixed ones, then one of each varied key
};

/// The product of all lists, the first key changing least often, and within it the samples.
std::vector<SweepRun> runs_of(const Sweep& sweep);

/// A varied key's value in one run.
struct RunValue {
    std::string text;    // SI, as `check` shows it
    std::string unit;    // SI, "" without one
    double number = 0.0; // NaN where it is no number
};

/// A run whose scene has been read.
struct CheckedRun {
    SweepRun run;
    std::vector<RunValue> values; // of the varied keys
    std::string results; // its folder; of a scene with stages, in it that of the one that is collected
    std::string hash;    // scene_hash() of the run, or of that stage
    std::vector<InputFile> inputs;   // files that the scene names
    std::vector<std::string> probes; // of which there will be histories
};

/// Read the scene of every run. Throws InputError with the errors of all at once, each message with its runs.
std::vector<CheckedRun> check_runs(const Sweep& sweep);

} // namespace quicksand
