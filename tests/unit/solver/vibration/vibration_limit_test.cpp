// The limit of the step by the nodes' vibration, against closed forms and other drawings of the same body.
#include "solver/measure/monitors.hpp"
#include "solver/run/simulation.hpp"
#include "solver/vibration/step_bound.hpp"
#include "solver/vibration/vibration_limit.hpp"
#include "tests/fixtures/restless_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double long_step = 1.0; // beyond every limit [s]

/// Bars of 1 x 40 cells of 0.1 m along y without weight, which cannot move sideways.
Problem bar()
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.1, 1, 42};
    problem.materials = {stiff_sand()};
    problem.gravity = 0.0;
    problem.boundaries = rectangle(0.0, 0.0, 0.1, 4.0, FixedWall{}, RollerWall{}, FreeFace{});
    return problem;
}

double limit_of(const Problem& problem)
{
    const State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 4.0; });
    return vibration_limit(problem, state, long_step).dt;
}

// A row of equal cells with lumped masses: omega = 2 c/h, dt = 2/omega = h/c. The free end cell lets some
// per cent more through, and the iteration comes from below.
TEST(VibrationLimit, OfADryBarIsOneCellPerStep)
{
    const double c = wave_speeds(stiff_sand(), std::nullopt, 0.43).skeleton;
    EXPECT_NEAR(limit_of(bar()), 0.1 / c, 0.03 * 0.1 / c);
}

TEST(VibrationLimit, OfAnUndrainedBarIsThatOfItsFastWave)
{
    Problem problem = bar();
    problem.water = water_to(4.0);
    problem.water->flow = WaterFlow::undrained;
    const double c = wave_speeds(stiff_sand(), problem.water, 0.43).undrained;
    EXPECT_NEAR(limit_of(problem), 0.1 / c, 0.03 * 0.1 / c);
}

TEST(VibrationLimit, OfExplicitTwoPhaseStepsIsThatOfTheFastWaveWithoutDrag)
{
    Problem problem = bar();
    problem.water = water_to(4.0);
    problem.materials[0].hydraulic_conductivity = 1.0; // drag of no weight
    const double c = wave_speeds(stiff_sand(), problem.water, 0.43).fast;
    EXPECT_NEAR(limit_of(problem), 0.1 / c, 0.03 * 0.1 / c);
}

// Water of a modulus far below the skeleton's leaves the waves of the skeleton, which carries the water where
// the drag is strong.
TEST(VibrationLimit, OfSemiImplicitStepsWithSoftWaterIsThatOfTheLoadedSkeleton)
{
    Problem problem = bar();
    problem.scheme = TimeScheme::semi_implicit;
    problem.water = water_to(4.0);
    problem.water->bulk_modulus = 1e3;
    problem.materials[0].hydraulic_conductivity = 1e-9;
    const Material& sand = problem.materials[0];
    const double density = (1.0 - sand.porosity) * sand.grain_density + sand.porosity * 1000.0;
    const double c = std::sqrt(constrained_modulus(std::get<LinearElastic>(sand.law)) / density);
    EXPECT_NEAR(limit_of(problem), 0.1 / c, 0.03 * 0.1 / c);
}

// The nodes above a water table that almost no water reaches follow those below: where between the grid lines
// it lies does not matter.
TEST(VibrationLimit, OfExplicitStepsDoesNotFallWithTheWaterAboveAGridLine)
{
    Problem problem = bar();
    problem.water = water_to(2.0);
    problem.materials.push_back(problem.materials[0]);
    problem.materials[1].saturated = false;
    const auto limit = [&](double table) {
        State state = fill(problem, 5, [](const Vector2& x) { return x.y() < 4.0; });
        for (std::size_t p = 0; p < state.particles.size(); ++p)
            state.particles.material[p] = state.particles.position.y[p] > table ? 1 : 0;
        return vibration_limit(problem, state, long_step).dt;
    };
    for (const Interpolation interpolation :
         {Interpolation::cpdi, Interpolation::gimp, Interpolation::linear}) {
        problem.interpolation = interpolation;
        const double on_line = limit(2.0);
        for (const double part : {0.2, 0.4, 0.6, 0.8})
            EXPECT_GT(limit(2.0 + 0.1 * part), 0.85 * on_line)
                << static_cast<int>(interpolation) << ' ' << part;
    }
}

// Boxes that have moved over the line above them by less than a millionth of a cell: the node there has a
// stiffness as small as its mass, and follows the nodes below however small both are.
TEST(VibrationLimit, OfBoxesBesideASlantedWallDoesNotFallWithTheirOverlap)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.1, 5, 6};
    problem.materials = {stiff_sand()};
    problem.gravity = 0.0;
    problem.boundaries = rectangle(0.0, 0.0, 0.4, 0.4, FixedWall{}, RollerWall{}, FreeFace{});
    problem.boundaries[1].segments = {{{0.4, 0.0}, {0.41, 0.4}}};
    for (const Interpolation interpolation : {Interpolation::gimp, Interpolation::cpgimp}) {
        problem.interpolation = interpolation;
        const auto limit = [&](double overlap) {
            State state = fill(problem, 2, [](const Vector2& x) { return x.x() < 0.4 && x.y() < 0.4; });
            for (double& y : state.particles.position.y) y += 0.1 * overlap;
            return vibration_limit(problem, state, long_step).dt;
        };
        for (const double overlap : {1e-8, 1e-6, 1e-5})
            EXPECT_NEAR(limit(overlap), limit(1e-3), 0.03 * limit(1e-3)) << overlap;
    }
}

TEST(VibrationLimit, ScalesWithLengthAndFallsWithTheRootOfTheModulus)
{
    Problem problem = patch(1e-4, false);
    const double limit = vibration_limit(problem, restless(problem), long_step).dt;
    std::get<LinearElastic>(problem.materials[0].law).shear_modulus *= 100.0;
    EXPECT_NEAR(vibration_limit(problem, restless(problem), long_step).dt, 0.1 * limit, 1e-9 * limit);
}

TEST(VibrationLimit, IsNotAboveTheStepThatIsAskedFor)
{
    const Problem problem = patch(1e-4, false);
    EXPECT_EQ(vibration_limit(problem, restless(problem), 1e-9).dt, 1e-9);
}

TEST(VibrationLimit, IsTheSameWithSoilAtRestAndMoving)
{
    const Problem problem = patch(1e-4, true);
    const State moving = restless(problem);
    State still = moving;
    for (Scalars* part : {&still.particles.velocity_solid.x, &still.particles.velocity_solid.y,
                          &still.particles.velocity_fluid.x, &still.particles.velocity_fluid.y})
        std::fill(part->begin(), part->end(), 0.0);
    EXPECT_EQ(vibration_limit(problem, moving, long_step).dt, vibration_limit(problem, still, long_step).dt);
}

TEST(StepBound, LeavesTheClosedFormsStepWhereItIsShortEnough)
{
    const Problem problem = patch(1e-4, true);
    State state = restless(problem);
    measure_bound(problem, state);
    EXPECT_EQ(state.step_scale, 1.0);
    EXPECT_EQ(bounded_time_step(problem, state).dt, stable_time_step(problem, state.particles).dt);
    EXPECT_EQ(bounded_time_step(problem, state).limiter, TimeStepLimiter::wave);
}

// Shearing and bending of cells of nearly incompressible soil change no cell's volume: implicit water does
// not see them, and the wave of the volume that limits the closed form is not theirs.
TEST(StepBound, ShortensTheStepOfNearlyIncompressibleSoil)
{
    Problem problem = patch(1e-4, true);
    problem.scheme = TimeScheme::semi_implicit;
    std::get<LinearElastic>(problem.materials[0].law).poisson_ratio = 0.49;
    State state = restless(problem);
    measure_bound(problem, state);
    EXPECT_LT(state.step_scale, 0.9);
    EXPECT_EQ(bounded_time_step(problem, state).limiter, TimeStepLimiter::vibration);
    EXPECT_DOUBLE_EQ(bounded_time_step(problem, state).dt,
                     state.step_scale * stable_time_step(problem, state.particles).dt);
}

// The faster these waves are than the shear wave of the closed form, the shorter is the step: without a floor
// that they reach.
TEST(StepBound, IsAsShortAsTheWavesOfNearlyIncompressibleSoilNeed)
{
    for (const double nu : {0.49, 0.497, 0.499}) {
        Problem problem = patch(1e-6, true);
        problem.scheme = TimeScheme::semi_implicit;
        std::get<LinearElastic>(problem.materials[0].law).poisson_ratio = nu;
        State state = restless(problem);
        const double closed = stable_time_step(problem, state.particles).dt;
        measure_bound(problem, state);
        const double dt = bounded_time_step(problem, state).dt;
        EXPECT_NEAR(dt, 0.9 * vibration_limit(problem, state, closed).dt, 0.02 * dt) << nu;
        const double energy = monitor(problem, state, {}).kinetic_energy;
        EXPECT_TRUE(run(problem, 300.0 * dt, {}, state));
        EXPECT_EQ(state.step_halvings, 0) << nu;
        EXPECT_LT(monitor(problem, state, {}).kinetic_energy, energy) << nu;
    }
}

// A box of length l that reaches over the last line with its edge gives the node there K/m = 2 M/(rho h l),
// however small the overlap, and keeps nothing of its motion (F = 0): dt = sqrt(2)/omega = sqrt(l/h) h/c.
TEST(StepBound, OfBoxesOnGridLinesIsThatOfBoxesThatReachOverThem)
{
    Problem problem = bar();
    problem.interpolation = Interpolation::gimp;
    State state = fill(problem, 3, [](const Vector2& x) { return x.y() < 4.0; });
    measure_bound(problem, state);
    const double c = wave_speeds(stiff_sand(), std::nullopt, 0.43).skeleton;
    const double limit = std::sqrt(1.0 / 3.0) * 0.1 / c;
    EXPECT_NEAR(bounded_time_step(problem, state).dt, 0.9 * limit, 0.05 * limit);
    problem.strain = StrainForm::small; // nothing moves over the lines
    measure_bound(problem, state);
    EXPECT_EQ(state.step_scale, 1.0);
}

} // namespace
} // namespace quicksand
