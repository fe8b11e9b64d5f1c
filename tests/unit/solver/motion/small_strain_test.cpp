// Small strain: the equations stay on the reference shape, so that the answer is linear in the load.
#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step/two_phase_step.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {
namespace {

using namespace fixtures;

Problem small_strain_block(Interpolation interpolation)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.1, 4, 5};
    problem.interpolation = interpolation;
    problem.strain = StrainForm::small;
    problem.materials = {stiff_sand()};
    problem.water = water_to(0.4);
    problem.gravity = 0.0;
    problem.boundaries = rectangle(0.0, 0.0, 0.4, 0.4, FixedWall{}, RollerWall{}, FreeFace{});
    return problem;
}

/// A block that an uneven stress of the given size sets in motion.
State stressed_block(const Problem& problem, double stress)
{
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 0.4; });
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 x = particles.position[p];
        particles.stress.yy[p] = stress * (1.0 + x.x());
        particles.stress.xy[p] = 0.5 * stress * x.y();
        particles.pore_pressure[p] = stress;
    }
    return state;
}

/// The problem with a pressure and a traction on the top.
Problem loaded(Problem problem, double load, const State& state)
{
    problem.boundaries[2].soil = FreeFace{SurfaceLoad{{0.5 * load, 0.0}, load, {}}};
    attach_boundaries(problem, state.particles);
    return problem;
}

void advance(const Problem& problem, int steps, State& state)
{
    TwoPhaseWorkspace work = make_two_phase_workspace(problem);
    const double dt = stable_time_step(problem, state.particles).dt;
    for (int k = 0; k < steps; ++k) advance_two_phase_step(problem, dt, state, work);
}

TEST(SmallStrain, DoubleTheLoadIsDoubleTheAnswerBitForBit)
{
    for (const Interpolation interpolation : {Interpolation::cpdi, Interpolation::cpdi2, Interpolation::gimp,
                                              Interpolation::cpgimp, Interpolation::linear}) {
        const Problem problem = small_strain_block(interpolation);
        State once = stressed_block(problem, 1e6), twice = stressed_block(problem, 2e6);
        advance(loaded(problem, 1e5, once), 200, once);
        advance(loaded(problem, 2e5, twice), 200, twice);
        double largest = 0.0;
        for (std::size_t p = 0; p < once.particles.size(); ++p) {
            ASSERT_EQ(twice.particles.velocity_solid[p], 2.0 * once.particles.velocity_solid[p]);
            ASSERT_EQ(twice.particles.velocity_fluid[p], 2.0 * once.particles.velocity_fluid[p]);
            ASSERT_EQ(twice.particles.pore_pressure[p], 2.0 * once.particles.pore_pressure[p]);
            ASSERT_EQ(twice.particles.stress.xy[p], 2.0 * once.particles.stress.xy[p]);
            const Vector2 moved = once.particles.position[p] - once.particles.reference_position[p];
            const Vector2 moved_twice = twice.particles.position[p] - twice.particles.reference_position[p];
            ASSERT_LT((moved_twice - 2.0 * moved).norm(), 1e-14);
            largest = std::max(largest, moved.norm());
        }
        EXPECT_GT(largest, 1e-5) << "the block has moved";
    }
}

TEST(SmallStrain, LargeStrainIsNotLinear)
{
    Problem problem = small_strain_block(Interpolation::cpdi);
    problem.strain = StrainForm::large;
    State once = stressed_block(problem, 1e6), twice = stressed_block(problem, 2e6);
    advance(problem, 200, once);
    advance(problem, 200, twice);
    EXPECT_NE(twice.particles.pore_pressure[0], 2.0 * once.particles.pore_pressure[0])
        << "the test above can fail";
}

TEST(SmallStrain, KeepsVolumeAndPorosityAndShowsTheStrain)
{
    const Problem problem = small_strain_block(Interpolation::cpdi);
    State state = stressed_block(problem, 1e6);
    const Particles before = state.particles;
    advance(problem, 100, state);
    EXPECT_EQ(state.particles.volume, before.volume);
    EXPECT_EQ(state.particles.porosity, before.porosity);
    // strain of the displayed shape against the stress it has caused, d sigma_xy = G gamma
    const double G = 100e6;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Eigen::Matrix2d F = deformation_gradient(state.particles, p);
        const double initial = 0.5e6 * state.particles.reference_position.y[p]; // of stressed_block
        EXPECT_NEAR(G * (F(0, 1) + F(1, 0)), state.particles.stress.xy[p] - initial, 1e-3);
    }
}

TEST(SmallStrain, ARunResumedWithFreshWeightsGivesTheSameBits)
{
    const Problem problem = small_strain_block(Interpolation::cpdi);
    State whole = stressed_block(problem, 1e6);
    TwoPhaseWorkspace work = make_two_phase_workspace(problem);
    const double dt = stable_time_step(problem, whole.particles).dt;
    State resumed;
    for (int k = 0; k < 150; ++k) {
        if (k == 70) resumed = whole;
        advance_two_phase_step(problem, dt, whole, work);
    }
    TwoPhaseWorkspace fresh = make_two_phase_workspace(problem);
    for (int k = 70; k < 150; ++k) advance_two_phase_step(problem, dt, resumed, fresh);
    EXPECT_EQ(resumed.particles.pore_pressure, whole.particles.pore_pressure);
    EXPECT_EQ(resumed.particles.position.y, whole.particles.position.y);
    EXPECT_EQ(resumed.particles.identifier, whole.particles.identifier);
}

TEST(SmallStrain, AgreesWithLargeStrainWhereTheLoadIsSmall)
{
    Problem problem = small_strain_block(Interpolation::cpdi);
    State small = stressed_block(problem, 10.0);
    problem.strain = StrainForm::large;
    State large = stressed_block(problem, 10.0);
    advance(problem, 200, large);
    problem.strain = StrainForm::small;
    advance(problem, 200, small);
    for (std::size_t p = 0; p < small.particles.size(); ++p)
        EXPECT_NEAR(small.particles.pore_pressure[p], large.particles.pore_pressure[p], 1e-4);
}

TEST(SmallStrain, SettlesUnderGravityOnTheDrawnShape)
{
    Problem problem = small_strain_block(Interpolation::cpdi);
    problem.gravity = standard_gravity;
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 0.4; });
    const Vectors drawn = state.particles.position;
    const RelaxationReport report = relax(problem, RelaxationControls{}, state);
    EXPECT_LT(report.unbalanced.of_weight, 1e-6);
    EXPECT_GT(report.max_displacement, 0.0);
    EXPECT_LT(out_of_balance(problem, state), 1e-5);
    std::vector<double> heights = state.particles.position.y, drawn_heights = drawn.y;
    std::sort(heights.begin(), heights.end());
    std::sort(drawn_heights.begin(), drawn_heights.end());
    EXPECT_EQ(heights, drawn_heights);
}

} // namespace
} // namespace quicksand
