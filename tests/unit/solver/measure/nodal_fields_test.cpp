#include "solver/measure/nodal_fields.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace quicksand {

namespace {

/// Soil in 4 x 3 cells of 0.5 m.
struct Block {
    Problem problem;
    State state;

    Block()
    {
        problem.grid = {{1.0, 2.0}, 0.5, 4, 3};
        problem.materials = {fixtures::stiff_sand()};
        problem.strain = StrainForm::small;
        state = fixtures::fill(problem, 2, [](const Vector2&) { return true; });
    }

    double averaged_volume() const
    {
        const Scalars volume = nodal_fields(problem, state.particles).volume;
        return std::accumulate(volume.begin(), volume.end(), 0.0);
    }
};

} // namespace

// The mean of the particles at a surface is that of a place a third of a cell below it.
TEST(NodalFields, AreExactForLinearFieldsAtTheRimOfTheSoilToo)
{
    const auto velocity = [](const Vector2& x) { return Vector2(0.3 + 2.0 * x.x() - x.y(), 4.0 * x.y()); };
    for (const double top : {3.5, 3.375, 3.25}) { // on lines and within a cell
        Block block;
        block.state = fixtures::fill(block.problem, 4, [&](const Vector2& x) { return x.y() < top; });
        Particles& particles = block.state.particles;
        for (std::size_t p = 0; p < particles.size(); ++p)
            particles.velocity_solid.set(p, velocity(particles.position[p]));
        const NodalFields fields = nodal_fields(block.problem, particles);
        const BackgroundGrid& grid = block.problem.grid;
        const NodalField& found = *fields.find("velocity_solid");
        std::size_t count = 0;
        for (std::size_t node = 0; node < grid.node_count(); ++node) {
            const Vector2 x = grid.node_position(node);
            if (!(fields.volume[node] > 0.0)) continue;
            EXPECT_NEAR(found.components[0][node], velocity(x).x(), 1e-12) << x.transpose();
            EXPECT_NEAR(found.components[1][node], velocity(x).y(), 1e-12) << x.transpose();
            ++count;
        }
        EXPECT_EQ(count, 20U);
        const Vector2 surface(1.6, top); // on a grid line, above which there is no soil, or within a cell
        const NodalFields there = nodal_fields_at(block.problem, particles, {surface});
        for (std::size_t node = 0; node < grid.node_count(); ++node)
            if (there.volume[node] > 0.0) {
                EXPECT_EQ(there.find("velocity_solid")->components[1][node], found.components[1][node]);
            }
        const PointWeights weights = point_weights(grid, there, surface);
        ASSERT_TRUE(weights.inside);
        double at_surface = 0.0;
        for (std::size_t k = 0; k < 4; ++k)
            at_surface += weights.weight[k] * found.components[1][weights.node[k]];
        EXPECT_NEAR(at_surface, velocity(surface).y(), 1e-12);
    }
}

// Pressures of a column that consolidates bend with the depth: beside the wall they were five per cent off.
TEST(NodalFields, AreThoseOfTheMiddleAtASideWhereNothingChangesAcross)
{
    Block block;
    Particles& particles = block.state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p)
        particles.velocity_solid.set(p, {std::pow(particles.position.y[p], 3), 0.0});
    const NodalFields fields = nodal_fields(block.problem, particles);
    const BackgroundGrid& grid = block.problem.grid;
    const Scalars& found = fields.find("velocity_solid")->components[0];
    const auto at = [&](int column, int row) {
        return found[grid.node_index(BackgroundGrid::ghost_cells + column,
                                     BackgroundGrid::ghost_cells + row)];
    };
    for (int row = 0; row <= 3; ++row)
        for (const int side : {0, 4}) EXPECT_NEAR(at(side, row), at(2, row), 1e-12) << row;
}

// Dry soil has no pressure in its pores: a slope from the wet soil below told of suction at its surface.
TEST(NodalFields, PressuresOfWaterHaveNoSlopeInDrySoil)
{
    Block block;
    block.problem.water = fixtures::water_to(3.0);
    Material dry = fixtures::stiff_sand();
    dry.saturated = false;
    block.problem.materials.push_back(dry);
    block.state = fixtures::fill(block.problem, 2, [](const Vector2&) { return true; });
    Particles& particles = block.state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const bool is_dry = particles.position.y[p] > 3.0;
        particles.material[p] = is_dry ? 1 : 0;
        particles.pore_pressure[p] = is_dry ? 0.0 : 30e3;
    }
    const NodalFields fields = nodal_fields(block.problem, particles);
    const BackgroundGrid& grid = block.problem.grid;
    const Scalars& found = fields.find("excess_pore_pressure")->components[0];
    for (std::size_t node = 0; node < grid.node_count(); ++node) {
        const double y = grid.node_position(node).y();
        if (!(fields.volume[node] > 0.0)) continue;
        if (y > 3.0 + 1e-9) {
            EXPECT_NEAR(found[node], 0.0, 1e-9) << y;
        } else if (y < 3.0 - 1e-9) {
            EXPECT_NEAR(found[node], 30e3, 1e-6) << y;
        }
    }
}

// Stresses scatter, and a slope would tell tension where there is none.
TEST(NodalFields, AreMeansOfStressesAtTheRimOfTheSoil)
{
    Block block;
    Particles& particles = block.state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p)
        particles.stress.yy[p] = -1e3 * std::exp(4.0 * (3.5 - particles.position.y[p]));
    const NodalFields fields = nodal_fields(block.problem, particles);
    const Scalars& found = fields.find("vertical_effective_stress")->components[0];
    const auto [low, high] = std::minmax_element(particles.stress.yy.begin(), particles.stress.yy.end());
    for (std::size_t node = 0; node < found.size(); ++node)
        if (fields.volume[node] > 0.0) {
            EXPECT_GE(found[node], -*high);
            EXPECT_LE(found[node], -*low);
        }
}

TEST(NodalFields, LeaveOutNodesBeyondTheGrid)
{
    // displaced domains of small strain go wherever they please: beyond each side, by parts and altogether
    const Block whole;
    const double domain = 0.25 * 0.25;
    const double all = whole.averaged_volume();
    EXPECT_NEAR(all, 4 * 3 * 0.25, 1e-13);
    const BackgroundGrid& grid = whole.problem.grid;
    const Vector2 lower = grid.rim_origin(), upper = lower + 0.5 * Vector2(12, 11);
    struct Case {
        Vector2 place;
        double left; // of the domain's volume that is still counted
    };
    const Case cases[] = {
        {{lower.x(), 3.1}, 1.0 - 0.5 * 0.125 / 0.5},
        {{upper.x(), 3.1}, 1.0 - 0.5 * 0.125 / 0.5},
        {{2.1, lower.y() - 0.25}, 0.5},
        {{2.1, upper.y() + 0.25}, 0.5},
        {{lower.x() - 0.25, lower.y() - 0.25}, 0.25},
        {{lower.x() - 1.0, 3.0}, 0.0},
        {{2.0, upper.y() + 1.0}, 0.0},
        {{1e300, -1e300}, 0.0},
        {{std::nan(""), 3.0}, 0.0},
    };
    for (const Case& displaced : cases) {
        Block block;
        block.state.particles.position.set(5, displaced.place);
        EXPECT_NEAR(block.averaged_volume(), all - (1.0 - displaced.left) * domain, 1e-12)
            << displaced.place.transpose();
    }
}

} // namespace quicksand
