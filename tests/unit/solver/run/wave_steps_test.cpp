// Steps that waves limit in a run of implicit ones: where they are taken, and that changes of kind go unseen.
#include "solver/free_field/free_field_steps.hpp"
#include "solver/free_field/wave_steps.hpp"
#include "solver/measure/balances.hpp"
#include "solver/run/simulation.hpp"
#include "solver/step/scheme_choice.hpp"
#include "solver/step_length/time_step_control.hpp"
#include "tests/fixtures/restless_patch.hpp"
#include "tests/fixtures/same_bits.hpp"
#include "tests/fixtures/sand_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double end_of_cycle = 0.01;                // [s]
constexpr double top = (149.0 + 1.0 / 3.0) * 0.0075; // of the patch [m]

/// The patch, 3 cells wide and so high that its own vibration is slow, shaken by one cycle of 100 Hz, with a
/// table of a load of nothing whose intervals are a microsecond from 2 to 4 ms and from 6 to 8 ms: no
/// implicit step is longer there than waves allow.
Problem shaken_patch(bool saturated)
{
    Problem problem = patch(1e-4, saturated);
    problem.grid.cells_x = 3;
    problem.grid.cells_y = 150;
    problem.boundaries = rectangle(0.0, 0.0, 0.0225, top, FixedWall{}, RollerWall{}, FreeFace{});
    problem.scheme = TimeScheme::implicit;
    SineMotion sine;
    sine.amplitude = 1.0;
    sine.frequency = 100.0;
    sine.cycles = 1.0;
    problem.base_motion = sine;
    SampledHistory table;
    for (double time = 0.0; time < 1.01 * end_of_cycle;) {
        table.times.push_back(time);
        table.values.push_back(0.0);
        const bool fine = (time > 1.9e-3 && time < 4e-3) || (time > 5.9e-3 && time < 8e-3);
        time += fine ? 1e-6 : 1e-4;
    }
    FreeFace loaded;
    loaded.load = SurfaceLoad{};
    loaded.load->history.shape = table;
    problem.boundaries[2].soil = loaded;
    return problem;
}

State still(const Problem& problem)
{
    return fill(problem, 3, [](const Vector2& x) { return x.y() < top; });
}

/// Keeps how the steps were taken.
class Record final : public Observer {
public:
    double next_time() const override { return std::numeric_limits<double>::infinity(); }
    void observe(const Problem&, const State&, const StepReport&) override {}
    void after_step(const StepReport& report) override { reports.push_back(report); }

    /// Of the steps that end in (from, to].
    std::vector<TimeScheme> schemes(double from, double to) const
    {
        std::vector<TimeScheme> found;
        for (const StepReport& report : reports)
            if (report.time > from && report.time <= to) found.push_back(report.time_step.scheme);
        return found;
    }

    std::vector<StepReport> reports;
};

bool are_all(const std::vector<TimeScheme>& schemes, TimeScheme scheme)
{
    return !schemes.empty() &&
           std::all_of(schemes.begin(), schemes.end(), [scheme](TimeScheme each) { return each == scheme; });
}

TEST(WaveSteps, AreTakenWhereImplicitOnesOfTheSameTimeCostMore)
{
    TimeStep waves, accurate;
    waves.dt = 1.0;
    const double cost = 2.5;
    accurate.dt = 0.99 * cost;
    EXPECT_TRUE(are_waves_cheaper(waves, accurate, cost));
    accurate.dt = 1.01 * cost;
    EXPECT_FALSE(are_waves_cheaper(waves, accurate, cost));
}

TEST(WaveSteps, AreTakenWhileAccuracyLeavesNoLongerImplicitOnes)
{
    const Problem problem = shaken_patch(true), wave_form = with_scheme(problem, scheme_of_waves(problem));
    EXPECT_EQ(wave_form.scheme, TimeScheme::semi_implicit);
    State state = still(problem);
    measure_bounds(problem, state);
    EXPECT_EQ(step_replaced_by_waves(problem, wave_form, state), std::nullopt) << "steps may be long";
    EXPECT_EQ(state.step_scale, 0.0) << "nothing was measured for it";
    state.time = 3e-3;
    const auto replaced = step_replaced_by_waves(problem, wave_form, state);
    ASSERT_TRUE(replaced);
    EXPECT_EQ(replaced->dt, stable_time_step(problem, state).dt);
    EXPECT_GT(state.step_scale, 0.9) << "measured";
    EXPECT_LE(state.step_scale, 1.0);

    State after_failure = state, left_alone = state;
    after_failure.step_halvings = 1;
    EXPECT_EQ(step_replaced_by_waves(problem, wave_form, after_failure), std::nullopt);
    left_alone.time = 1.0;
    EXPECT_EQ(step_replaced_by_waves(problem, wave_form, left_alone), std::nullopt) << "steps grow";
}

// Forces act from the middle of the last step on.
TEST(WaveSteps, AreShorterAfterALongStep)
{
    EXPECT_EQ(step_after(0.0, 1.0), 1.0);
    EXPECT_EQ(step_after(1.0, 1.0), 1.0);
    for (const double last : {1.5, 2.3, 100.0}) {
        const double dt = step_after(last, 1.0);
        EXPECT_NEAR(dt * 0.5 * (last + dt), 1.0, 1e-9) << last;
    }
}

TEST(WaveSteps, AreTakenByNoOtherScheme)
{
    Problem problem = shaken_patch(true);
    problem.scheme = TimeScheme::semi_implicit;
    State state = still(problem);
    state.time = 3e-3;
    EXPECT_EQ(step_replaced_by_waves(problem, problem, state), std::nullopt);
}

TEST(WaveSteps, AreToldAsTheFirstOfARunThatBeginsWithThem)
{
    Problem problem = shaken_patch(true);
    State state = still(problem);
    EXPECT_EQ(first_time_step(problem, state).scheme, TimeScheme::implicit);
    EXPECT_EQ(first_time_step(problem, state).replaced, 0.0);
    std::get<SineMotion>(problem.base_motion).frequency = 2e3; // 1/200 of a period: 2.5 microseconds
    const TimeStep first = first_time_step(problem, state);
    EXPECT_EQ(first.scheme, TimeScheme::semi_implicit);
    EXPECT_EQ(first.limiter, TimeStepLimiter::vibration); // of the top row, a third full
    EXPECT_EQ(first.replaced, stable_time_step(problem, state).dt);
    Record record;
    run(problem, 10.0 * first.dt, {&record}, state);
    EXPECT_EQ(record.reports.front().time_step.scheme, first.scheme);
    EXPECT_NEAR(record.reports.front().time_step.dt, first.dt, 1e-6 * first.dt);
}

// The first step is told before the run, when the sand has no memory yet.
TEST(WaveSteps, AreToldOfSandsBeforeTheirMemoryBegins)
{
    Pm4Sand pm4sand;
    pm4sand.relative_density = 0.5;
    for (const SkeletonLaw& law :
         {SkeletonLaw(make_ubcsand(sand_of_runs())), SkeletonLaw(complete(pm4sand))}) {
        Problem problem = shaken_patch(true);
        problem.materials[0].law = law;
        State state = still(problem);
        for (Scalars* stress :
             {&state.particles.stress.xx, &state.particles.stress.yy, &state.particles.stress.zz})
            std::fill(stress->begin(), stress->end(), -20e3);
        const TimeStep told = first_time_step(problem, state);
        begin_shaking(problem, state);
        EXPECT_NEAR(first_time_step(problem, state).dt, told.dt, 1e-3 * told.dt) << law.index();
    }
}

TEST(WaveSteps, TheRunSaysOfWhichKindItsStepsAre)
{
    for (const bool saturated : {false, true}) {
        const Problem problem = shaken_patch(saturated);
        State state = still(problem);
        Record record;
        ASSERT_TRUE(run(problem, end_of_cycle, {&record}, state));
        const TimeScheme by_waves = saturated ? TimeScheme::semi_implicit : TimeScheme::explicit_steps;
        // the kind is chosen anew every 32 steps at the latest
        EXPECT_TRUE(are_all(record.schemes(0.0, 1.8e-3), TimeScheme::implicit)) << saturated;
        EXPECT_TRUE(are_all(record.schemes(3.5e-3, 3.9e-3), by_waves)) << saturated;
        EXPECT_TRUE(are_all(record.schemes(5.0e-3, 5.8e-3), TimeScheme::implicit)) << saturated;
        EXPECT_TRUE(are_all(record.schemes(7.5e-3, 7.9e-3), by_waves)) << saturated;
        const double longest = stable_time_step(with_scheme(problem, by_waves), state).dt;
        double last = 0.0;
        for (const StepReport& report : record.reports) {
            const TimeStep& step = report.time_step;
            EXPECT_EQ(step.replaced > 0.0, step.scheme == by_waves);
            if (step.scheme == by_waves) {
                EXPECT_LT(step.dt * 0.5 * (last + step.dt), 1.01 * longest * longest) << report.time;
            }
            last = step.dt;
            EXPECT_LT(step.replaced, 1.01 * state.implicit_cost * longest);
        }
    }
}

/// Looks into all steps, and counts those whose start and end it is shown with unlike schemes.
class Comparison final : public Observer {
public:
    double next_time() const override { return next; }
    bool looks_into_steps() const override { return true; }
    void before_step(const Problem& problem, const State&, double) override { at_start = problem.scheme; }
    void observe(const Problem& problem, const State& state, const StepReport&) override
    {
        unlike += state.step > 0 && at_start != problem.scheme;
        next = state.time + 1e-5;
    }

    TimeScheme at_start = TimeScheme::implicit;
    double next = 0.0; // [s]
    int unlike = 0;
};

// Columns of histories hang on the scheme: rows within wave steps had the values of other columns.
TEST(WaveSteps, StartAndEndForObserversInTheSchemeOfTheRun)
{
    const Problem problem = shaken_patch(true);
    State state = still(problem);
    Record record;
    Comparison comparison;
    ASSERT_TRUE(run(problem, 4e-3, {&record, &comparison}, state));
    EXPECT_EQ(record.reports.back().time_step.scheme, TimeScheme::semi_implicit);
    EXPECT_EQ(comparison.unlike, 0);
}

TEST(WaveSteps, GoOnWithTheSameBitsFromEveryRestartPoint)
{
    for (const bool saturated : {false, true}) {
        const Problem problem = shaken_patch(saturated);
        State whole = still(problem), parts = whole;
        ASSERT_TRUE(run(problem, end_of_cycle, {}, whole));
        int stops = 0;
        while (!run(problem, end_of_cycle, {}, parts, [] { return true; })) ++stops;
        EXPECT_GT(stops, 10);
        EXPECT_EQ(whole.step, parts.step);
        expect_same_bits(whole.particles, parts.particles);
    }
}

// What changes of kind put in or take out would be missing in the balance, which all kinds share.
TEST(WaveSteps, ChangesOfKindKeepTheEnergy)
{
    for (const bool saturated : {false, true}) {
        const Problem changing = shaken_patch(saturated);
        Problem alike = changing;
        alike.boundaries[2].soil = FreeFace{}; // implicit steps alone
        const auto error_of = [](const Problem& problem) {
            State state = still(problem);
            open_balances(problem, state);
            EXPECT_TRUE(run(problem, end_of_cycle, {}, state));
            EXPECT_EQ(state.times_halved, 0);
            return balance(problem, state).energy_error;
        };
        const Problem by_waves = with_scheme(changing, scheme_of_waves(changing));
        const double of_each = std::max(std::abs(error_of(alike)), std::abs(error_of(by_waves)));
        EXPECT_LT(std::abs(error_of(changing)), of_each + 1e-3) << saturated;
    }
}

} // namespace
} // namespace quicksand
