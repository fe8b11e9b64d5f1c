// The largest stable time step and what limits it.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/problem/wave_speeds.hpp"
#include "solver/step_length/time_step.hpp"

#include <vector>

namespace quicksand {

/// The speeds of every material in the cell where the present stress makes it stiffest, at its initial
/// porosity; as without particles where there are none of it.
std::vector<WaveSpeeds> fastest_waves(const Problem& problem, const Particles& particles);

/// In which the fastest wave crosses the body, where water flows through it; else 0 [s].
double sound_time(const Problem& problem, const Particles& particles);

/// Step of the shaking [s]: problem.step_fraction of min(0.65 h / fastest_speed(...), 0.2 h / max|v|). With
/// the semi-implicit scheme 0.72 of the least over the materials of
///   slow P wave   (4 M / h^2) dt^2 = 4 m + X / n^2,  m = r_s + ((1-n)/n)^2 r_w
///   shear wave    (4 G / h^2) dt^2 = 4 r_s + 4 r_w X / (4 r_w + X), and 0.85 of it
/// (r_s = (1-n) rho_s, r_w = n rho_w, X = 2 max(0, dt C - r_s r_w / (r_s + r_w)), C the drag) in its place.
/// In the implicit scheme accuracy limits the step, see accuracy_control.hpp. `scale` is the part of the
/// limit that vibrations of the nodes and the watchdog leave, see State::step_scale [-].
TimeStep stable_time_step(const Problem& problem, const State& state, double scale = 1.0);

/// That of the first step from particles.
TimeStep stable_time_step(const Problem& problem, const Particles& particles, double scale = 1.0);

/// Largest stable step of the drained relaxation stage [s].
TimeStep stable_relaxation_step(const Problem& problem, const Particles& particles);

} // namespace quicksand
