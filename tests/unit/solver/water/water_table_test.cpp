// Pore pressures count from the water at the start of the shaking.
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {
namespace {

using namespace fixtures;

TEST(WaterTable, ALineIsLevelBeyondItsEnds)
{
    const std::vector<Vector2> line = {{1.0, 4.0}, {3.0, 2.0}, {4.0, 2.5}};
    for (const auto& [x, y] :
         {std::pair(-5.0, 4.0), {1.0, 4.0}, {2.0, 3.0}, {3.0, 2.0}, {3.5, 2.25}, {4.0, 2.5}, {9.0, 2.5}})
        EXPECT_DOUBLE_EQ(elevation(line, x), y) << x;
}

TEST(WaterTable, AHistoryCountsFromTheWaterAtRest)
{
    Problem problem;
    problem.water = water_to(1.0);
    const double weight = 1000.0 * standard_gravity;
    const WaterLine line{{{0.0, 2.0}, {2.0, 4.0}}};
    PrescribedWater given{WaterHead{6.0}};
    Boundary face{"face", FreeFace{}, given};
    EXPECT_DOUBLE_EQ(outer_excess_pressure(problem, face, {0.0, 0.0}, 0.5), 2.5 * weight);
    given.at_rest = line;
    face.water = given;
    EXPECT_DOUBLE_EQ(outer_excess_pressure(problem, face, {0.0, 0.0}, 0.0), 1.0 * weight);
    EXPECT_DOUBLE_EQ(outer_excess_pressure(problem, face, {1.0, 0.0}, 0.5), 3.5 * weight);
    EXPECT_DOUBLE_EQ(outer_excess_pressure(problem, face, {2.0, 2.0}), 4.0 * weight);
    face.water = Drained{line};
    EXPECT_DOUBLE_EQ(outer_excess_pressure(problem, face, {1.0, 0.0}), 2.0 * weight);
    face.water = Impervious{};
    EXPECT_EQ(outer_excess_pressure(problem, face, {1.0, 0.0}), 0.0);
}

/// A block 1 m high whose water stands at 2 m, counted from `level`, and that settles under its weight.
struct SettledBlock {
    Problem problem;
    State state;

    explicit SettledBlock(double level, double excess)
    {
        problem.grid = {{0.0, 0.0}, 0.25, 6, 6};
        problem.materials = {stiff_sand()};
        problem.materials[0].law = LinearElastic{1e6, 0.3}; // soft, to settle by much
        problem.water = water_to(level);
        problem.water->rises_above_level = true;
        problem.boundaries = rectangle(0.0, 0.0, 1.5, 1.0, FixedWall{}, RollerWall{}, FreeFace{});
        state = fill(problem, 2, [](const Vector2& x) { return x.y() < 1.0; });
        Particles& particles = state.particles;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const double y = particles.position.y[p];
            particles.water_table[p] = 2.0;
            particles.pore_pressure[p] =
                pressure_below(problem, 2.0, y) - static_water_pressure(problem, y) + excess;
        }
        state.stage = Stage::relaxation;
    }
};

TEST(WaterTable, NothingHasRisenOnceSoilHasSettled)
{
    for (const double excess : {0.0, 500.0}) {
        for (const double level : {0.5, -1.0}) {
            SettledBlock block(level, excess);
            relax(block.problem, {0.7, 1e-4, 100'000}, block.state);
            const Particles& particles = block.state.particles;
            double lowest = 2.0, highest = 0.0;
            for (std::size_t p = 0; p < particles.size(); ++p) {
                EXPECT_NEAR(risen_pore_pressure(block.problem, particles, p), excess, 1e-9);
                lowest = std::min(lowest, particles.water_table[p]);
                highest = std::max(highest, particles.water_table[p]);
            }
            EXPECT_GT(highest - lowest, 1e-4) << "it has moved";
        }
    }
}

TEST(WaterTable, IsThereWithALineAloneAndLevelWaterStaysWithParticlesThatMove)
{
    SettledBlock block(0.0, 0.0);
    Particles& particles = block.state.particles;
    const double weight = 1000.0 * standard_gravity;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        particles.position.y[p] -= 0.1; // sinks in still water
        particles.pore_pressure[p] = pressure_below(block.problem, 2.0, particles.position.y[p]) -
                                     static_water_pressure(block.problem, particles.position.y[p]);
        EXPECT_NEAR(risen_pore_pressure(block.problem, particles, p), 0.0, 1e-9 * weight);
    }
    block.problem.water->rises_above_level = false;
    EXPECT_TRUE(fill(block.problem, 2, [](const Vector2&) { return true; }).particles.water_table.empty());
}

} // namespace
} // namespace quicksand
