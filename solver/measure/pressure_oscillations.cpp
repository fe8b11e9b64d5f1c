#include "solver/measure/pressure_oscillations.hpp"

#include "solver/base/slope_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

/// Means of a quantity over the cells; zero volume where there are no particles.
struct CellField {
    Scalars volume, mean;
    Vectors centre;
};

std::size_t cell_of(const BackgroundGrid& grid, const Vector2& position)
{
    const Vector2 cells = grid.cells_from_rim(position);
    const auto column = static_cast<std::size_t>(std::clamp<double>(cells.x(), 0.0, grid.all_cells_x() - 1));
    const auto row = static_cast<std::size_t>(std::clamp<double>(cells.y(), 0.0, grid.all_cells_y() - 1));
    return row * static_cast<std::size_t>(grid.all_cells_x()) + column;
}

/// Means over the cells of value(p).
template <class Value>
CellField cell_field(const BackgroundGrid& grid, const Particles& particles, Value&& value)
{
    const std::size_t count = grid.cell_count();
    CellField field{Scalars(count), Scalars(count), {Scalars(count), Scalars(count)}};
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const std::size_t c = cell_of(grid, particles.position[p]);
        const double V = particles.volume[p];
        field.volume[c] += V;
        field.mean[c] += V * value(p);
        field.centre.set(c, field.centre[c] + V * particles.position[p]);
    }
    for (std::size_t c = 0; c < count; ++c) {
        if (field.volume[c] == 0.0) continue;
        field.mean[c] /= field.volume[c];
        field.centre.set(c, field.centre[c] / field.volume[c]);
    }
    return field;
}

/// |sum (-1)^(i+j) f_c V_c| / sum |f_c| V_c, zero where the mean of |f| is below `least`.
double checkerboard(const BackgroundGrid& grid, const CellField& field, double least)
{
    const auto columns = static_cast<std::size_t>(grid.all_cells_x());
    double alternating = 0.0, total = 0.0, volume = 0.0;
    for (std::size_t c = 0; c < field.mean.size(); ++c) {
        const double sum = field.mean[c] * field.volume[c];
        alternating += (c / columns + c % columns) % 2 == 0 ? sum : -sum;
        total += std::abs(sum);
        volume += field.volume[c];
    }
    return total > least * volume ? std::abs(alternating) / total : 0.0;
}

/// Gradients of the field over its cells, from the up to eight neighbours that hold soil.
Vectors cell_slopes(const BackgroundGrid& grid, const CellField& field)
{
    const int columns = grid.all_cells_x(), rows = grid.all_cells_y();
    Vectors slopes{Scalars(field.mean.size()), Scalars(field.mean.size())};
    for (int j = 1; j + 1 < rows; ++j) {
        for (int i = 1; i + 1 < columns; ++i) {
            const auto c = static_cast<std::size_t>(j * columns + i);
            if (field.volume[c] == 0.0) continue;
            PlaneFit fit;
            for (int k = 0; k < 9; ++k) {
                const auto other = static_cast<std::size_t>((j + k / 3 - 1) * columns + i + k % 3 - 1);
                if (other == c || field.volume[other] == 0.0) continue;
                fit.add(weight_of_soil(field.volume[other], field.volume[c]),
                        field.centre[other] - field.centre[c], field.mean[other] - field.mean[c]);
            }
            slopes.set(c, fit.slope(grid.cell_size));
        }
    }
    return slopes;
}

/// sum V |f_p - plane| / sum V |f_p|
template <class Value>
double scatter(const BackgroundGrid& grid, const Particles& particles, const CellField& field, double least,
               Value&& value)
{
    const Vectors slopes = cell_slopes(grid, field);
    double apart = 0.0, total = 0.0, volume = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const std::size_t c = cell_of(grid, particles.position[p]);
        const double plane = field.mean[c] + slopes[c].dot(particles.position[p] - field.centre[c]);
        apart += particles.volume[p] * std::abs(value(p) - plane);
        total += particles.volume[p] * std::abs(value(p));
        volume += particles.volume[p];
    }
    return total > least * volume ? apart / total : 0.0;
}

constexpr double negligible = 1e-3; // part of a stress [-]

/// A thousandth of the weight of half a cell, at the density of soil or water [Pa].
double negligible_pressure(const Problem& problem, double density)
{
    return std::max(negligible * 0.5 * problem.grid.cell_size * density * problem.gravity,
                    std::numeric_limits<double>::min());
}

/// The mean shear stress [Pa]: pure shear has no mean stress but that of rounding.
double mean_shear(const Particles& particles, double volume)
{
    const SymmetricTensors& stress = particles.stress;
    double sum = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p)
        sum += particles.volume[p] * std::hypot(0.5 * (stress.xx[p] - stress.yy[p]), stress.xy[p]);
    return volume > 0.0 ? sum / volume : 0.0;
}

} // namespace

PressureOscillations measure_pressure_oscillations(const Problem& problem, const Particles& particles)
{
    const BackgroundGrid& grid = problem.grid;
    const SymmetricTensors& stress = particles.stress;
    const auto mean_stress = [&](std::size_t p) {
        return -(stress.xx[p] + stress.yy[p] + stress.zz[p]) / 3.0;
    };
    double mass = 0.0, volume = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        mass += particles.mass_solid[p];
        volume += particles.volume[p];
    }
    PressureOscillations oscillations;
    const double least = std::max(negligible_pressure(problem, volume > 0.0 ? mass / volume : 0.0),
                                  negligible * mean_shear(particles, volume));
    const CellField field = cell_field(grid, particles, mean_stress);
    oscillations.mean_stress_checkerboard = checkerboard(grid, field, least);
    oscillations.mean_stress_scatter = scatter(grid, particles, field, least, mean_stress);
    if (!particles.pore_pressure.empty()) {
        const auto pressure = [&](std::size_t p) { return particles.pore_pressure[p]; };
        oscillations.pore_pressure_checkerboard =
            checkerboard(grid, cell_field(grid, particles, pressure),
                         negligible_pressure(problem, problem.water ? problem.water->density : 0.0));
    }
    return oscillations;
}

} // namespace quicksand
