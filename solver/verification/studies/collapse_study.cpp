#include "solver/verification/studies/collapse_study.hpp"

#include "solver/base/failure.hpp"
#include "solver/run/simulation.hpp"
#include "solver/verification/solutions/column_collapse.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace quicksand {

namespace {

struct Column {
    Vector2 lower, upper; // [m]
    double wall = 0.0;    // x of the wall [m]

    double width() const { return upper.x() - lower.x(); }
    double height() const { return upper.y() - lower.y(); }
};

bool has_wall(const Problem& problem, double x)
{
    const double near = 1e-6 * problem.grid.cell_size;
    for (const Boundary& boundary : problem.boundaries) {
        if (!is_standing_wall(boundary.soil)) continue;
        for (const Segment& segment : boundary.segments) {
            if (std::abs(segment.start.x() - x) < near && std::abs(segment.end.x() - x) < near) return true;
        }
    }
    return false;
}

Column read_column(const Problem& problem, const State& state)
{
    const Particles& particles = state.particles;
    const Material& material = problem.materials[static_cast<std::size_t>(particles.material.front())];
    if (problem.water || !std::holds_alternative<MohrCoulomb>(material.law)) {
        throw InputError("the collapse needs a dry scene whose soil has the model mohr_coulomb");
    }
    Column column;
    column.lower.setConstant(std::numeric_limits<double>::infinity());
    column.upper = -column.lower;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 half = particles.half_edge_1[p].cwiseAbs() + particles.half_edge_2[p].cwiseAbs();
        column.lower = column.lower.cwiseMin(particles.position[p] - half);
        column.upper = column.upper.cwiseMax(particles.position[p] + half);
    }
    const bool left = has_wall(problem, column.lower.x()), right = has_wall(problem, column.upper.x());
    if (left == right) throw InputError("the collapse needs a wall on one side of the column");
    column.wall = left ? column.lower.x() : column.upper.x();
    return column;
}

/// Distance from the wall behind which all but a hundredth of the soil lies [m].
double front(const Column& column, const Particles& particles)
{
    std::vector<std::pair<double, double>> soil; // distance, volume
    double total = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        soil.emplace_back(std::abs(particles.position.x[p] - column.wall), particles.mass_solid[p]);
        total += particles.mass_solid[p];
    }
    std::sort(soil.begin(), soil.end());
    double ahead = 0.01 * total;
    while (soil.size() > 1 && ahead > soil.back().second) {
        ahead -= soil.back().second;
        soil.pop_back();
    }
    return soil.back().first;
}

/// Height of the soil within two cells of the wall [m].
double height_at_wall(const Problem& problem, const Column& column, const Particles& particles)
{
    double height = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (std::abs(particles.position.x[p] - column.wall) > 2.0 * problem.grid.cell_size) continue;
        const double half = std::abs(particles.half_edge_1.y[p]) + std::abs(particles.half_edge_2.y[p]);
        height = std::max(height, particles.position.y[p] + half - column.lower.y());
    }
    return height;
}

} // namespace

std::vector<StudyError> collapse_study(const Problem& problem, State state)
{
    const Column column = read_column(problem, state);
    const double aspect_ratio = column.height() / column.width();
    const auto runout = lube_runout_ratio(aspect_ratio);
    if (!runout)
        throw InputError("no law is published for columns between 1.8 and 2.8 times as high as wide");
    // the flow stops at 3.3 sqrt(h / g) (Lube and others 2005)
    run(problem, state.time + 5.0 * std::sqrt(column.height() / problem.gravity), {}, state);
    const double measured_runout = (front(column, state.particles) - column.width()) / column.width();
    const double measured_height = height_at_wall(problem, column, state.particles) / column.width();
    return {{"runout", "relative to the published law", std::abs(measured_runout / *runout - 1.0)},
            {"final height", "relative to the published law",
             std::abs(measured_height / lube_final_height_ratio(aspect_ratio) - 1.0)}};
}

} // namespace quicksand
