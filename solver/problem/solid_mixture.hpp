// A solid without pore water (concrete, rock, steel) as the mixture that moves like it.
//
// Grains and water of a mixture whose conductivity is almost zero have one velocity, so that porosity and
// grain density act by their sum alone: with n rho_w + (1-n) rho_s = rho it has the density of the solid, and
// with the static pressure on both phases its buoyancy and the outer pressure of the water. Nothing flows
// through it. The water of the mixture has no pressure beyond the static one: it takes no part in the change
// of pressure of its cell (is_wet()), so that a solid has the stiffness of its law alone. Nodes that a solid
// shares with soil are sealed (solid_seals.hpp), and soil beside it presses on it with the pressure of its
// water.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/wave_speeds.hpp"

#include <optional>
#include <vector>

namespace quicksand {

/// Make a material of a density [kg/m3] a solid without pores, whose mixture is that of the scene's water;
/// its law stays. Above the water, where it has no water to share its mass with, a solid is one that is full
/// of water that moves with the grains: saturation 1.
void make_solid(double density, const std::optional<Water>& water, Material& material);

/// Let no wave of the skeleton be faster in solids than the fastest in soil, by `fastest`, as by
/// fastest_waves() for the materials of the problem. For loads that soil can bear at most, on which the
/// stiffness of an elastic part has no influence.
void soften_solids(const std::vector<WaveSpeeds>& fastest, Problem& problem);

} // namespace quicksand
