#include "io/files/csv_file.hpp"
#include "io/files/file_error.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/output_names.hpp"
#include "io/results/output_observers.hpp"
#include "io/results/result_reader.hpp"
#include "solver/measure/quantities.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

void run_to(double end_time, const Scene& scene, const Problem& problem, State& state,
            const std::filesystem::path& results, bool resume, const std::function<bool()>& stop = {})
{
    const auto observers = make_output_observers(scene, problem, state, {results, "abc", "abc", resume});
    std::vector<Observer*> pointers;
    for (const auto& observer : observers) pointers.push_back(observer.get());
    run(problem, end_time, pointers, state, stop);
}

/// The text of every result file by name. Wall times differ from run to run, so steps.csv stays out.
std::map<std::string, std::string> texts_in(const std::filesystem::path& results)
{
    std::map<std::string, std::string> texts;
    for (const auto& item : std::filesystem::recursive_directory_iterator(results)) {
        const std::string name = item.path().lexically_relative(results).string();
        if (item.is_regular_file() && name != "steps.csv" && !name.starts_with("checkpoint"))
            texts[name] = fixtures::text_of(item.path());
    }
    return texts;
}

} // namespace

TEST(OutputObservers, WriteEverySeriesAtItsTimes)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    Scene scene = fixtures::small_scene();
    scene.output.checkpoint_interval = 1e-9;
    run_to(scene.end_time, scene, problem, state, folder.path(), false);
    EXPECT_EQ(read_series_index(folder / "fields.pvd").size(), 3u);
    EXPECT_EQ(read_series_index(folder / "grid.pvd").size(), 3u);
    for (const std::string& name : output_names(scene))
        EXPECT_TRUE(std::filesystem::exists(folder.path() / name)) << name;
    EXPECT_EQ(read_checkpoint(folder / "checkpoint/state.h5", "abc").time, scene.end_time);
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

TEST(OutputObservers, AResumedRunLeavesTheSameFilesAsAnUnbrokenOne)
{
    const TemporaryFolder unbroken, broken;
    const Problem problem = fixtures::small_problem(true);
    const Scene scene = fixtures::small_scene();
    State state = fixtures::small_state(problem);
    run_to(scene.end_time, scene, problem, state, unbroken.path(), false);

    // Stop somewhere between two rows, keep that state, and run on a little: rows the resume must drop.
    state = fixtures::small_state(problem);
    run_to(scene.end_time, scene, problem, state, broken.path(), false, [&] { return state.time > 0.0111; });
    write_checkpoint(broken / "checkpoint/state.h5", state, "abc");
    State lost = state;
    run_to(0.0165, scene, problem, lost, broken.path(), true);
    State resumed = read_checkpoint(broken / "checkpoint/state.h5", "abc");
    run_to(scene.end_time, scene, problem, resumed, broken.path(), true);

    const auto expected = texts_in(unbroken.path()), found = texts_in(broken.path());
    EXPECT_EQ(found.size(), expected.size());
    for (const auto& [name, text] : expected)
        EXPECT_TRUE(found.contains(name) && found.at(name) == text) << name;
}

TEST(OutputObservers, AFullDiskStopsTheRunAndKeepsTheFramesBefore)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    Scene scene = fixtures::small_scene();
    scene.output.probe_interval = scene.output.history_interval = 0.0;
    State state = fixtures::small_state(problem);
    run_to(0.0111, scene, problem, state, folder.path(), false);
    {
        const fixtures::FullDisk full(2000); // enough for the index, not for a frame
        EXPECT_THROW(run_to(scene.end_time, scene, problem, state, folder.path(), true), FileError);
    }
    for (const char* name : {"fields.pvd", "grid.pvd"}) {
        const std::vector<FrameEntry> entries = read_series_index(folder / name);
        EXPECT_EQ(entries.size(), 2u) << name;
        for (const FrameEntry& entry : entries)
            EXPECT_EQ(read_frame(folder.path() / entry.file).time, entry.time);
    }
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

TEST(OutputObservers, ExtractionFromTheGridAgreesWithTheFixedProbe)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    const Scene scene = fixtures::small_scene();
    run_to(scene.end_time, scene, problem, state, folder.path(), false);
    const HistoryTable table = extract_history(
        folder.path(), {*scene.probes[1].at, {"pore_pressure", "velocity_solid_x"}, ProbeKind::fixed});
    std::vector<std::string> columns{"time_s"};
    for (const Quantity* quantity : quantities_of(at_probes))
        for (std::size_t c = 0; have(state.particles, *quantity) && c < component_count(quantity->form); ++c)
            columns.push_back(probe_column(*quantity, c));
    for (const auto& row : table.rows) {
        const TemporaryFolder copy;
        std::filesystem::copy_file(folder / "probes/point.csv", copy / "point.csv");
        const CsvFile probe = CsvFile::resume(copy / "point.csv", {}, columns, row[0]);
        EXPECT_EQ(probe.last_time(), row[0]);
        EXPECT_NEAR(probe.value(probe.last_rows()[0], "pore_pressure_Pa"), row[1], 1e-9 * std::abs(row[1]));
        EXPECT_NEAR(probe.value(probe.last_rows()[0], "vx_m_s"), row[2], 1e-9 * std::abs(row[2]));
    }
}

TEST(OutputObservers, ADrySceneRunsWithoutFluidFields)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(false);
    State state = fixtures::small_state(problem);
    const Scene scene = fixtures::small_scene();
    run_to(scene.end_time, scene, problem, state, folder.path(), false);
    const auto index = read_series_index(folder / "fields.pvd");
    EXPECT_FALSE(read_particle_frame(folder.path() / index.back().file).scalars.contains("ru"));
}

TEST(OutputObservers, AnIntervalOfZeroLeavesTheWriterOut)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    const State state = fixtures::small_state(problem);
    Scene scene = fixtures::small_scene();
    scene.output = {};
    EXPECT_TRUE(make_output_observers(scene, problem, state, {folder.path(), "abc", "abc", false}).empty());
    EXPECT_TRUE(output_names(scene).empty());
}

} // namespace quicksand
