#include "io/results/probe_sample.hpp"

#include "io/frames/particle_quantities.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// du_x/dy + du_y/dx of the bilinear displacements in the point's cell [-].
double shear_strain(const BackgroundGrid& grid, const NodalFields& fields, const PointWeights& weights,
                    const Vector2& point)
{
    Vector2 centre = Vector2::Zero();
    for (const std::size_t node : weights.node) centre += 0.25 * grid.node_position(node);
    double strain = 0.0;
    for (const std::size_t node : weights.node) {
        // dN/dx = +-(1 - |y - y_i|/h)/h, dN/dy alike
        const Vector2 place = grid.node_position(node);
        const Vector2 share = Vector2::Ones() - (point - place).cwiseAbs() / grid.cell_size;
        const double slope_x = std::copysign(share.y() / grid.cell_size, place.x() - centre.x());
        const double slope_y = std::copysign(share.x() / grid.cell_size, place.y() - centre.y());
        strain += slope_y * fields.displacement.x[node] + slope_x * fields.displacement.y[node];
    }
    return strain;
}

} // namespace

ProbeSample sample_particle(const Problem& problem, const Particles& particles, std::size_t p)
{
    ProbeSample sample;
    sample.position = particles.position[p];
    sample.displacement = displacement(particles, p);
    sample.velocity = particles.velocity_solid[p];
    if (particles.has_fluid()) {
        sample.pore_pressure = total_pore_pressure(problem, particles, p);
        sample.excess_pore_pressure = risen_pore_pressure(problem, particles, p);
        sample.ru = excess_pressure_ratio(problem, particles, p);
    }
    sample.mean_effective_stress = mean_effective_stress(particles.stress, p);
    sample.vertical_effective_stress = -particles.stress.yy[p];
    sample.shear_stress_xy = particles.stress.xy[p];
    const Eigen::Matrix2d gradient = deformation_gradient(particles, p);
    sample.shear_strain_xy = gradient(0, 1) + gradient(1, 0);
    return sample;
}

ProbeSample sample_point(const Problem& problem, const NodalFields& fields, const Vector2& point)
{
    ProbeSample sample;
    sample.position = point;
    const PointWeights weights = point_weights(problem.grid, fields, point);
    if (!weights.inside) return sample;
    const auto at_point = [&](const Scalars& field) {
        double sum = 0.0;
        for (std::size_t k = 0; k < 4; ++k) sum += weights.weight[k] * field[weights.node[k]];
        return sum;
    };
    sample.displacement = {at_point(fields.displacement.x), at_point(fields.displacement.y)};
    sample.velocity = {at_point(fields.velocity_solid.x), at_point(fields.velocity_solid.y)};
    if (!fields.pore_pressure.empty()) {
        sample.pore_pressure = at_point(fields.pore_pressure);
        sample.excess_pore_pressure = at_point(fields.excess_pore_pressure);
        sample.ru = at_point(fields.ru);
    }
    sample.mean_effective_stress = at_point(fields.mean_effective_stress);
    sample.vertical_effective_stress = at_point(fields.vertical_effective_stress);
    sample.shear_stress_xy = at_point(fields.shear_stress_xy);
    sample.shear_strain_xy = shear_strain(problem.grid, fields, weights, point);
    return sample;
}

std::vector<std::string> sample_columns(bool saturated)
{
    std::vector<std::string> columns{"x_m", "y_m", "ux_m", "uy_m", "vx_m_s", "vy_m_s", "ax_m_s2", "ay_m_s2"};
    if (saturated) columns.insert(columns.end(), {"pore_pressure_Pa", "excess_pore_pressure_Pa", "ru"});
    columns.insert(columns.end(), {"mean_effective_stress_Pa", "vertical_effective_stress_Pa",
                                   "shear_stress_xy_Pa", "shear_strain_xy"});
    return columns;
}

void append_cells(const ProbeSample& sample, bool saturated, CsvRow& row)
{
    const auto append = [&](double value) { row.push_back(csv_number(value)); };
    for (const Vector2& vector :
         {sample.position, sample.displacement, sample.velocity, sample.acceleration}) {
        append(vector.x());
        append(vector.y());
    }
    if (saturated) {
        append(sample.pore_pressure);
        append(sample.excess_pore_pressure);
        append(sample.ru);
    }
    append(sample.mean_effective_stress);
    append(sample.vertical_effective_stress);
    append(sample.shear_stress_xy);
    append(sample.shear_strain_xy);
}

} // namespace quicksand
