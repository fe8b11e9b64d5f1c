// All the writers of a run's results, ready to be handed to run().
#pragma once

#include "io/tables/scene.hpp"
#include "solver/run/simulation.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace quicksand {

struct OutputSettings {
    std::filesystem::path directory; // prepared by prepare_results_folder()
    std::string scene_hash;          // as in the manifest
    std::string state_hash;          // as in the checkpoint
    bool resume = false;             // continue the files at state.time instead of beginning them
    const State* kept = nullptr;     // what checkpoints hold; none: the state shown to the observers
};

/// Writers of fields.pvd, grid.pvd, probes/*.csv, history.csv, steps.csv and checkpoint/state.h5, at the
/// intervals of scene.output; an interval of zero leaves that writer out. Call it when shaking is about to
/// begin (or to go on) and every probe has a place. The observers look at `problem` and `state`, which must
/// outlive them and be the ones given to run(). Frames and checkpoints are written in the background. Throws
/// InputError for a probe outside the soil and FileError.
std::vector<std::unique_ptr<Observer>> make_output_observers(const Scene& scene, const Problem& problem,
                                                             const State& state,
                                                             const OutputSettings& settings);

} // namespace quicksand
