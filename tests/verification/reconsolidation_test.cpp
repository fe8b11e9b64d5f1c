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
    double cell;              // [m]
    double shift;             // of the grid downwards [m]
    double most;              // of the rows' mean vertical stresses from the weight above, rms [-]
    double most_of_particles; // the same of theirs: at most .15 in ten courses [-]
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

class ReconsolidationAt : public testing::TestWithParam<Place> {};

TEST_P(ReconsolidationAt, BringsEveryRowBackToTheWeightAboveIt)
{
    const Problem problem = level_ground(GetParam());
    Problem lattice = problem; // from the base on, wherever the grid lies
    lattice.grid.origin = {0.0, 0.0};
    const double width = 3.0 * GetParam().cell;
    State state =
        fill(lattice, GetParam().per_cell, [&](const Vector2& x) { return x.x() < width && x.y() < ground; });
    set_level_ground_stress(problem, ground, 0.5, state);
    begin_shaking(problem, state);
    run(problem, 3600.0, {}, state);
    const Particles& particles = state.particles;
    const std::size_t liquefied = column_of(memory_of(problem.materials[0].law), "liquefied_shear");
    struct Row {
        double ratio = 0.0, particles = 0.0;
    };
    std::map<double, Row> rows; // by the height before the shaking
    double squares = 0.0, of_particles = 0.0, count = 0.0, settled = 0.0;
    std::size_t once = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        once += particles.memory[liquefied][p] > 0.0 ? 1 : 0;
        settled = std::max(settled, particles.reference_position.y[p] - particles.position.y[p]);
        const double weight = particles.initial_vertical_effective_stress[p];
        if (weight < 4e3) continue; // half a metre, where the shape of the surface counts
        of_particles += std::pow(-particles.stress.yy[p] / weight - 1.0, 2);
        count += 1.0;
        Row& row = rows[particles.reference_position.y[p]];
        row.ratio += -particles.stress.yy[p] / weight;
        row.particles += 1.0;
    }
    for (const auto& [height, row] : rows) squares += std::pow(row.ratio / row.particles - 1.0, 2);
    const double error = std::sqrt(squares / static_cast<double>(rows.size()));
    RecordProperty("error", std::to_string(error));
    RecordProperty("settlement", std::to_string(settled));
    EXPECT_GT(static_cast<double>(once), 0.8 * static_cast<double>(particles.size()));
    EXPECT_LT(error, GetParam().most);
    EXPECT_LT(std::sqrt(of_particles / count), GetParam().most_of_particles);
    EXPECT_NEAR(settled, 0.078, 0.015);
}

// Columns of cells become unlike as rounding grows in liquefied sand; the means of rows do not. On cells of
// 0.25 m the lowest row may be stiff while the others of its cells settle as liquefied: it then bears more.
INSTANTIATE_TEST_SUITE_P(Places, ReconsolidationAt,
                         testing::Values(Place{2, 0.5, 0.0, 0.015, 0.2}, Place{3, 0.5, 0.0, 0.015, 0.2},
                                         Place{4, 0.5, 0.0, 0.015, 0.2}, Place{3, 0.5, 0.13, 0.015, 0.2},
                                         Place{3, 0.25, 0.0, 0.1, 0.2}));

} // namespace
} // namespace quicksand
