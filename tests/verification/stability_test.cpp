// The largest stable step: random motion of a partly filled patch decays below it and grows above it.
#include "solver/base/failure.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step/two_phase_step.hpp"
#include "tests/fixtures/restless_patch.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures;

/// Kinetic energy after 2000 steps of `fraction` times the stable step, over that at the start.
double energy_growth(const Problem& problem, double fraction)
{
    State state = restless(problem);
    const double dt = fraction * stable_time_step(problem, state.particles).dt;
    const double before = monitor(problem, state, {}).kinetic_energy;
    if (problem.water) {
        TwoPhaseWorkspace work = make_two_phase_workspace(problem);
        for (int k = 0; k < 2000; ++k) advance_two_phase_step(problem, dt, state, work);
    } else {
        SinglePhaseWorkspace work = make_single_phase_workspace(problem);
        for (int k = 0; k < 2000; ++k) advance_single_phase_step(problem, dt, 0.0, state, work);
    }
    return monitor(problem, state, {}).kinetic_energy / before;
}

TEST(StableTimeStep, RandomMotionDecaysForEveryPermeability)
{
    for (const double conductivity : {1e-2, 1e-3, 1e-5, 1e-7}) {
        EXPECT_LT(energy_growth(patch(conductivity, true), 1.0), 0.1) << "k = " << conductivity;
        EXPECT_LT(energy_growth(patch(conductivity, true), 1.1), 0.1) << "k = " << conductivity;
    }
    EXPECT_LT(energy_growth(patch(1.0, false), 1.0), 0.1);
}

TEST(StableTimeStep, RandomMotionDecaysWithTheCellsVolume)
{
    for (const bool saturated : {false, true}) {
        Problem problem = patch(1e-3, saturated);
        problem.materials[0].volumetric_strain = VolumetricStrain::cell;
        EXPECT_LT(energy_growth(problem, 1.0), 0.1) << saturated;
        EXPECT_LT(energy_growth(problem, 1.1), 0.1) << saturated;
    }
}

TEST(StableTimeStep, AStiffParticleCountsByItsPartOfTheCell)
{
    for (const double ratio : {9.0, 36.0}) {
        auto [problem, state, dt] = with_stiff_points(ratio, patch(1.0, false));
        EXPECT_GT(dt, 1.1 * stable_time_step(problem, state.particles).dt) << "two materials do not mix";
        const double before = monitor(problem, state, {}).kinetic_energy;
        SinglePhaseWorkspace work = make_single_phase_workspace(problem);
        for (int k = 0; k < 2000; ++k) advance_single_phase_step(problem, dt, 0.0, state, work);
        EXPECT_LT(monitor(problem, state, {}).kinetic_energy, 0.1 * before) << ratio;
    }
}

TEST(StableTimeStep, MotionIsLostAboveTheLimit)
{
    EXPECT_THROW(energy_growth(patch(1e-3, true), 1.4), NumericalError) << "the test can fail";
}

} // namespace
} // namespace quicksand
