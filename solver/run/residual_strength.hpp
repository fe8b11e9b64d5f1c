// The undrained strength that liquefied sand keeps, for the stability of a slope after an earthquake.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstddef>

namespace quicksand {

/// S_r = ratio sigma'_v0 where ru has reached a limit, without friction. Ratios are read from back-analysed
/// failures by blow count, for example in Idriss and Boulanger (2008), Soil Liquefaction During Earthquakes.
struct ResidualStrength {
    double ratio = 0.0;        // S_r / sigma'_v0 [-]
    double liquefied_ru = 0.8; // least ru of liquefied sand [-]
};

/// Let saturated soil whose ru, at present, is that of liquefied sand have its residual strength: it becomes
/// a material of its own, in steps of strength of 5 %. Returns the number of its particles.
std::size_t give_residual_strength(const ResidualStrength& residual, Problem& problem, State& state);

} // namespace quicksand
