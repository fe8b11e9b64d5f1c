#include "io/files/background_writer.hpp"
#include "io/files/file_error.hpp"
#include "io/frames/frame_writer.hpp"
#include "io/frames/particle_frame.hpp"
#include "io/results/checkpoint.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

/// The frames' and the checkpoints' writer, with a first frame under way. Checkpoints keep the background
/// writer for longer than the frames' writer lives.
std::vector<std::unique_ptr<Observer>> writers_at_work(const std::filesystem::path& index,
                                                       const FrameSeries::MakeFrame& make_frame,
                                                       const Problem& problem, const State& state)
{
    const auto background = std::make_shared<BackgroundWriter>();
    std::vector<FrameSeries> all_series;
    all_series.push_back({VtkSeries(index), make_frame});
    std::vector<std::unique_ptr<Observer>> writers;
    writers.push_back(std::make_unique<FrameWriter>(std::move(all_series), ObservationClock(0.01, 0.02),
                                                    state.time, background));
    writers.push_back(
        std::make_unique<CheckpointWriter>(index.parent_path() / "state.h5", 1e9, state, "abc", background));
    writers.front()->observe(problem, state, {0, 0.0, {}, 0});
    return writers;
}

} // namespace

TEST(FrameWriter, WaitsAtItsEndForAFrameUnderWay)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    const State state = fixtures::small_state(problem);
    const auto slow = [](const Problem& drawn, const State& copy) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        return particle_frame(drawn, copy);
    };
    auto writers = writers_at_work(folder / "fields.pvd", slow, problem, state);
    writers.front().reset(); // as after a failure of the run: without finish()
    EXPECT_TRUE(std::filesystem::exists(folder / "fields.pvd")) << "the frame is complete";
    writers.clear();
}

TEST(FrameWriter, DropsTheFailureOfAFrameAtItsEnd)
{
    const TemporaryFolder folder;
    const Problem problem = fixtures::small_problem(true);
    const State state = fixtures::small_state(problem);
    const auto fail = [](const Problem&, const State&) -> Frame {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        throw FileError("frame.vtu", "cannot write the frame", "no space left on device", "");
    };
    auto writers = writers_at_work(folder / "fields.pvd", fail, problem, state);
    EXPECT_NO_THROW(writers.clear());
}

} // namespace quicksand
