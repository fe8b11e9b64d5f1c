// How well the boundaries of a sampled section hold what they have to hold: patch tests (Irons and Razzaque
// 1972).
//
// A pressure in the soil is in balance with walls and with the same pressure on all other curves. What of it
// the nodes along a curve leave unbalanced accelerates soil that should rest: it tells whether domains,
// curves and walls fit.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// Forces that nodes along a curve leave unbalanced, summed up, over those that it bears.
struct PatchTest {
    std::string boundary;           // as Problem::boundaries; "" for the edges without a name
    double constant_pressure = 0.0; // of one pressure everywhere [-]
    double geostatic = 0.0; // of one that grows with depth and bears the weight, over that at the bottom [-]
};

/// The tests of all boundaries on the state's shape, in their order, and of the rest of the rim where there
/// is one.
std::vector<PatchTest> test_patches(const Problem& problem, const State& state);

} // namespace quicksand
