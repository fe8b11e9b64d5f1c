// Stages that go on from the end of another one.
#include "solver/base/failure.hpp"
#include "solver/run/stage_start.hpp"
#include "solver/run/staged_run.hpp"
#include "tests/fixtures/same_bits.hpp"
#include "tests/fixtures/soil_block.hpp"
#include "tests/fixtures/unsettled_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace quicksand {
namespace {

using namespace fixtures;

/// Liquefiable ground under strong shaking.
Problem sandy_ground()
{
    Problem problem = tied_ground();
    for (Material& material : problem.materials) material.law = make_ubcsand(ubcsand_from_blow_count(8.0));
    problem.scheme = TimeScheme::semi_implicit;
    problem.base_motion = SineMotion{3.0, 20.0, 100.0, 0.0};
    return problem;
}

StagedRun settled(const Problem& problem)
{
    StagedRun run(problem, unsettled_ground(problem, 0.8), whole_body);
    run.settle(loosely);
    return run;
}

StagedRun going_on(const Problem& problem, const State& reached, const StageStart& start)
{
    StagedRun run(problem, unsettled_ground(problem, 0.8), whole_body);
    run.go_on_from(reached, start);
    return run;
}

TEST(StageStart, GoesOnFromSettledSoilToTheSameBits)
{
    const Problem problem = sandy_ground();
    StagedRun run = settled(problem);
    StagedRun stage = going_on(problem, run.state(), {.zero_pressures = true});
    expect_same_bits(run.state().particles, stage.state().particles);
    ASSERT_TRUE(run.shake({}));
    ASSERT_TRUE(stage.shake({}));
    EXPECT_EQ(run.state().step, stage.state().step);
    expect_same_bits(run.state().particles, stage.state().particles);
}

TEST(StageStart, CountsTimeAndPressuresFromItsStart)
{
    const Problem problem = sandy_ground();
    StagedRun run = settled(problem);
    run.shake({});
    const State& end = run.state();
    const StagedRun kept = going_on(problem, end, {}),
                    counted = going_on(problem, end, {.zero_pressures = true});
    EXPECT_EQ(kept.state().time, 0.0);
    EXPECT_EQ(kept.state().particles.pore_pressure, end.particles.pore_pressure);
    EXPECT_EQ(counted.state().particles.pore_pressure, end.particles.pore_pressure);
    double largest = 0.0;
    for (std::size_t p = 0; p < end.particles.size(); ++p) {
        EXPECT_EQ(risen_pore_pressure(problem, kept.state().particles, p), end.particles.pore_pressure[p]);
        EXPECT_NEAR(risen_pore_pressure(problem, counted.state().particles, p), 0.0, 1e-8);
        EXPECT_EQ(counted.state().particles.initial_vertical_effective_stress[p],
                  -end.particles.stress.yy[p]);
        largest = std::max(largest, end.particles.pore_pressure[p]);
    }
    EXPECT_GT(largest, 1000.0); // Pa
}

TEST(StageStart, CountsDisplacementsFromItsStartWhereAsked)
{
    for (const StrainForm strain : {StrainForm::large, StrainForm::small}) {
        Problem problem = sandy_ground();
        problem.strain = strain;
        StagedRun run = settled(problem);
        run.shake({});
        const StagedRun kept = going_on(problem, run.state(), {}),
                        zero = going_on(problem, run.state(), {.zero_displacements = true});
        EXPECT_EQ(kept.state().particles.position.x, run.state().particles.position.x);
        EXPECT_EQ(kept.state().particles.stress.xy, run.state().particles.stress.xy);
        const Particles& particles = zero.state().particles;
        EXPECT_EQ(particles.position.x, particles.reference_position.x);
        EXPECT_NE(run.state().particles.position.x, run.state().particles.reference_position.x);
        // the equations of small strain stay on the drawn shape
        const Particles& end = run.state().particles;
        EXPECT_EQ(particles.position.x,
                  strain == StrainForm::small ? end.reference_position.x : end.position.x);
    }
}

/// Largest displacement downward of the stages before [m].
double former_settlement(const StagedRun& run)
{
    const Scalars& y = run.state().particles.former_displacement.y;
    return -*std::min_element(y.begin(), y.end());
}

TEST(StageStart, AddsUpTheDisplacementsOfAllStagesButTheFirstSettling)
{
    for (const StrainForm strain : {StrainForm::large, StrainForm::small}) {
        Problem problem = sandy_ground();
        problem.strain = strain;
        State drawn = unsettled_ground(problem, 0.8);
        add_former_displacement(drawn.particles);
        StagedRun first(problem, drawn, whole_body);
        first.settle(loosely);
        EXPECT_EQ(former_settlement(first), 0.0);
        const Scalars before = first.state().particles.position.y;

        problem.gravity *= 1.5;
        StagedRun second(problem, drawn, whole_body);
        second.go_on_from(first.state(), {.settles = true});
        second.settle(loosely);
        const double settled = former_settlement(second);
        EXPECT_GT(settled, 1e-6);
        const Particles& particles = second.state().particles;
        EXPECT_EQ(particles.position.y, particles.reference_position.y);
        if (strain == StrainForm::large) {
            double moved = 0.0;
            for (std::size_t p = 0; p < before.size(); ++p)
                moved = std::max(moved, before[p] - particles.position.y[p]);
            EXPECT_NEAR(moved, settled, 1e-12);
        }

        second.shake({});
        StagedRun third(problem, drawn, whole_body);
        third.go_on_from(second.state(), {.zero_displacements = true});
        const Particles &end = second.state().particles, &counted = third.state().particles;
        for (std::size_t p = 0; p < end.size(); ++p)
            EXPECT_NEAR(counted.former_displacement.x[p],
                        end.former_displacement.x[p] + end.position.x[p] - end.reference_position.x[p],
                        1e-15);
    }
}

// Elements of the shaking acted on in a later one, if only another soil remembered anything in between.
TEST(StageStart, ForgetsWhatALawOfTheStageDoesNotRemember)
{
    const Problem sand = sandy_ground();
    Problem damped = sand;
    LinearElastic law{30e6, 0.3};
    law.damping_ratio = 0.05;
    damped.materials[0].law = law;
    StagedRun run(damped, unsettled_ground(damped, 0.8), whole_body);
    run.settle(loosely);
    run.shake({});
    Problem undamped_form = damped;
    undamped_form.materials[0].law = undamped(law);
    const auto most = [](const StagedRun& stage) {
        const Particles& particles = stage.state().particles;
        double largest = 0.0;
        for (std::size_t p = 0; p < particles.size(); ++p)
            if (particles.material[p] == 0) largest = std::max(largest, std::abs(particles.memory[2][p]));
        return largest;
    };
    ASSERT_GT(most(run), 0.0);
    EXPECT_EQ(most(going_on(undamped_form, run.state(), {})), 0.0);
}

TEST(StageStart, LetsTheMemoryOfChangedSoilBeginAnew)
{
    const Problem problem = sandy_ground();
    StagedRun run = settled(problem);
    run.shake({});
    const std::size_t column = column_of(memory_of(problem.materials[0].law), "half_cycles");
    const auto most = [&](const StagedRun& stage) {
        const Scalars& values = stage.state().particles.memory.at(column);
        return *std::max_element(values.begin(), values.end());
    };
    ASSERT_GT(most(run), 0.0);
    EXPECT_EQ(most(going_on(problem, run.state(), {.changed_soils = {false, true}})), most(run));
    EXPECT_EQ(most(going_on(problem, run.state(), {.changed_soils = {true, false}})), 0.0);
}

// Its factor of hardening and its s_0 were zero: the run ended with NaN.
TEST(StageStart, LetsAHistoryBeginThatTheStageBeforeDidNotKeep)
{
    Problem problem = sandy_ground();
    StagedRun run = settled(problem);
    run.shake({});
    for (Material& material : problem.materials) std::get<UbcSand>(material.law).reconsolidation = 0.3;
    StagedRun stage = going_on(problem, run.state(), {});
    const LawMemory memory = memory_of(problem.materials[0].law);
    const SoilMemory& columns = stage.state().particles.memory;
    const Scalars &factors = columns.at(column_of(memory, "start_factor")),
                  &means = columns.at(column_of(memory, "start_mean"));
    const Particles& particles = stage.state().particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        EXPECT_EQ(factors[p], 1.0);
        EXPECT_GE(means[p], 0.75 * particles.initial_vertical_effective_stress[p]);
    }
    EXPECT_TRUE(stage.shake({}));
}

TEST(StageStart, TakesTheGrainsOfChangedSoil)
{
    Problem problem = sandy_ground();
    StagedRun run = settled(problem);
    problem.materials[0].grain_density = 2700.0;
    State heavier = unsettled_ground(problem, 0.8);
    StagedRun stage(problem, heavier, whole_body);
    stage.go_on_from(run.state(), {.settles = true, .changed_soils = {true, true}});
    EXPECT_FALSE(stage.is_shaking());
    const double porosity = problem.materials[0].porosity;
    const Particles& particles = stage.state().particles;
    for (std::size_t p = 0; p < particles.size(); ++p)
        EXPECT_DOUBLE_EQ(particles.mass_solid[p], (1.0 - porosity) * 2700.0 * particles.volume[p]);
}

TEST(StageStart, LetsGrainsBearWhatTheWaterBoreWhereTheSoilIsDryNow)
{
    const Problem wet = sandy_ground();
    StagedRun run = settled(wet);
    run.shake({});
    const Particles& before = run.state().particles;
    Problem fallen = wet;
    fallen.materials.push_back(wet.materials.front());
    fallen.materials.back().saturated = false;
    State initial = unsettled_ground(fallen, 0.8);
    initial.particles.material.back() = static_cast<std::int32_t>(wet.materials.size());
    const std::size_t dry = initial.particles.size() - 1;
    ASSERT_GT(before.pore_pressure[dry], 100.0); // Pa
    const State state = begin_stage(fallen, initial, run.state(), {});
    const Particles& after = state.particles;
    EXPECT_EQ(after.pore_pressure[dry], 0.0);
    EXPECT_DOUBLE_EQ(after.stress.xx[dry], before.stress.xx[dry] - before.pore_pressure[dry]);
    EXPECT_DOUBLE_EQ(after.stress.yy[dry], before.stress.yy[dry] - before.pore_pressure[dry]);
    EXPECT_DOUBLE_EQ(after.stress.zz[dry], before.stress.zz[dry] - before.pore_pressure[dry]);
    EXPECT_EQ(after.stress.xy[dry], before.stress.xy[dry]);
    EXPECT_EQ(after.pore_pressure.front(), before.pore_pressure.front());
    EXPECT_EQ(after.stress.yy.front(), before.stress.yy.front());
}

TEST(StageStart, RefusesAnotherNumberOfParticles)
{
    const Problem problem = sandy_ground();
    const StagedRun run = settled(problem);
    RunControls one = whole_body;
    one.columns = ColumnsComputed::one;
    StagedRun column(problem, level_state(problem), one);
    ASSERT_NE(column.column(), nullptr);
    EXPECT_THROW(column.go_on_from(run.state(), {}), InputError);
}

} // namespace
} // namespace quicksand
