// One-dimensional consolidation of a layer drained at its top (Terzaghi 1923): the depth ratio Z = z/H runs
// from 0 at the drained top to 1 at the impervious base; the time factor is T = c_v t / H^2.
#pragma once

#include "solver/verification/solutions/saturated_soil.hpp"

namespace quicksand {

/// p / p_0 after a uniform excess pressure p_0 at T = 0 [-].
double terzaghi_pressure_ratio(double depth_ratio, double time_factor);

/// Settlement of the point at a depth over the final settlement p_0 H / M of the surface [-]: the integral of
/// 1 - p/p_0 below the point, over H. At depth ratio 0 it is the degree of consolidation U.
double terzaghi_settlement_degree(double depth_ratio, double time_factor);

/// T = c_v t / H^2 [-].
double time_factor(const SaturatedSoil& soil, double height, double time);

} // namespace quicksand
