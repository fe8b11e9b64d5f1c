// Sums over the whole body that tell whether a run is sane: mass, momentum, energy, extremes.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

struct Monitors {
    double mass_solid = 0.0; // [kg/m]
    double mass_fluid = 0.0; // [kg/m]
    double volume = 0.0;     // [m3/m]
    double momentum_x = 0.0; // of both phases [N s/m]
    double momentum_y = 0.0;
    double kinetic_energy = 0.0;           // of both phases [J/m]
    double kinetic_energy_fluid = 0.0;     // of the water [J/m]
    double max_velocity = 0.0;             // of the grains [m/s]
    double max_displacement = 0.0;         // since the reference [m]
    double max_excess_pore_pressure = 0.0; // over the water at the start [Pa]
    double max_ru = 0.0;           // largest excess pore pressure / initial vertical effective stress [-]
    double crest_settlement = 0.0; // mean of the particles that lay highest, downward positive [m]
};

/// Lasting numbers of the particles of the highest layer of the soil as sampled: the crest.
std::vector<std::int32_t> crest_particles(const Particles& particles);

/// r_u is left out below this initial vertical effective stress, the weight of half a cell of water: so close
/// to the surface the ratio says more about the cells than about the soil [Pa].
double ru_stress_threshold(const Problem& problem);

Monitors monitor(const Problem& problem, const State& state, const std::vector<std::int32_t>& crest);

/// The kinetic energy of both phases alone [J/m].
double kinetic_energy(const Problem& problem, const Particles& particles);

} // namespace quicksand
