#include "io/history_csv.hpp"
#include "tests/unit/io/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

std::string rows_of(const std::filesystem::path& path)
{
    const std::string text = fixtures::text_of(path);
    return text.substr(text.find("\ntime_s") + 1);
}

} // namespace

TEST(HistoryWriter, HeaderOfASaturatedScene)
{
    const fixtures::TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    const HistoryWriter writer(fixtures::small_scene(), problem, fixtures::small_state(problem),
                               {"a.toml", "0"}, folder / "history.csv", false);
    EXPECT_EQ(rows_of(folder / "history.csv"),
              "time_s,base_acceleration_m_s2,crest_settlement_m,max_displacement_m,max_velocity_m_s,"
              "max_excess_pore_pressure_Pa,max_ru,mass_fluid_kg,mass_solid_kg,volume_m3,momentum_x_N_s,"
              "momentum_y_N_s,kinetic_energy_J,limited_domains\n");
}

TEST(HistoryWriter, HeaderOfADryScene)
{
    const fixtures::TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(false);
    const HistoryWriter writer(fixtures::small_scene(), problem, fixtures::small_state(problem),
                               {"a.toml", "0"}, folder / "history.csv", false);
    EXPECT_EQ(
        rows_of(folder / "history.csv"),
        "time_s,base_acceleration_m_s2,crest_settlement_m,max_displacement_m,max_velocity_m_s,mass_solid_kg,"
        "volume_m3,momentum_x_N_s,momentum_y_N_s,kinetic_energy_J,limited_domains\n");
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
    const std::string rows = rows_of(folder / "history.csv");
    EXPECT_NE(rows.find("\n0.005,"), std::string::npos) << rows;
    EXPECT_NE(rows.find(",0.25,0.25,0,"), std::string::npos) << rows;
}

} // namespace quicksand
