#include "io/frames/grid_frame.hpp"
#include "io/frames/particle_frame.hpp"
#include "io/results/result_reader.hpp"
#include "io/results/stage_table.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

/// Three frames of the block: moved 0.01 m to the right a frame, the excess pressure growing with height.
void write_results(const TemporaryFolder& folder)
{
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    VtkSeries fields(folder / "fields.pvd"), grid(folder / "grid.pvd");
    for (int k = 0; k < 3; ++k) {
        state.time = 0.1 * k;
        for (std::size_t p = 0; p < state.particles.size(); ++p) {
            state.particles.position.x[p] = state.particles.reference_position.x[p] + 0.01 * k;
            state.particles.pore_pressure[p] = 100.0 * k;
        }
        fields.append(particle_frame(problem, state));
        grid.append(grid_frame(problem, nodal_fields(problem, state.particles), state.time));
        reorder(state.particles, [&] {
            std::vector<std::int32_t> order;
            for (std::size_t p = state.particles.size(); p-- > 0;)
                order.push_back(static_cast<std::int32_t>(p));
            return order;
        }());
    }
}

std::string extraction_refusal(const std::filesystem::path& results, const ExtractRequest& request)
{
    try {
        extract_history(results, request);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(ResultReader, FixedPointFollowsTheGrid)
{
    const TemporaryFolder folder;
    write_results(folder);
    const HistoryTable table = extract_history(
        folder.path(), {{1.1, 0.7}, {"excess_pore_pressure", "displacement", "ru"}, ProbeKind::fixed});
    EXPECT_EQ(table.columns, (std::vector<std::string>{"time_s", "excess_pore_pressure_Pa",
                                                       "displacement_x_m", "displacement_y_m", "ru"}));
    ASSERT_EQ(table.rows.size(), 3u);
    EXPECT_EQ(table.rows[1][0], 0.1);
    EXPECT_NEAR(table.rows[2][1], 200.0, 1e-9);
    EXPECT_NEAR(table.rows[2][2], 0.02, 1e-12);
}

TEST(ResultReader, MaterialPointRidesWithItsParticle)
{
    const TemporaryFolder folder;
    write_results(folder);
    const HistoryTable table =
        extract_history(folder.path(), {{0.9, 0.9},
                                        {"particle_id", "velocity_solid_y", "displacement_x", "stress_xy"},
                                        ProbeKind::material});
    ASSERT_EQ(table.rows.size(), 3u);
    EXPECT_EQ(table.columns[2], "velocity_solid_y_m_s");
    for (const auto& row : table.rows) EXPECT_EQ(row[1], 27.0);
    EXPECT_NEAR(table.rows[2][3], 0.02, 1e-7);
}

TEST(ResultReader, AnUnknownFieldGetsASuggestionAndTheList)
{
    const TemporaryFolder folder;
    write_results(folder);
    const std::string text =
        extraction_refusal(folder.path(), {{1.0, 1.0}, {"pore_presure"}, ProbeKind::fixed});
    EXPECT_NE(text.find("there is no field 'pore_presure' in the results; did you mean 'pore_pressure'?"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("Available: displacement, "), std::string::npos) << text;
}

TEST(ResultReader, APointOutsideTheSoilGetsTheBounds)
{
    const TemporaryFolder folder;
    write_results(folder);
    for (const ProbeKind kind : {ProbeKind::fixed, ProbeKind::material}) {
        const std::string text = extraction_refusal(folder.path(), {{40.0, 1.0}, {"ru"}, kind});
        EXPECT_NE(text.find("never inside the soil, which reaches from"), std::string::npos) << text;
    }
}

TEST(ResultReader, AFolderWithoutResultsIsTheUsers)
{
    const TemporaryFolder folder;
    EXPECT_THROW(extract_history(folder.path(), {{0.0, 0.0}, {"ru"}, ProbeKind::fixed}), InputError);
    const VtkSeries empty(folder / "grid.pvd");
    EXPECT_NE(extraction_refusal(folder.path(), {{0.0, 0.0}, {"ru"}, ProbeKind::fixed}).find("no frames yet"),
              std::string::npos);
}

TEST(ResultReader, TakesNoPointsOfTheSurface)
{
    const TemporaryFolder folder;
    EXPECT_EQ(extraction_refusal(folder.path(), {{0.0, 0.0}, {"ru"}, ProbeKind::surface}),
              "only fixed and material points can be extracted from the frames");
}

TEST(ResultReader, ParticleFrameHasOneNumberADomain)
{
    const TemporaryFolder folder;
    write_results(folder);
    const auto index = read_series_index(folder / "fields.pvd");
    const ParticleFrame frame = read_particle_frame(folder.path() / index[1].file);
    EXPECT_EQ(frame.time, 0.1);
    ASSERT_EQ(frame.domains.size(), 48u);
    for (const auto& [name, values] : frame.scalars) EXPECT_EQ(values.size(), 48u) << name;
    EXPECT_NEAR(frame.scalars.at("displacement_x")[0], 0.01, 1e-8);
    EXPECT_EQ(frame.units.at("stress_xy"), "Pa");
    EXPECT_EQ(frame.material_names, std::vector<std::string>{"sand"});
    EXPECT_EQ(frame.region_names, std::vector<std::string>{"ground"});
}

/// Stages of three frames each: displacements go on from `shaking` to `after`, and begin anew in `next`.
TEST(ResultReader, DisplacementsOfAStageCountFromTheStageThatBeganWithoutThem)
{
    const TemporaryFolder folder;
    write_results(folder);
    const ParticleFrame drawn = read_frame_of_origin(folder.path());
    EXPECT_EQ(drawn.time, 0.0);
    for (const char* stage : {"shaking", "after", "next"}) {
        std::filesystem::create_directories(folder / stage);
        std::filesystem::copy(folder / "fields", folder / stage / "fields");
        std::filesystem::copy(folder / "fields.pvd", folder / stage);
    }
    const auto frames = read_series_index(folder / "fields.pvd");
    std::filesystem::copy_file(folder.path() / frames[1].file, folder / "after" / frames[0].file,
                               std::filesystem::copy_options::overwrite_existing);
    write_stage_table(folder.path(), {{"shaking", "shake", "finished", 0.0, 0.2},
                                      {"after", "consolidate", "finished", 0.2, 0.2},
                                      {"next", "settle", "finished", 0.4, 0.0}});
    EXPECT_EQ(read_frame_of_origin(folder / "after").domains, drawn.domains);
    EXPECT_EQ(read_frame_of_origin(folder.path() / "after" / "").domains, drawn.domains);
    EXPECT_EQ(read_frame_of_origin(folder / "next").domains, drawn.domains);
    std::filesystem::remove(folder / "stages.csv");
    EXPECT_NE(read_frame_of_origin(folder / "after").domains, drawn.domains) << "its own first frame";
}

TEST(ResultReader, TheTableBecomesACsvFile)
{
    const TemporaryFolder folder;
    write_history_table(folder / "out.csv", {{"time_s", "ru"}, {{0.0, std::nan("")}, {0.5, 0.25}}});
    EXPECT_EQ(fixtures::text_of(folder / "out.csv"), "time_s,ru\n0,\n0.5,0.25\n");
}

} // namespace quicksand
