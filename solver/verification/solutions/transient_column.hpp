// Saturated columns loaded from rest at their drained top.
#pragma once

#include "solver/verification/solutions/column_response.hpp"

#include <vector>

namespace quicksand {

/// A column of finite height with compressible water, at rest until its top is loaded by
///   q(t) = q/2 [1 - cos(pi t / t_r)] until t_r, then q.
struct TransientColumn {
    SaturatedSoil soil;
    double height = 1.0;        // H [m]
    double load = 1.0;          // q [Pa]
    double ramp_duration = 0.0; // t_r > 0 [s]
};

struct ColumnMotion {
    double displacement_solid = 0.0; // positive upward [m]
    double displacement_fluid = 0.0; // positive upward [m]
    double pore_pressure = 0.0;      // [Pa]
};

/// Motion at a height x above the base at each of the times [s], by the inverse Laplace transform of the
/// column's response (Fourier series of Durbin 1974). Accurate to about 1e-8 of the load and of its drained
/// settlement; the cost grows with the largest time over the ramp.
std::vector<ColumnMotion> column_motion(const TransientColumn& column, double x,
                                        const std::vector<double>& times);

/// A load linear between times and constant after the last one, both from zero at t = 0 [s], [Pa].
struct LoadPolygon {
    std::vector<double> times, values;
};

/// The same motion for another load. Its accuracy follows the kinks of the load: about 1e-4 of it for a
/// single linear ramp, 1e-6 for a finely sampled smooth one.
std::vector<ColumnMotion> column_motion(const SaturatedSoil& soil, double height, const LoadPolygon& load,
                                        double x, const std::vector<double>& times);

} // namespace quicksand
