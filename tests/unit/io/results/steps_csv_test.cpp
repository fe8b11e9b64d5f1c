#include "io/results/steps_csv.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {

TEST(StepsWriter, TellsTheStepThatWasNotShortenedForOutput)
{
    const fixtures::TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    StepsWriter writer(fixtures::small_scene(), problem, state, {"a.toml", "0"}, folder / "steps.csv", false);
    StepReport report;
    writer.observe(problem, state, report);
    report.time_step = {1e-4, TimeStepLimiter::wave, "sand"};
    writer.after_step(report);
    report.time_step = {1e-9, TimeStepLimiter::output, "sand"};
    report.step = 7;
    writer.after_step(report);
    state.time = writer.next_time();
    writer.observe(problem, state, report);
    const std::string rows = fixtures::rows_of(folder / "steps.csv");
    EXPECT_TRUE(rows.starts_with(
        "time_s,step,dt_s,dt_limiter,dt_material,dt_scheme,dt_replaced_s,wall_s,eta_s,mass_kg,mass_error,"
        "momentum_x_N_s,momentum_y_N_s,kinetic_J,max_velocity_m_s,max_ru\n0,0,,,,,,"))
        << rows;
    EXPECT_NE(rows.find("\n0.005,7,0.0001," + std::string(name_of(TimeStepLimiter::wave)) + ",sand,"),
              std::string::npos)
        << rows;
}

TEST(StepsWriter, AStepThatPassesSeveralTimesHasOneRowAtItsEnd)
{
    const fixtures::TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    StepsWriter writer(fixtures::small_scene(), problem, state, {"a.toml", "0"}, folder / "steps.csv", false);
    writer.observe(problem, state, {});
    StepReport report;
    report.step = 1;
    report.time_step = {0.0125, TimeStepLimiter::growth, ""};
    state.time = 0.0125;
    writer.observe(problem, state, report);
    EXPECT_EQ(writer.next_time(), 0.015);
    const std::string rows = fixtures::rows_of(folder / "steps.csv");
    EXPECT_NE(rows.find("\n0.0125,1,0.0125,growth from step to step,,"), std::string::npos) << rows;
    EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 3) << rows;
}

TEST(StepsWriter, TellsTheSchemeOfAStepAndTheImplicitOneThatItReplaces)
{
    const fixtures::TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    const State state = fixtures::small_state(problem);
    const auto row_of = [&](const TimeStep& step, const char* file) {
        StepsWriter writer(fixtures::small_scene(), problem, state, {"a.toml", "0"}, folder / file, false);
        StepReport report;
        report.time_step = step;
        writer.after_step(report);
        writer.observe(problem, state, report);
        return fixtures::rows_of(folder / file);
    };
    const TimeStep implicit{3e-4, TimeStepLimiter::shaking, "", TimeScheme::implicit, 0.0},
        by_waves{1e-4, TimeStepLimiter::wave, "sand", TimeScheme::semi_implicit, 2e-4};
    EXPECT_NE(row_of(implicit, "a.csv").find(",0.0003,period of the shaking,,implicit,,"), std::string::npos);
    EXPECT_NE(row_of(by_waves, "b.csv").find(",0.0001,wave,sand,semi-implicit,0.0002,"), std::string::npos);
}

TEST(StepsWriter, AMaterialsNameDoesNotBreakItsRow)
{
    const fixtures::TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    const State state = fixtures::small_state(problem);
    StepsWriter writer(fixtures::small_scene(), problem, state, {"a.toml", "0"}, folder / "steps.csv", false);
    StepReport report;
    report.time_step = {1e-4, TimeStepLimiter::wave, "sand, \"fine\"\n"};
    writer.after_step(report);
    writer.observe(problem, state, report);
    const std::string rows = fixtures::rows_of(folder / "steps.csv");
    EXPECT_NE(rows.find(",sand_ _fine__,"), std::string::npos) << rows;
}

TEST(StepsWriter, MassErrorCountsFromTheFirstRowAlsoAfterAResume)
{
    const fixtures::TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    const Scene scene = fixtures::small_scene();
    {
        StepsWriter writer(scene, problem, state, {"a.toml", "0"}, folder / "steps.csv", false);
        writer.observe(problem, state, {});
    }
    state.time = 0.005;
    for (double& mass : state.particles.mass_solid) mass *= 2.0;
    for (double& porosity : state.particles.porosity) porosity *= 2.0;
    StepsWriter writer(scene, problem, state, {"a.toml", "0"}, folder / "steps.csv", true);
    writer.observe(problem, state, {});
    CsvFile file =
        CsvFile::resume(folder / "steps.csv", {},
                        {"time_s", "step", "dt_s", "dt_limiter", "dt_material", "dt_scheme", "dt_replaced_s",
                         "wall_s", "eta_s", "mass_kg", "mass_error", "momentum_x_N_s", "momentum_y_N_s",
                         "kinetic_J", "max_velocity_m_s", "max_ru"},
                        1.0);
    EXPECT_NEAR(file.value(file.last_rows().back(), "mass_error"), 1.0, 1e-12);
    EXPECT_GE(file.value(file.last_rows().back(), "wall_s"), file.value(*file.first_row(), "wall_s"));
}

} // namespace quicksand
