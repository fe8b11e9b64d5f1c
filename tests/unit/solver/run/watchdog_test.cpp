// Runs that become unstable go back and take shorter steps.
#include "solver/measure/balances.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/run/simulation.hpp"
#include "solver/run/watchdog.hpp"
#include "solver/step/stepper.hpp"
#include "tests/fixtures/restless_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

namespace quicksand {
namespace {

using namespace fixtures;

/// Counts how often the run went back.
class Counter : public Observer {
public:
    double next_time() const override { return std::numeric_limits<double>::infinity(); }
    void observe(const Problem&, const State&, const StepReport&) override {}
    void after_step(const StepReport& report) override { last_step = report.step; }
    void went_back(const FailureRecord& record, const State& state) override
    {
        ++times;
        failed_step = record.step;
        kept_step = state.step;
    }

    int times = 0;
    std::int64_t failed_step = 0, kept_step = 0, last_step = 0;
};

/// A restless patch of small strain, whose motion never leaves the grid, with its balances open.
struct Patch {
    Problem problem = patch(1e-4, true);
    State state;

    explicit Patch(double step_fraction)
    {
        problem.strain = StrainForm::small;
        problem.step_fraction = step_fraction;
        state = restless(problem);
        open_balances(problem, state);
    }
};

TEST(Watchdog, HalvesAStepThatIsTooLong)
{
    Patch patch(2.2); // grows from 1.6 on
    const double energy = monitor(patch.problem, patch.state, {}).kinetic_energy;
    const double dt = stable_time_step(patch.problem, patch.state.particles).dt;
    Counter counter;
    EXPECT_TRUE(run(patch.problem, 300.0 * dt, {&counter}, patch.state));
    EXPECT_EQ(patch.state.step_halvings, 1);
    EXPECT_EQ(counter.times, 1);
    EXPECT_GE(counter.failed_step, counter.kept_step);
    EXPECT_LT(monitor(patch.problem, patch.state, {}).kinetic_energy, energy);
}

/// Two histories.
class Metronome : public Observer {
public:
    explicit Metronome(double interval) : interval_(interval) {}
    double next_time() const override { return interval_ * static_cast<double>(beats_); }
    double interval() const override { return interval_; }
    void observe(const Problem&, const State&, const StepReport&) override { ++beats_; }

private:
    double interval_; // [s]
    int beats_ = 1;
};

/// Rows 0.95 and 2.5 x 0.95 steps apart once made steps of 1, 1, 1/2 and 1/2, by which elastic soil blew up.
TEST(Watchdog, IsNotNeededWhereHistoriesWouldMakeStepsAlternate)
{
    Patch patch(1.0);
    const double dt = stable_time_step(patch.problem, patch.state.particles).dt;
    Metronome probes(0.95 * dt), history(2.5 * 0.95 * dt);
    Counter counter;
    EXPECT_TRUE(run(patch.problem, 300.0 * dt, {&probes, &history, &counter}, patch.state));
    EXPECT_EQ(counter.times, 0);
    EXPECT_LT(energy_balance(patch.problem, patch.state).error(), 0.01);
    EXPECT_EQ(counter.last_step, 632) << "all of 0.475 dt";
}

TEST(Watchdog, LeavesAStableRunAlone)
{
    Patch patch(1.0);
    const double dt = stable_time_step(patch.problem, patch.state.particles).dt;
    Counter counter;
    EXPECT_TRUE(run(patch.problem, 300.0 * dt, {&counter}, patch.state));
    EXPECT_EQ(patch.state.step_halvings, 0);
    EXPECT_EQ(counter.times, 0);
}

TEST(Watchdog, GivesUpAfterThreeHalvingsInARow)
{
    Patch patch(1.0);
    patch.state.particles.velocity_solid.x[7] = std::numeric_limits<double>::quiet_NaN();
    Counter counter;
    try {
        run(patch.problem, 1e-3, {&counter}, patch.state);
        FAIL() << "no error";
    } catch (const NumericalError& error) {
        EXPECT_NE(error.record.what.find("half the step, taken 3 times from the last restart point, has not "
                                         "helped"),
                  std::string::npos)
            << error.record.what;
    }
    EXPECT_EQ(counter.times, 3);
}

TEST(Watchdog, TellsThatStepsMakeEnergy)
{
    Patch patch(1.0);
    const Watchdog watchdog(patch.problem, patch.state);
    patch.state.step = 1;
    for (double& v : patch.state.particles.velocity_solid.x) v *= 100.0;
    patch.state.balance_terms->skeleton_work =
        monitor(patch.problem, patch.state, {}).kinetic_energy; // work on the soil, and nothing did it
    try {
        watchdog.check(patch.problem, 1e-6, patch.state);
        FAIL() << "no error";
    } catch (const NumericalError& error) {
        EXPECT_EQ(error.record.phase, "watchdog");
        EXPECT_EQ(error.record.what.find("the steps have made energy, "), 0U) << error.record.what;
        EXPECT_EQ(std::string(error.record.causes).find("the time step is too long"), 0U);
    }
}

// Pressures of a wall that begins to move make a tenth of the little that its first step turns over.
TEST(Watchdog, WaitsAFewStepsFromRest)
{
    Patch patch(1.0);
    Particles& particles = patch.state.particles;
    const Vectors still = {Scalars(particles.size(), 0.0), Scalars(particles.size(), 0.0)};
    const Vectors moving = particles.velocity_solid;
    particles.velocity_solid = particles.velocity_fluid = still;
    open_balances(patch.problem, patch.state);
    const Watchdog watchdog(patch.problem, patch.state);
    particles.velocity_solid = moving;
    patch.state.balance_terms->skeleton_work = 1.0;
    patch.state.step = 3;
    EXPECT_NO_THROW(watchdog.check_growth(patch.problem, 1e-6, patch.state));
    patch.state.step = 4;
    EXPECT_THROW(watchdog.check_growth(patch.problem, 1e-6, patch.state), NumericalError);
}

// Going back would make nothing better.
TEST(Watchdog, DoesNotBlameStepsForEnergyThatWasMadeBefore)
{
    Patch patch(1.0);
    const double kinetic = monitor(patch.problem, patch.state, {}).kinetic_energy;
    BalanceTerms& terms = *patch.state.balance_terms;
    terms.skeleton_work = 25.0 * kinetic; // and nothing did it
    const Watchdog watchdog(patch.problem, patch.state);
    patch.state.step = 1;
    for (double& v : patch.state.particles.velocity_solid.x) v *= 3.0;
    EXPECT_NO_THROW(watchdog.check_growth(patch.problem, 1e-6, patch.state));
    terms.skeleton_work += 5.0 * kinetic;
    EXPECT_THROW(watchdog.check_growth(patch.problem, 1e-6, patch.state), NumericalError);
}

// It does not grow: the steps make energy, and the transfers lose it at once.
TEST(Watchdog, TellsThatEnergyIsMadeAndLostAgain)
{
    Patch patch(1.0);
    const Watchdog watchdog(patch.problem, patch.state);
    patch.state.step = 1;
    BalanceTerms& terms = *patch.state.balance_terms;
    terms.wall_loss = 1.9 * energy_put_in(terms);
    EXPECT_NO_THROW(watchdog.check(patch.problem, 1e-6, patch.state));
    terms.wall_loss = 2.2 * energy_put_in(terms);
    EXPECT_NO_THROW(watchdog.check_growth(patch.problem, 1e-6, patch.state));
    try {
        watchdog.check(patch.problem, 1e-6, patch.state);
        FAIL() << "no error";
    } catch (const NumericalError& error) {
        EXPECT_EQ(error.record.what.find(
                      "the steps have made energy that is lost again between particles and grid, "
                      "220 % of all that was put in"),
                  0U)
            << error.record.what;
    }
}

// What was lost before is no reason to go back once more.
TEST(Watchdog, CountsTheLossSinceTheLastRestartPoint)
{
    Patch patch(1.0);
    BalanceTerms& terms = *patch.state.balance_terms;
    terms.wall_loss = 5.0 * energy_put_in(terms);
    const Watchdog watchdog(patch.problem, patch.state);
    patch.state.step = 1;
    EXPECT_NO_THROW(watchdog.check(patch.problem, 1e-6, patch.state));
    terms.wall_loss += 0.2 * energy_put_in(terms);
    EXPECT_THROW(watchdog.check(patch.problem, 1e-6, patch.state), NumericalError);
}

// What holds it has grown with the motion itself.
TEST(Watchdog, DoesNotCountTheStressThatTheStepsHaveMade)
{
    Patch patch(1.0);
    const Watchdog watchdog(patch.problem, patch.state);
    patch.state.step = 1;
    BalanceTerms& terms = *patch.state.balance_terms;
    terms.wall_loss = 2.2 * energy_put_in(terms);
    std::fill(patch.state.particles.stress.xx.begin(), patch.state.particles.stress.xx.end(), 1e9);
    EXPECT_THROW(watchdog.check(patch.problem, 1e-6, patch.state), NumericalError);
}

TEST(Watchdog, SumsTheKineticEnergyAsTheMonitorsDo)
{
    Patch patch(1.0);
    EXPECT_NEAR(kinetic_energy(patch.problem, patch.state.particles) /
                    monitor(patch.problem, patch.state, {}).kinetic_energy,
                1.0, 1e-13);
}

/// The shortest step over the one before.
class Shrinking : public Observer {
public:
    double next_time() const override { return std::numeric_limits<double>::infinity(); }
    void observe(const Problem&, const State&, const StepReport&) override {}
    void after_step(const StepReport& report) override
    {
        if (last > 0.0) least = std::min(least, report.time_step.dt / last);
        last = report.time_step.dt;
    }
    void went_back(const FailureRecord& record, const State& state) override
    {
        remedies += record.remedy == Remedy::explicit_steps;
        last = state.last_step;
    }

    double last = 0.0, least = 1.0;
    int remedies = 0;
};

/// The same patch of loose drag, whose pressure is let go at the top: a front that semi-implicit steps damp.
struct LoudPatch : Patch {
    LoudPatch() : Patch(1.0)
    {
        problem.scheme = TimeScheme::semi_implicit;
        problem.materials[0].hydraulic_conductivity = 1.0;
        std::fill(state.particles.pore_pressure.begin(), state.particles.pore_pressure.end(), 1e3);
        open_balances(problem, state);
    }
};

TEST(Watchdog, TakesExplicitStepsWhereSemiImplicitOnesDampTheSound)
{
    LoudPatch patch;
    const double dt = stable_time_step(patch.problem, patch.state.particles).dt;
    State damped = patch.state;
    const std::unique_ptr<Stepper> stepper = make_stepper(patch.problem);
    for (int k = 0; k < 20; ++k) stepper->advance(patch.problem, dt, damped);
    EXPECT_LT(balance(patch.problem, damped).energy_error, -0.1);

    Shrinking steps;
    EXPECT_TRUE(run(patch.problem, 20.0 * dt, {&steps}, patch.state));
    EXPECT_EQ(steps.remedies, 1);
    EXPECT_EQ(patch.state.step_halvings, 0);
    EXPECT_EQ(patch.state.explicit_end, Watchdog::explicit_steps);
    EXPECT_GT(balance(patch.problem, patch.state).energy_error, -0.02);
}

TEST(Watchdog, TakesExplicitStepsWhereImplicitOnesAreHardlyLonger)
{
    for (const double stiffness : {1.0, 1e4}) { // of the water: sound is followed, or far too fast
        LoudPatch patch;
        patch.problem.scheme = TimeScheme::implicit;
        const double end = 20.0 * stable_time_step(patch.problem, patch.state.particles).dt;
        patch.problem.water->bulk_modulus *= stiffness;
        Shrinking steps;
        EXPECT_TRUE(run(patch.problem, end, {&steps}, patch.state));
        EXPECT_EQ(steps.remedies, stiffness == 1.0 ? 1 : 0);
        if (stiffness > 1.0) continue;
        EXPECT_GT(balance(patch.problem, patch.state).energy_error, -0.02);
    }
}

// Over the long interval from the middle of a semi-implicit step an explicit one would be unstable.
TEST(Watchdog, ShortensStepsByHalvesBeforeTheyAreExplicit)
{
    LoudPatch patch;
    const double dt = stable_time_step(patch.problem, patch.state.particles).dt;
    patch.state.explicit_end = 100000;
    patch.state.last_step = dt;
    patch.state.step = 32;
    Shrinking steps;
    steps.last = dt;
    EXPECT_TRUE(run(patch.problem, 3.0 * dt, {&steps}, patch.state));
    EXPECT_GE(steps.least, 0.5 - 1e-9);
    Problem explicit_form = patch.problem;
    explicit_form.scheme = TimeScheme::explicit_steps;
    EXPECT_NEAR(steps.last, stable_time_step(explicit_form, patch.state.particles).dt, 0.1 * steps.last);
    EXPECT_GT(balance(patch.problem, patch.state).energy_error, -0.1);
}

TEST(Watchdog, ExplicitStepsGoOnWithTheSameBitsWhereARunIsStopped)
{
    LoudPatch whole, parts;
    const double end = 30.0 * stable_time_step(whole.problem, whole.state.particles).dt;
    EXPECT_TRUE(run(whole.problem, end, {}, whole.state));
    const auto in_the_middle = [&] { return parts.state.step < parts.state.explicit_end; };
    EXPECT_FALSE(run(parts.problem, end, {}, parts.state, in_the_middle));
    EXPECT_TRUE(run(parts.problem, end, {}, parts.state));
    EXPECT_EQ(whole.state.step, parts.state.step);
    EXPECT_EQ(whole.state.particles.velocity_solid.x, parts.state.particles.velocity_solid.x);
    EXPECT_EQ(whole.state.particles.pore_pressure, parts.state.particles.pore_pressure);
}

} // namespace
} // namespace quicksand
