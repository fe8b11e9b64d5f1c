// What a probe records at one moment, from a particle or from the nodal fields, and how it becomes a CSV row.
#pragma once

#include "io/files/csv_file.hpp"
#include "solver/measure/nodal_fields.hpp"
#include "solver/particles/particles.hpp"
#include "solver/problem/problem.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// Values of one point; NaN means none, as outside the soil.
struct ProbeSample {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    Vector2 position{none, none};            // [m]
    Vector2 displacement{none, none};        // since the start of shaking [m]
    Vector2 velocity{none, none};            // of the grains, relative to the base [m/s]
    Vector2 acceleration{none, none};        // relative to the base [m/s2]
    double pore_pressure = none;             // static plus excess [Pa]
    double excess_pore_pressure = none;      // [Pa]
    double ru = none;                        // [-]
    double mean_effective_stress = none;     // compression positive [Pa]
    double vertical_effective_stress = none; // compression positive [Pa]
    double shear_stress_xy = none;           // [Pa]
    double shear_strain_xy = none;           // du_x/dy + du_y/dx [-]
};

/// The particle's own values.
ProbeSample sample_particle(const Problem& problem, const Particles& particles, std::size_t p);

/// Bilinear values of the nodal fields at a point; only the position where there is no soil.
ProbeSample sample_point(const Problem& problem, const NodalFields& fields, const Vector2& point);

/// Column names and cells of a sample, without the leading time. A dry scene has no columns of the water.
std::vector<std::string> sample_columns(bool saturated);
void append_cells(const ProbeSample& sample, bool saturated, CsvRow& row);

} // namespace quicksand
