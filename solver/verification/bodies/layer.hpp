// A horizontal layer of one soil, as the studies of columns find it in a problem and its state.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/verification/solutions/saturated_soil.hpp"

#include <functional>

namespace quicksand {

struct Layer {
    SaturatedSoil soil;
    double base = 0.0; // y of its lower face [m]
    double top = 0.0;  // y of its upper face [m]

    double height() const { return top - base; } // H [m]
};

/// The layer that the particles fill. Throws InputError where the problem is dry, has more than one material
/// or one that is not linear elastic.
Layer read_layer(const Problem& problem, const State& state);

/// The soil of a linear elastic material under water. Throws InputError for another law.
SaturatedSoil read_soil(const Material& material, const Water& water);

/// Whether a wall, fixed or roller and impervious, lies along a face at height y.
bool is_closed(const Problem& problem, double y);

/// The load on the face at height y; null without.
const SurfaceLoad* surface_load(const Problem& problem, double y);

/// The downward load on the face at height y and a time, zero without one [Pa].
double load_on(const Problem& problem, double y, double time);

/// The part of a load normal to a face with this outward normal, positive onto the soil. Throws InputError
/// for a load with a ramp or a history [Pa].
double steady_load(const SurfaceLoad& load, const Vector2& outward);

/// The same of a load that stands from the start. Throws InputError for one with a ramp or a history.
double steady_load_on(const Problem& problem, double y);

/// sqrt(sum V_p (value(p) - exact(p))^2 / sum V_p), by the particles' volumes.
double root_mean_square(const Particles& particles, const std::function<double(std::size_t)>& difference);

/// The particle that lay highest at the reference; its displacement tells of the surface.
std::size_t highest_particle(const Particles& particles);

} // namespace quicksand
