// Patch tests of the boundaries of a sampled section (Irons and Razzaque
// 1972).
//
// A pressure in the soil is in equilibrium with walls and with the same pressure on all other curves. The
// force that remains at the nodes along a curve accelerates soil that should be at rest. It measures how well
// domains, curves and walls fit.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// Sum of the unbalanced forces at the nodes along a curve over the sum of the forces on it.
struct PatchTest {
    std::string boundary;           // as Problem::boundaries; "" for the edges without a name
    double constant_pressure = 0.0; // of one pressure everywhere [-]
    double geostatic = 0.0; // of one that grows with depth and bears the weight, over that at the bottom [-]
};

/// The tests of all boundaries on the state's shape, in their order, and of the rest of the rim where there
/// is one.
std::vector<PatchTest> test_patches(const Problem& problem, const State& state);

} // namespace quicksand
