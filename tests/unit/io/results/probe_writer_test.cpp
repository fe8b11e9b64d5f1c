#include "io/results/probe_writer.hpp"
#include "io/results/run_manifest.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

const RunLabel label{"block.toml", "0123456789abcdef"};

/// Rows without comments; the first is the header.
std::vector<std::vector<std::string>> table(const std::filesystem::path& path)
{
    std::vector<std::vector<std::string>> rows;
    std::ifstream stream(path);
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with('#')) continue;
        std::vector<std::string> cells;
        std::istringstream text(line);
        for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
        if (line.ends_with(',')) cells.emplace_back();
        rows.push_back(cells);
    }
    return rows;
}

std::string cell(const std::vector<std::vector<std::string>>& rows, std::size_t row,
                 const std::string& column)
{
    const auto found = std::find(rows[0].begin(), rows[0].end(), column);
    return rows.at(row).at(static_cast<std::size_t>(found - rows[0].begin()));
}

std::string header_of(const std::filesystem::path& path)
{
    std::ifstream stream(path);
    std::string line;
    while (std::getline(stream, line) && line.starts_with('#')) {
    }
    return line;
}

} // namespace

TEST(ProbeWriter, HeadersOfASaturatedScene)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    const State state = fixtures::small_state(problem);
    const ProbeWriter writer(fixtures::small_scene(), problem, state, label, folder.path(), false);
    const std::string columns =
        "x_m,y_m,ux_m,uy_m,vx_m_s,vy_m_s,ax_m_s2,ay_m_s2,pore_pressure_Pa,"
        "excess_pore_pressure_Pa,ru,mean_effective_stress_Pa,vertical_effective_stress_Pa,"
        "shear_stress_xy_Pa,shear_strain_xy";
    for (const char* name : {"rider", "point", "crest"})
        EXPECT_EQ(header_of(folder / "probes" / (std::string(name) + ".csv")), "time_s," + columns);
    EXPECT_EQ(header_of(folder / "probes/line.csv"), "time_s,distance_m," + columns);
    const std::string text = fixtures::text_of(folder / "probes/rider.csv");
    EXPECT_TRUE(text.starts_with("# Quicksand " + program_version() +
                                 "\n# scene: block.toml, hash 0123456789abcdef\n"
                                 "# probe: rider, material: rides with particle 27, nearest to (0.9, 0.9) m"))
        << text;
}

TEST(ProbeWriter, HeadersOfADrySceneHaveNoWater)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(false);
    const State state = fixtures::small_state(problem);
    ProbeWriter writer(fixtures::small_scene(), problem, state, label, folder.path(), false);
    EXPECT_EQ(header_of(folder / "probes/rider.csv"),
              "time_s,x_m,y_m,ux_m,uy_m,vx_m_s,vy_m_s,ax_m_s2,ay_m_s2,mean_effective_stress_Pa,"
              "vertical_effective_stress_Pa,shear_stress_xy_Pa,shear_strain_xy");
    writer.observe(problem, state, {});
    EXPECT_EQ(table(folder / "probes/point.csv")[1].size(), 13u);
}

TEST(ProbeWriter, AccelerationIsTheChangeOfVelocityOverTheInterval)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    ProbeWriter writer(fixtures::small_scene(), problem, state, label, folder.path(), false);
    for (int k = 0; k < 3; ++k) {
        state.time = writer.next_time();
        for (double& v : state.particles.velocity_solid.x) v = 5.0 * state.time;
        writer.observe(problem, state, {});
    }
    for (const char* name : {"rider", "point", "crest"}) {
        const auto rows = table(folder / "probes" / (std::string(name) + ".csv"));
        ASSERT_EQ(rows.size(), 4u);
        EXPECT_EQ(cell(rows, 1, "ax_m_s2"), "");
        EXPECT_EQ(cell(rows, 2, "time_s"), "0.002");
        EXPECT_NEAR(std::stod(cell(rows, 2, "ax_m_s2")), 5.0, 1e-12) << name;
        EXPECT_NEAR(std::stod(cell(rows, 3, "ax_m_s2")), 5.0, 1e-12) << name;
    }
    const auto profile = table(folder / "probes/line.csv");
    ASSERT_EQ(profile.size(), 1u + 3u * 4u);
    EXPECT_EQ(cell(profile, 2, "distance_m"), "0.5");
    EXPECT_NEAR(std::stod(cell(profile, 6, "ax_m_s2")), 5.0, 1e-12);
}

TEST(ProbeWriter, RowsWithinAStepLieBetweenItsEnds)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    ProbeWriter writer(fixtures::small_scene(), problem, state, label, folder.path(), false);
    writer.observe(problem, state, {});
    const auto move_to = [&](double time) {
        state.time = time;
        for (double& v : state.particles.velocity_solid.x) v = 5.0 * time;
    };
    move_to(0.001);
    writer.before_step(problem, state, 0.005);
    move_to(0.005); // beyond the rows of .002 and .004 s
    writer.observe(problem, state, {});
    EXPECT_EQ(writer.next_time(), 0.006);
    writer.before_step(problem, state, 0.006);
    move_to(0.006);
    writer.observe(problem, state, {});
    for (const char* name : {"rider", "point", "crest"}) {
        const auto rows = table(folder / "probes" / (std::string(name) + ".csv"));
        ASSERT_EQ(rows.size(), 5u) << name;
        for (std::size_t row = 1; row < rows.size(); ++row) {
            const double time = 0.002 * static_cast<double>(row - 1);
            EXPECT_NEAR(std::stod(cell(rows, row, "time_s")), time, 1e-15) << name;
            EXPECT_NEAR(std::stod(cell(rows, row, "vx_m_s")), 5.0 * time, 1e-15) << name;
        }
        EXPECT_NEAR(std::stod(cell(rows, 3, "ax_m_s2")), 5.0, 1e-12) << name;
    }
    EXPECT_EQ(table(folder / "probes/line.csv").size(), 1u + 4u * 4u);
}

TEST(ProbeWriter, AFixedPointWithoutSoilHasEmptyCells)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    const State state = fixtures::small_state(problem);
    Scene scene = fixtures::small_scene();
    scene.probes[1].at = Vector2(1.0, 2.4);
    ProbeWriter writer(scene, problem, state, label, folder.path(), false);
    writer.observe(problem, state, {});
    EXPECT_TRUE(fixtures::text_of(folder / "probes/point.csv").ends_with("\n0,1,2.4,,,,,,,,,,,,,\n"));
}

TEST(ProbeWriter, TheRiderIsFollowedThroughReordering)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    ProbeWriter writer(fixtures::small_scene(), problem, state, label, folder.path(), false);
    writer.observe(problem, state, {});
    std::vector<std::int32_t> order;
    for (std::size_t p = state.particles.size(); p-- > 0;) order.push_back(static_cast<std::int32_t>(p));
    reorder(state.particles, order);
    state.time = writer.next_time();
    writer.observe(problem, state, {});
    const auto rows = table(folder / "probes/rider.csv");
    EXPECT_EQ(cell(rows, 1, "x_m"), cell(rows, 2, "x_m"));
    EXPECT_EQ(cell(rows, 1, "y_m"), cell(rows, 2, "y_m"));
}

TEST(ProbeWriter, RefusesAMaterialProbeOutsideTheSoilAndOneWithoutAPlace)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    const State state = fixtures::small_state(problem);
    Scene scene = fixtures::small_scene();
    const auto refusal = [&] {
        try {
            const ProbeWriter writer(scene, problem, state, label, folder.path(), false);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    scene.probes[0].at = Vector2(50.0, 0.0);
    EXPECT_EQ(refusal(), "probe 'rider' at (50, 0) m lies outside the soil: the nearest particle is at "
                         "(1.875, 0.125) m");
    scene.probes[0].at.reset();
    EXPECT_EQ(refusal(), "probe 'rider' has no place: give it `at`");
    scene = fixtures::small_scene();
    scene.probes[3].to.reset();
    EXPECT_EQ(refusal(), "probe 'line' is a profile and has no end: give it `to`");
}

TEST(ProbeWriter, GoesOnAfterAKillBetweenTwoFiles)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    const Scene scene = fixtures::small_scene();
    {
        ProbeWriter writer(scene, problem, state, label, folder.path(), false);
        writer.observe(problem, state, {});
        state.time = 0.002;
        writer.observe(problem, state, {});
    }
    const std::string complete = fixtures::text_of(folder / "probes/crest.csv");
    std::ofstream(folder / "probes/crest.csv") << complete.substr(0, complete.size() - 5);
    ProbeWriter writer(scene, problem, state, label, folder.path(), true);
    EXPECT_EQ(writer.next_time(), 0.002);
    writer.observe(problem, state, {});
    EXPECT_EQ(fixtures::text_of(folder / "probes/crest.csv"), complete);
    EXPECT_EQ(table(folder / "probes/rider.csv").size(), 3u);
}

} // namespace quicksand
