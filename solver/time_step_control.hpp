// The largest stable time step and what limits it.
#pragma once

#include "solver/problem.hpp"
#include "solver/state.hpp"

#include <string>
#include <vector>

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

/// The speeds of every material in the cell where the present stress makes it stiffest, at its initial
/// porosity; as without particles where there are none of it.
std::vector<WaveSpeeds> fastest_waves(const Problem& problem, const Particles& particles);

/// The fastest wave in the form of the equations that the problem asks for [m/s].
double fastest_speed(const Problem& problem, const WaveSpeeds& speeds);

enum class TimeStepLimiter { wave, motion, output };

struct TimeStep {
    double dt = 0.0;                                 // [s]
    TimeStepLimiter limiter = TimeStepLimiter::wave; // why it is not larger
    std::string material;                            // whose wave limits it
};

/// Step of the shaking [s]: problem.step_share of min(0.65 h / fastest_speed(...), 0.2 h / max|v|). With the
/// semi-implicit scheme 0.72 of the least over the materials of
///   slow P wave   (4 M / h^2) dt^2 - (2 C / n^2) dt - 4 m = 0,  m = r_s + ((1-n)/n)^2 r_w
///   shear wave    (4 G / h^2) dt^2 = 4 r_s + 2 dt C - (2 dt C)^2 / (4 r_w + 2 dt C), and 0.85 of it
/// (r_s = (1-n) rho_s, r_w = n rho_w, C the drag) stands in the place of the first.
TimeStep stable_time_step(const Problem& problem, const Particles& particles);

/// Largest stable step of the drained relaxation stage [s].
TimeStep stable_relaxation_step(const Problem& problem, const Particles& particles);

const char* name_of(TimeStepLimiter limiter);

} // namespace quicksand
