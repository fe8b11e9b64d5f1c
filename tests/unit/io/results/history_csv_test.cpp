#include "io/results/history_csv.hpp"
#include "solver/measure/balances.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {

TEST(HistoryWriter, HeaderOfASaturatedScene)
{
    const fixtures::TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    const HistoryWriter writer(fixtures::small_scene(), problem, fixtures::small_state(problem),
                               {"a.toml", "0"}, folder / "history.csv", false);
    EXPECT_EQ(fixtures::rows_of(folder / "history.csv"),
              "time_s,base_acceleration_m_s2,crest_settlement_m,max_displacement_m,max_velocity_m_s,"
              "max_excess_pore_pressure_Pa,max_ru,mass_fluid_kg,mass_solid_kg,volume_m3,momentum_x_N_s,"
              "momentum_y_N_s,kinetic_energy_J,limited_domains,mean_stress_checkerboard,mean_stress_scatter,"
              "pore_pressure_checkerboard,kinetic_energy_water_J,storage_energy_water_J,"
              "pore_volume_m3,water_content_m3\n");
    EXPECT_NE(fixtures::text_of(folder / "history.csv")
                  .find("# limited_domains: particle domains scaled down in the last step, as they reached "
                        "farther than 2.5 cells from their centre\n"),
              std::string::npos);
}

TEST(HistoryWriter, HeaderOfASaturatedSceneWithBalances)
{
    const fixtures::TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    open_balances(problem, state);
    const HistoryWriter writer(fixtures::small_scene(), problem, state, {"a.toml", "0"},
                               folder / "history.csv", false);
    EXPECT_NE(fixtures::rows_of(folder / "history.csv")
                  .find(",water_content_m3,skeleton_work_J,gravity_work_J,base_work_J,boundary_work_J,"
                        "numerical_loss_J,energy_error,impulse_x_N_s,impulse_y_N_s,momentum_error_x_N_s,"
                        "momentum_error_y_N_s,drag_dissipation_J,water_outflow_m3,water_error\n"),
              std::string::npos);
}

TEST(HistoryWriter, HeaderOfADryScene)
{
    const fixtures::TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(false);
    const HistoryWriter writer(fixtures::small_scene(), problem, fixtures::small_state(problem),
                               {"a.toml", "0"}, folder / "history.csv", false);
    EXPECT_EQ(
        fixtures::rows_of(folder / "history.csv"),
        "time_s,base_acceleration_m_s2,crest_settlement_m,max_displacement_m,max_velocity_m_s,mass_solid_kg,"
        "volume_m3,momentum_x_N_s,momentum_y_N_s,kinetic_energy_J,limited_domains,mean_stress_checkerboard,"
        "mean_stress_scatter\n");
}

TEST(HistoryWriter, CrestIsThatOfTheStartHoweverTheSoilHasMoved)
{
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    const auto crest = reference_crest(state.particles);
    EXPECT_EQ(crest.size(), 8u);
    state.particles.position.y[0] += 10.0;
    EXPECT_EQ(reference_crest(state.particles), crest);
}

TEST(HistoryWriter, RowsFollowTheIntervalAndCountSettlementDownward)
{
    const fixtures::TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    HistoryWriter writer(fixtures::small_scene(), problem, state, {"a.toml", "0"}, folder / "history.csv",
                         false);
    writer.observe(problem, state, {});
    EXPECT_EQ(writer.next_time(), 0.005);
    state.time = writer.next_time();
    for (double& y : state.particles.position.y) y -= 0.25;
    writer.observe(problem, state, {});
    const std::string rows = fixtures::rows_of(folder / "history.csv");
    EXPECT_NE(rows.find("\n0.005,"), std::string::npos) << rows;
    EXPECT_NE(rows.find(",0.25,0.25,0,"), std::string::npos) << rows;
}

TEST(HistoryWriter, RowsWithinAStepLieBetweenItsEnds)
{
    const fixtures::TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    HistoryWriter writer(fixtures::small_scene(), problem, state, {"a.toml", "0"}, folder / "history.csv",
                         false);
    writer.observe(problem, state, {});
    state.time = 0.0025;
    writer.before_step(problem, state, 0.0125);
    state.time = 0.0125;
    for (double& y : state.particles.position.y) y -= 0.25;
    StepReport report;
    report.limited_domains = 3;
    writer.observe(problem, state, report);
    EXPECT_EQ(writer.next_time(), 0.015);
    const std::string rows = fixtures::rows_of(folder / "history.csv");
    EXPECT_NE(rows.find("\n0.005,"), std::string::npos) << rows;
    EXPECT_NE(rows.find(",0.0625,0.0625,0,"), std::string::npos) << rows;
    EXPECT_NE(rows.find("\n0.01,"), std::string::npos) << rows;
    EXPECT_NE(rows.find(",0.1875,0.1875,0,"), std::string::npos) << rows;
    EXPECT_EQ(rows.find(",1.5,"), std::string::npos) << "domains are counted in whole steps";
    EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 4) << rows;
}

} // namespace quicksand
