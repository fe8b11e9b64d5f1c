#include "io/results/output_names.hpp"

namespace quicksand {

std::vector<std::string> output_names(const Scene& scene)
{
    std::vector<std::string> names;
    if (scene.output.frame_interval > 0.0) names.insert(names.end(), {"fields.pvd", "grid.pvd"});
    if (scene.output.probe_interval > 0.0)
        for (const SceneProbe& probe : scene.probes) names.push_back("probes/" + probe.name + ".csv");
    if (scene.output.history_interval > 0.0) names.insert(names.end(), {"history.csv", "steps.csv"});
    if (scene.output.checkpoint_interval > 0.0) names.emplace_back("checkpoint/state.h5");
    return names;
}

} // namespace quicksand
