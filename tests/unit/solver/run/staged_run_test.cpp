// The stages of a run, its stops, and the column that stands for its body.
#include "solver/base/failure.hpp"
#include "solver/run/staged_run.hpp"
#include "tests/fixtures/same_bits.hpp"
#include "tests/fixtures/soil_block.hpp"
#include "tests/fixtures/unsettled_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr RunControls one_column{end_of_run, ColumnsComputed::one, true};

Problem shaken_ground()
{
    Problem problem = tied_ground();
    problem.base_motion = SineMotion{2.0, 20.0, 100.0, 0.0};
    return problem;
}

void expect_same_run(const StagedRun& a, const StagedRun& b)
{
    EXPECT_EQ(a.state().step, b.state().step);
    EXPECT_EQ(a.state().time, b.state().time);
    expect_same_bits(a.state().particles, b.state().particles);
    std::vector<double> numbers;
    for_each_number(*a.state().balance_terms, [&](const char*, double value) { numbers.push_back(value); });
    std::size_t k = 0;
    for_each_number(*b.state().balance_terms,
                    [&](const char* name, double value) { EXPECT_EQ(value, numbers[k++]) << name; });
}

/// Remembers what it is shown, at the start and at the end.
class StageWitness : public Observer {
public:
    double next_time() const override { return next_; }
    void observe(const Problem& problem, const State& state, const StepReport&) override
    {
        cells_x.push_back(problem.grid.cells_x);
        particles.push_back(state.particles.size());
        next_ = state.time < end_of_run ? end_of_run : std::numeric_limits<double>::infinity();
    }
    void after_step(const StepReport& report) override { last_step = report.step; }
    void finish() override { ++finished; }

    std::vector<int> cells_x;
    std::vector<std::size_t> particles;
    std::int64_t last_step = 0;
    int finished = 0;

private:
    double next_ = 0.0;
};

TEST(StagedRun, SettlesAndThenShakes)
{
    const Problem body = shaken_ground();
    StagedRun run(body, unsettled_ground(body, 0.5), whole_body);
    EXPECT_FALSE(run.is_shaking());
    EXPECT_FALSE(run.is_finished());
    EXPECT_THROW(run.shake({}), InternalError);

    const RelaxationReport report = run.settle(loosely);
    EXPECT_TRUE(report.settled);
    EXPECT_LE(report.unbalanced.of_weight, loosely.tolerance);
    EXPECT_TRUE(run.is_shaking());
    EXPECT_FALSE(run.is_finished());
    EXPECT_EQ(run.state().step, 0);
    EXPECT_TRUE(run.state().balance_terms.has_value());
    EXPECT_THROW(run.settle(loosely), InternalError);
    EXPECT_THROW(run.begin_shaking(), InternalError);

    EXPECT_TRUE(run.shake({}));
    EXPECT_TRUE(run.is_finished());
    EXPECT_EQ(run.state().time, end_of_run);
}

TEST(StagedRun, BeginsWithoutSettlingAndWithoutBalances)
{
    const Problem body = shaken_ground();
    StagedRun run(body, unsettled_ground(body, 0.5), {end_of_run, ColumnsComputed::one});
    EXPECT_EQ(run.begin_shaking(), 0u); // elastic soil carries any stress
    EXPECT_TRUE(run.is_shaking());
    EXPECT_FALSE(run.state().balance_terms.has_value());
}

TEST(StagedRun, GoesOnFromAStopInEitherStageToTheSameBits)
{
    const Problem body = shaken_ground();
    const State drawn = unsettled_ground(body, 0.5);
    const StopRule at_once = [] { return true; };
    for (const RunControls& controls : {whole_body, one_column}) {
        StagedRun whole(body, drawn, controls);
        const std::int64_t steps = whole.settle(loosely).steps;
        ASSERT_TRUE(whole.shake({}));

        StagedRun settling(body, drawn, controls);
        const RelaxationReport stopped = settling.settle(loosely, {}, at_once);
        EXPECT_FALSE(stopped.settled);
        ASSERT_LT(stopped.steps, steps);
        EXPECT_FALSE(settling.is_shaking());

        StagedRun shaking(body, drawn, controls, settling.state());
        EXPECT_FALSE(shaking.is_shaking());
        EXPECT_EQ(shaking.settle(loosely).steps, steps);
        StageWitness witness;
        EXPECT_FALSE(shaking.shake({&witness}, at_once));
        EXPECT_EQ(witness.finished, 1);
        EXPECT_GT(shaking.state().time, 0.0);
        EXPECT_FALSE(shaking.is_finished());

        StagedRun last(body, drawn, controls, shaking.state());
        EXPECT_TRUE(last.is_shaking());
        EXPECT_TRUE(last.shake({}));
        expect_same_run(whole, last);
    }
}

TEST(StagedRun, SettledSoilIsNotStopped)
{
    // where the last check finds the soil at rest there is nothing to go on with
    const Problem body = shaken_ground();
    StagedRun whole(body, unsettled_ground(body, 0.5), whole_body);
    const std::int64_t steps = whole.settle(loosely).steps;
    StagedRun run(body, unsettled_ground(body, 0.5), whole_body);
    std::int64_t seen = 0;
    const RelaxationReport report = run.settle(
        loosely, [&](const SettlingProgress& now) { seen = now.steps; }, [&] { return seen >= steps; });
    EXPECT_TRUE(report.settled);
    EXPECT_EQ(report.steps, steps);
    EXPECT_LT(seen, steps);
}

TEST(StagedRun, ShowsTheBodyWhoseColumnIsComputed)
{
    const Problem body = shaken_ground();
    StagedRun all(body, unsettled_ground(body, 0.5), whole_body),
        one(body, unsettled_ground(body, 0.5), one_column);
    EXPECT_EQ(all.column(), nullptr);
    ASSERT_NE(one.column(), nullptr);
    EXPECT_EQ(&one.body(), &body);
    EXPECT_EQ(one.problem().grid.cells_x, 1);
    StageWitness of_all, of_one;
    for (auto [run, witness] : {std::pair(&all, &of_all), std::pair(&one, &of_one)}) {
        run->settle(loosely);
        EXPECT_TRUE(run->shake({witness}));
        EXPECT_EQ(witness->cells_x, std::vector<int>(2, 9));
        EXPECT_EQ(witness->particles, std::vector<std::size_t>(2, 60));
        EXPECT_EQ(witness->last_step, run->state().step);
        EXPECT_EQ(witness->finished, 1);
    }
    EXPECT_EQ(&all.state_of_body(), &all.state());
    EXPECT_EQ(one.state().particles.size(), 6u);
    const State& wide = one.state_of_body();
    EXPECT_EQ(wide.particles.size(), 60u);
    EXPECT_EQ(wide.time, end_of_run);
    EXPECT_EQ(wide.balance_terms->base_work, 5.0 * one.state().balance_terms->base_work);
}

TEST(StagedRun, TellsWhyAllColumnsAreComputed)
{
    const Problem body = shaken_ground();
    State uneven = unsettled_ground(body, 0.5);
    uneven.particles.stress.xy[17] += 1.0;
    StagedRun run(body, uneven, one_column);
    EXPECT_EQ(run.column(), nullptr);
    EXPECT_EQ(run.obstacle(), "the soil does not repeat from cell to cell");
    EXPECT_EQ(run.state().particles.size(), 60u);
    EXPECT_EQ(StagedRun(body, uneven, whole_body).obstacle(), ""); // nobody asks
}

TEST(StagedRun, GoesOnWithAllColumnsWhereTheKeptStateHasThem)
{
    const Problem body = shaken_ground();
    StagedRun all(body, unsettled_ground(body, 0.5), whole_body);
    all.settle(loosely);
    StagedRun run(body, unsettled_ground(body, 0.5), one_column, all.state());
    EXPECT_EQ(run.column(), nullptr);
    EXPECT_TRUE(run.shake({}));
    EXPECT_TRUE(all.shake({}));
    expect_same_run(all, run);
}

TEST(StagedRun, HasNothingLeftToDoAtItsEnd)
{
    const Problem body = shaken_ground();
    StagedRun run(body, unsettled_ground(body, 0.5), one_column);
    run.begin_shaking();
    ASSERT_TRUE(run.shake({}));
    StagedRun again(body, unsettled_ground(body, 0.5), one_column, run.state());
    EXPECT_TRUE(again.is_finished());
    StageWitness witness;
    EXPECT_TRUE(again.shake({&witness}, [] { return true; })); // shows what is due, and takes no step
    EXPECT_EQ(witness.particles.size(), 1u);
    EXPECT_EQ(witness.finished, 1);
    expect_same_run(run, again);
}

TEST(StagedRun, ACopyRunsOnItsOwn)
{
    const Problem body = shaken_ground();
    for (const RunControls& controls : {whole_body, one_column}) {
        StagedRun run(body, unsettled_ground(body, 0.5), controls);
        StagedRun copy = run;
        copy.begin_shaking();
        EXPECT_TRUE(copy.shake({}));
        EXPECT_FALSE(run.is_shaking());
        EXPECT_EQ(run.state().step, 0);
    }
}

} // namespace
} // namespace quicksand
