// Random conditions on the curves of a random section.
#pragma once

#include "app/stress/scenes/random_section.hpp"
#include "app/stress/scenes/scene_draft.hpp"

#include <string>

namespace quicksand {

/// What the walls are made for.
struct WallPurpose {
    double duration = 0.0;     // of the run [s]
    double pressure = 0.0;     // that of the soil at the base [Pa]
    double water_level = 0.0;  // [m]
    bool has_pressure = false; // water with an excess pressure
    bool is_submerged = false; // all of the section
};

/// Walls below and at the sides, loads and heads on the surface.
void set_random_walls(const RandomSection& section, const WallPurpose& purpose, RandomNumbers& random,
                      SceneDraft& scene);

} // namespace quicksand
