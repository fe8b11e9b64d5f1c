// How far soil moves under its weight while it is elastic: what slides goes far beyond.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// From the lowest to the highest particle as drawn [m].
double drawn_height(const Particles& particles);

/// G of the softest material [Pa].
double softest_shear_modulus(const Problem& problem);

/// Mean of 1/G over the volume at the present stress [1/Pa].
double mean_shear_compliance(const Problem& problem, const Particles& particles);

/// gamma H^2 / G of the softest material, gamma that of the grains alone: the size of elastic displacements
/// [m].
double elastic_displacement(const Problem& problem, const Particles& particles);

/// 2 int gamma (top - y)/G dy, G that of the softest soil at each height: gamma H^2 / G of one soil, and less
/// where a soft layer is thin [m].
double elastic_displacement_of_layers(const Problem& problem, const Particles& particles);

} // namespace quicksand
