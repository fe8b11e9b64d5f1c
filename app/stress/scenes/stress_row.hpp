// One row of the stability laboratory: a scene, and what the laboratory does to it beyond what its keys say.
#pragma once

#include "solver/base/conventions.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace quicksand {

struct StressRow {
    std::string group;                  // of the designed set: "steps"
    std::string name;                   // in the group, a word for files: "explicit-1.25"
    std::string drawing;                // text of section.geo
    std::string scene;                  // text of scene.toml
    double step_factor = 1.0;           // over the step that the scene asks for [-]
    Vector2 velocity = Vector2::Zero(); // of the soil at the start [m/s]
    double spin = 0.0;                  // about the middle of the soil at the start, anticlockwise [rad/s]
    bool measures_step = false;         // also finds the largest stable step
    double most_velocity = INFINITY;    // faster, something is wrong whatever the balances say [m/s]
    std::string twin = {};              // row of the same group that is to come to the same displacements

    std::string id() const { return group + "/" + name; }
    /// Whether `quicksand run` on the scene's files does the same.
    bool is_plain() const { return step_factor == 1.0 && spin == 0.0 && velocity == Vector2::Zero(); }
};

using StressRows = std::vector<StressRow>;

} // namespace quicksand
