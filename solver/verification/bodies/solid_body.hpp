// A dry rectangular body of one neo-Hookean material, as the studies of solids find it in a scene.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/soil/neo_hookean.hpp"

namespace quicksand {

struct SolidBody {
    NeoHookean law;
    double density = 0.0;                                     // (1-n) rho_s [kg/m3]
    Vector2 lower = Vector2::Zero(), upper = Vector2::Zero(); // corners of its bounding box [m]
};

/// The body that the particles fill. Throws InputError where the problem is saturated or has another law.
SolidBody read_neo_hookean_body(const Problem& problem, const State& state);

} // namespace quicksand
