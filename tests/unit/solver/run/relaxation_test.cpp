// The damped settling before the shaking.
#include "solver/base/failure.hpp"
#include "tests/fixtures/sand_box.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {
namespace {

using namespace fixtures;

/// A block whose stress is not that of its weight.
State unsettled_block(const Problem& problem)
{
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 0.5 + 0.25 * x.x(); });
    state.stage = Stage::relaxation;
    return state;
}

Problem block_problem(bool saturated)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.25, 6, 6};
    problem.materials = {stiff_sand()};
    if (saturated) problem.water = water_to(2.0);
    problem.boundaries = rectangle(0.0, 0.0, 1.5, 1.0, FixedWall{}, RollerWall{}, FreeFace{});
    return problem;
}

TEST(Relaxation, GoesOnToTheSameBitsAfterAStop)
{
    const Problem problem = block_problem(true);
    const RelaxationControls controls{0.7, 1e-8, 100'000};
    State whole = unsettled_block(problem), stopped = whole;
    const RelaxationReport report = relax(problem, controls, whole);
    ASSERT_GT(report.steps, 100);
    EXPECT_FALSE(relax(problem, controls, stopped, {}, [] { return true; }).settled);
    EXPECT_EQ(stopped.step, 50);
    EXPECT_EQ(stopped.stage, Stage::relaxation);
    EXPECT_EQ(relax(problem, controls, stopped).steps, report.steps);
    EXPECT_EQ(stopped.particles.stress.yy, whole.particles.stress.yy);
    EXPECT_EQ(stopped.particles.position.y, whole.particles.position.y);
}

TEST(Relaxation, LeavesNoVelocityOfAnyKind)
{
    const Problem problem = block_problem(true);
    State state = unsettled_block(problem);
    ASSERT_TRUE(relax(problem, {0.7, 1e-3, 100'000}, state).settled);
    int arrays = 0;
    for_each_array(state.particles, [&](std::string_view name, const Scalars& values) {
        if (name.find("velocity") == name.npos || values.empty()) return;
        ++arrays;
        EXPECT_EQ(values, Scalars(values.size(), 0.0)) << name;
    });
    EXPECT_EQ(arrays, 16); // v, C and L of the grains, v and C of the water
}

TEST(Relaxation, EndsSoonWhereTheSoilRunsAway)
{
    // a wall of sand without a side that holds it
    Problem problem = block_problem(false);
    problem.materials[0].law =
        MohrCoulomb{.shear_modulus = 20e6, .poisson_ratio = 0.3, .friction_angle = 0.17};
    State state = fill(problem, 3, [](const Vector2& x) { return x.x() < 0.5 && x.y() < 1.0; });
    try {
        relax(problem, RelaxationControls{}, state);
        FAIL() << "no error";
    } catch (const NumericalError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("the soil runs away instead of settling: it has moved "), std::string::npos)
            << text;
        EXPECT_NE(
            text.find("likely causes: the soil does not bear its weight, the loads and the pore pressures"),
            std::string::npos);
        EXPECT_LT(error.record.step, 2000);
        EXPECT_GE(error.record.identifier, 0);
        EXPECT_GT(error.record.position.x(), 0.3) << "the free side, not the held one";
    }
}

// Sand that weighs little is pressed apart by the least stress that its law knows.
TEST(Relaxation, NamesTheLeastStressOfALawWhereSandHasNoMore)
{
    Problem problem = block_problem(false);
    problem.gravity = 1.0;
    problem.materials[0].law = make_ubcsand(sand_of_runs());
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 1.0; });
    try {
        relax(problem, RelaxationControls{0.7, 1e-6, 20'000}, state);
        FAIL() << "no error";
    } catch (const NumericalError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("likely causes: the law gives "), std::string::npos) << text;
        EXPECT_NE(text.find(" of the soil more stress than there is: stress_floor is 500 Pa; "),
                  std::string::npos)
            << text;
    }
}

TEST(Relaxation, TellsWhereTheForcesAreOutOfBalance)
{
    const Problem problem = block_problem(false);
    State state = unsettled_block(problem);
    std::vector<SettlingProgress> told;
    relax(problem, RelaxationControls{}, state, [&](const SettlingProgress& now) { told.push_back(now); });
    ASSERT_FALSE(told.empty());
    for (const SettlingProgress& now : told) {
        EXPECT_EQ(now.steps % 50, 0);
        EXPECT_GT(now.unbalanced.of_weight, 0.0);
        EXPECT_GT(now.unbalanced.share_at_place, 0.0);
        EXPECT_LE(now.unbalanced.share_at_place, 1.0);
        const Vector2 place = now.unbalanced.place;
        EXPECT_TRUE(place.x() >= 0.0 && place.x() <= 1.5 && place.y() >= 0.0 && place.y() <= 1.5);
    }
}

TEST(Relaxation, HoldsThePorePressure)
{
    // half the weight rests on the water: the skeleton carries what is left
    const Problem problem = [] {
        Problem column = block_problem(true);
        column.grid.cells_y = 8;
        return column;
    }();
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 1.0; });
    state.stage = Stage::relaxation;
    const Material& sand = problem.materials[0];
    const double weight = (1.0 - sand.porosity) * (sand.grain_density - 1000.0) * problem.gravity;
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        state.particles.pore_pressure[p] = 0.5 * weight * (1.0 - state.particles.position.y[p]);
    relax(problem, {0.7, 1e-8, 100'000}, state);
    // the strain that sets in is constant within a cell: its two rows of particles share their mean stress
    double sum = 0.0, expected = 0.0;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const double y = state.particles.reference_position.y[p], row = std::floor(8.0 * y);
        if (row != 0.0 && row != 1.0) continue;
        sum += state.particles.stress.yy[p];
        expected -= 0.5 * weight * (1.0 - y);
    }
    EXPECT_NEAR(sum, expected, -1e-4 * expected);
}

} // namespace
} // namespace quicksand
