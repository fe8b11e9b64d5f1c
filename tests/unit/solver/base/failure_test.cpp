#include "solver/base/failure.hpp"
#include "solver/motion/particle_order.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace quicksand {
namespace {

using namespace fixtures;

/// The text of the NumericalError that `work` throws.
template <class Work>
std::string message_of(Work&& work)
{
    try {
        work();
    } catch (const NumericalError& error) {
        return error.what();
    }
    return "no error";
}

State column(const Problem& problem)
{
    State state = fill(problem, 3, [](const Vector2& x) { return x.y() < 0.3175; });
    state.step = 42;
    state.time = 0.125;
    return state;
}

TEST(NumericalFailure, NamesPhaseStepTimeParticlePlaceAndCauses)
{
    const Problem problem = centrifuge_column();
    State state = column(problem);
    state.particles.velocity_solid.x[5] = std::numeric_limits<double>::quiet_NaN();
    const std::string text = message_of([&] { check_particles(2e-6, state); });
    EXPECT_NE(text.find("phase 'gather' of step 42, t = 0.125 s, dt = 2e-06 s"), std::string::npos) << text;
    EXPECT_NE(text.find("a particle's velocity is not a number"), std::string::npos) << text;
    EXPECT_NE(text.find("particle 5 at (0.01375, 0.00125) m"), std::string::npos) << text;
    EXPECT_NE(text.find("likely causes: "), std::string::npos) << text;
}

TEST(NumericalFailure, NamesWhatIsNoNumberFirst)
{
    const Problem problem = centrifuge_column();
    State state = column(problem);
    state.particles.volume[9] = -1e-9;
    state.particles.volume[11] = std::numeric_limits<double>::quiet_NaN();
    const std::string text = message_of([&] { check_particles(2e-6, state); });
    EXPECT_NE(text.find("a particle's volume is not a number"), std::string::npos) << text;
    EXPECT_NE(text.find("particle 11 at"), std::string::npos) << text;
    EXPECT_NE(text.find("likely causes: the time step is too long (a smaller analysis.step_share shows it); "
                        "a wall or a side is held or moved in a way that the step does not bear"),
              std::string::npos)
        << text;
}

TEST(NumericalFailure, TellsThatTheSoilWasSettling)
{
    const Problem problem = centrifuge_column();
    State state = column(problem);
    state.stage = Stage::relaxation;
    state.particles.velocity_solid.x[5] = std::numeric_limits<double>::quiet_NaN();
    const std::string text = message_of([&] { check_particles(2e-6, state); });
    EXPECT_NE(text.find("while settling, in phase 'gather' of step 42, dt = 2e-06 s: "), std::string::npos)
        << text;
}

TEST(NumericalFailure, AVanishingVolumeIsReported)
{
    const Problem problem = centrifuge_column();
    State state = column(problem);
    state.particles.volume[9] = -1e-9;
    EXPECT_NE(message_of([&] { check_particles(2e-6, state); }).find("volume is no longer positive"),
              std::string::npos);
}

TEST(NumericalFailure, GrainsThatFillMoreThanTheirVolumeAreReported)
{
    const Problem problem = centrifuge_column();
    State state = column(problem);
    state.particles.porosity[7] = -0.01;
    const std::string text = message_of([&] { check_particles(2e-6, state); });
    EXPECT_NE(text.find("a particle has no pores left for its water: its porosity is -0.01"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("particle 7"), std::string::npos) << text;
}

TEST(NumericalFailure, AParticleThatLeavesTheGridIsReported)
{
    const Problem problem = centrifuge_column();
    State state = column(problem);
    CellLists lists = make_cell_lists(problem.grid);
    state.particles.position.y[3] = 1.0;
    const std::string text = message_of([&] { sort_particles(problem.grid, 2e-6, state, lists); });
    EXPECT_NE(text.find("a particle has left the grid"), std::string::npos) << text;
    EXPECT_NE(text.find("likely causes: a wall is missing"), std::string::npos) << text;
    EXPECT_NE(text.find("enlarge grid.cells"), std::string::npos) << text;
    state.particles.velocity_solid.y[3] = 1e6; // two metres a step
    const std::string unstable = message_of([&] { sort_particles(problem.grid, 2e-6, state, lists); });
    EXPECT_NE(unstable.find("likely causes: the time step is too long"), std::string::npos) << unstable;
}

TEST(NumericalFailure, APositionThatIsNoNumberIsReported)
{
    const Problem problem = centrifuge_column();
    State state = column(problem);
    CellLists lists = make_cell_lists(problem.grid);
    state.particles.position.y[3] = std::numeric_limits<double>::quiet_NaN();
    const std::string text = message_of([&] { sort_particles(problem.grid, 2e-6, state, lists); });
    EXPECT_NE(text.find("a particle's position is not a number"), std::string::npos) << text;
    EXPECT_NE(text.find("look at the last good frame"), std::string::npos) << text;
}

TEST(Ensure, AViolatedInvariantNamesItsExpressionAndPlace)
{
    try {
        ENSURE(1 + 1 == 3);
        FAIL() << "no error";
    } catch (const InternalError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("internal error: 1 + 1 == 3 does not hold in "), std::string::npos) << text;
        EXPECT_NE(text.find("failure_test.cpp:"), std::string::npos) << text;
    }
}

} // namespace
} // namespace quicksand
