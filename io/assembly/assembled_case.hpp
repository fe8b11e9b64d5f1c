// A scene and what it has become on its drawing.
#pragma once

#include "geometry/sampling/particle_sampler.hpp"
#include "geometry/section/section.hpp"
#include "io/assembly/initial_flow.hpp"
#include "io/assembly/interface_layers.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/scene/scene_file.hpp"
#include "io/tables/scene.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <optional>
#include <string>
#include <vector>

namespace quicksand {

struct AssembledCase {
    Scene scene; // probes have their places
    Problem problem;
    State state;
    Section section;
    std::vector<std::string> grid_reasons;   // what was chosen of the grid and why, lines for the user
    std::vector<WaterLine> water_lines;      // at which particles are parted
    Sampling sampling;                       // its domains have become the particles
    std::vector<InterfaceLayer> interfaces;  // of the scene, with what they have become
    std::optional<InitialFlow> initial_flow; // of the ground water, where it flows at the start
    Diagnostics warnings;                    // of the scene and of the assembly
};

} // namespace quicksand
