// How fast waves run through a material.
#pragma once

#include "solver/problem/problem.hpp"

#include <optional>

namespace quicksand {

struct WaveSpeeds {
    double undrained = 0.0; // c_u, P wave with grains and water moving together [m/s]
    double fast = 0.0;      // c_1, P wave without drag between grains and water [m/s]
    double slow = 0.0;      // c_2, slow P wave without drag [m/s]
    double skeleton = 0.0;  // P wave of the drained skeleton carrying the water's mass [m/s]
    double shear = 0.0;     // shear wave of the mixture [m/s]
};

/// Wave speeds at a porosity; without water only `skeleton` and `shear` of the dry soil differ from zero.
/// method: eigenvalues of R^-1 K of the drag-free two-phase P wave (Biot).
WaveSpeeds wave_speeds(const Material& material, const std::optional<Water>& water, double porosity);

/// The same with the skeleton's present P-wave modulus M [Pa].
WaveSpeeds wave_speeds(const Material& material, double skeleton_modulus, const std::optional<Water>& water,
                       double porosity);

/// The fastest wave in the form of the equations that the problem asks for [m/s].
double fastest_speed(const Problem& problem, const WaveSpeeds& speeds);

} // namespace quicksand
