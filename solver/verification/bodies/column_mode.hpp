// Standing plane waves of a saturated column above a fixed impervious base, as initial states of a run and as
// what is measured of it. With the height y above the base,
//   (v_s, v_w) = (a, b) sin(xi y) e^{s t},   (sigma', p) = (c, d) cos(xi y) e^{s t};
// xi = pi / (2 H) under a free and drained top, xi = m pi / H under a wall.
#pragma once

#include "solver/problem/state.hpp"
#include "solver/verification/bodies/layer.hpp"
#include "solver/verification/solutions/biot_dispersion.hpp"

#include <Eigen/Core>

namespace quicksand {

/// Amplitudes a, b [m/s] and c, d [Pa].
using ModeAmplitudes = Eigen::Vector4cd;

/// Matrix of d/dt (a, b, c, d) at a real wave number: both momentum balances, Hooke's law, storage of water.
Eigen::Matrix4d longitudinal_rates(const SaturatedSoil& soil, double wave_number);

/// The four modes of a wave number; amplitudes in SI.
struct LongitudinalShapes {
    Eigen::VectorXcd s;      // complex frequencies [1/s]
    Eigen::MatrixXcd shapes; // eigenvectors a, b, c, d, a column each
    Eigen::MatrixXcd duals;  // a row each, the inverse of the shapes
    Eigen::Vector4d scale;   // of the amplitudes: 1 Pa, and the velocity that goes with it
};
LongitudinalShapes longitudinal_shapes(const SaturatedSoil& soil, double wave_number);

struct ColumnMode {
    double base = 0.0;        // y of the base [m]
    double wave_number = 0.0; // xi [1/m]
    Complex s;                // complex frequency [1/s]
    ModeAmplitudes shape;     // eigenvector, largest pressure 1 Pa
    ModeAmplitudes dual;      // dual^T y is the mode's part in amplitudes y, 1 for the shape itself
};

/// The mode of this wave number whose complex frequency is nearest to `s`.
ColumnMode column_mode(const Layer& layer, double wave_number, Complex s);

/// Give particles at rest the velocities, stresses and pressures of Re(mode).
void start_mode(const ColumnMode& mode, Particles& particles);

/// The same of any amplitudes a, b [m/s], c, d [Pa] of the mode's wave number.
void start_amplitudes(const ColumnMode& mode, const Eigen::Vector4d& amplitudes, Particles& particles);

/// Part of the mode in a state before its first step, by projection of the particles on sin and cos of their
/// reference height [-]; 1 for Re(shape) of a mode that does not travel, 1/2 of the shape and its conjugate
/// otherwise.
Complex measure_start(const ColumnMode& mode, const Particles& particles);

/// The same in a run under way. Its velocities stand half a step before the stresses: they are taken as the
/// mean of them and of those after one step more.
Complex measure_mode(const Problem& problem, const ColumnMode& mode, State state);

/// Complex frequency of the mode from runs of `state` at rest, one from each of the four amplitudes alone:
/// their changes over one part of `duration` are taken to those over the next by a matrix, of whose
/// eigenvalues the one nearest to the mode's tells its frequency. What the start has besides the grid's own
/// waves of this number then does not count, nor how nearly parallel two modes are [1/s].
Complex propagated_frequency(const Problem& problem, const Layer& layer, const ColumnMode& mode,
                             const State& state, double duration);

/// Complex frequency measured over a duration in which the part went from `before` to `after`; its phase is
/// taken nearest to the exact one's [1/s].
Complex measured_frequency(const ColumnMode& mode, Complex before, Complex after, double duration);

} // namespace quicksand
