// Level ground that has liquefied, after an hour of drainage: its water has left, so that each row of
// particles carries the weight above it, wherever it lies in the cells. Liquefied layers settle by per cents,
// and the strain of a row across the border of two cells is between theirs.
#include "solver/ubcsand/ubcsand_parameters.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <ostream>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double ground = 10.0; // height [m]

struct Place {
    int per_cell;
    double cell;  // [m]
    double shift; // of the grid downwards [m]
    double most;  // of the rows' mean vertical stresses from the weight above, rms [-]
};

std::ostream& operator<<(std::ostream& out, const Place& place)
{
    return out << place.per_cell << " a cell of " << place.cell << " m, " << place.shift << " m below";
}

/// 20 cycles of 0.2 g at 2 Hz, with linear rise and fall over 3 cycles: the base ends at rest.
SampledMotion shaking()
{
    SampledMotion motion;
    motion.interval = 0.005;
    for (int k = 0; k <= 2000; ++k) {
        const double cycle = 2.0 * motion.interval * k;
        const double ramp = std::min({1.0, cycle / 3.0, (20.0 - cycle) / 3.0});
        motion.accelerations.push_back(0.2 * standard_gravity * ramp *
                                       std::sin(2.0 * std::numbers::pi * cycle));
    }
    return motion;
}

Problem level_ground(const Place& place)
{
    Problem problem;
    problem.scheme = TimeScheme::implicit;
    const int rows = static_cast<int>(std::ceil((ground + 1.0 + place.shift) / place.cell));
    const int beside = static_cast<int>(1.0 / place.cell); // columns, for the ground sways
    problem.grid = {{-1.0, -place.shift}, place.cell, 3 + 2 * beside, rows};
    Material sand = stiff_sand();
    sand.law = make_ubcsand(with(UbcSandRunSettings(), calibrated(ubcsand_from_blow_count(10.0))));
    sand.grain_density = 2670.0;
    sand.porosity = 0.42;
    problem.materials = {sand};
    problem.water = water_to(ground);
    const double width = 3.0 * place.cell;
    problem.boundaries = rectangle(0.0, 0.0, width, ground, FixedWall{}, TiedSide{}, FreeFace{});
    problem.tied_sides = TiedSides{"left", "right", 0.0, width};
    problem.base_motion = shaking();
    return problem;
}

/// Of what lies deeper than half a metre: nearer to the surface its shape counts.
struct Reconsolidation {
    double liquefied = 0.0;    // part of the particles that have liquefied once [-]
    double of_rows = 0.0;      // mean vertical stresses of rows from the weight above them, rms [-]
    double of_particles = 0.0; // the same of particles [-]
    double settlement = 0.0;   // of the topmost row [m]
};

struct RowMean {
    double sum = 0.0, particles = 0.0;
    void add(double value) { sum += value, particles += 1.0; }
    double mean() const { return sum / particles; }
};

Reconsolidation measure(const Problem& problem, const Particles& particles)
{
    const Scalars &heights = particles.reference_position.y,
                  &liquefied =
                      particles.memory[column_of(memory_of(problem.materials[0].law), "liquefied_shear")];
    const double highest = *std::max_element(heights.begin(), heights.end());
    std::map<double, RowMean> rows; // by the height before the shaking
    RowMean once, squares, settled;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        once.add(liquefied[p] > 0.0 ? 1.0 : 0.0);
        if (heights[p] > highest - 1e-9) settled.add(heights[p] - particles.position.y[p]);
        const double weight = particles.initial_vertical_effective_stress[p];
        if (weight < 4e3) continue; // Pa
        const double ratio = -particles.stress.yy[p] / weight;
        squares.add(std::pow(ratio - 1.0, 2));
        rows[heights[p]].add(ratio);
    }
    RowMean squares_of_rows;
    for (const auto& [height, row] : rows) squares_of_rows.add(std::pow(row.mean() - 1.0, 2));
    return {once.mean(), std::sqrt(squares_of_rows.mean()), std::sqrt(squares.mean()), settled.mean()};
}

Reconsolidation reconsolidate(const Place& place)
{
    const Problem problem = level_ground(place);
    Problem lattice = problem; // from the base on, wherever the grid lies
    lattice.grid.origin = {0.0, 0.0};
    const double width = 3.0 * place.cell;
    State state =
        fill(lattice, place.per_cell, [&](const Vector2& x) { return x.x() < width && x.y() < ground; });
    set_level_ground_stress(problem, ground, 0.5, state);
    begin_shaking(problem, state);
    run(problem, 3600.0, {}, state);
    return measure(problem, state.particles);
}

// Columns of cells become unlike as rounding grows in liquefied sand; the means of rows do not. On cells of
// 0.25 m the lowest row may be stiff while the others of its cells settle as liquefied: it then bears more.
// With eight motions that differ by 1e-10 g the surface settled by 0.063 to 0.110 m in 40 runs, 0.084 in
// their mean with a standard deviation of 0.010, and by 0.080 to 0.090 m in the mean of the five places;
// particles scattered by 0.09 to 0.19 in that mean. The bounds are three standard deviations, 0.003 for that
// mean.
TEST(Reconsolidation, BringsEveryRowBackToTheWeightAboveIt)
{
    const Place places[] = {{2, 0.5, 0.0, 0.015},
                            {3, 0.5, 0.0, 0.015},
                            {4, 0.5, 0.0, 0.015},
                            {3, 0.5, 0.13, 0.015},
                            {3, 0.25, 0.0, 0.1}};
    RowMean scatter, settlement;
    for (const Place& place : places) {
        const Reconsolidation found = reconsolidate(place);
        EXPECT_GT(found.liquefied, 0.8) << place;
        EXPECT_LT(found.of_rows, place.most) << place;
        EXPECT_NEAR(found.settlement, 0.084, 0.03) << place;
        scatter.add(found.of_particles);
        settlement.add(found.settlement);
    }
    EXPECT_LT(scatter.mean(), 0.2);
    EXPECT_NEAR(settlement.mean(), 0.084, 0.009);
}

} // namespace
} // namespace quicksand
