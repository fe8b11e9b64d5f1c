#include "io/files/background_writer.hpp"
#include "io/files/file_error.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>
#include <vector>

namespace quicksand {

namespace {

State state_at(double time)
{
    State state;
    state.time = time;
    return state;
}

[[noreturn]] void fail(const State&)
{
    throw FileError("frame.vtu", "cannot write the frame", "no space left on device", "");
}

} // namespace

TEST(BackgroundWriter, GivesTheJobTheStateAsItWas)
{
    BackgroundWriter writer;
    State state = state_at(1.0);
    std::promise<void> changed;
    double seen = 0.0;
    writer.write(state, [&](const State& copy) {
        changed.get_future().wait();
        seen = copy.time;
    });
    state.time = 2.0; // the run goes on
    changed.set_value();
    writer.finish();
    EXPECT_EQ(seen, 1.0);
}

TEST(BackgroundWriter, DoesOneJobAtATimeInTheirOrder)
{
    BackgroundWriter writer;
    std::vector<double> times;
    std::atomic<int> under_way = 0, most = 0;
    for (const double time : {1.0, 2.0, 3.0, 4.0}) {
        writer.write(state_at(time), [&](const State& copy) {
            most = std::max<int>(most, ++under_way);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            times.push_back(copy.time);
            --under_way;
        });
    }
    writer.finish();
    EXPECT_EQ(times, (std::vector<double>{1.0, 2.0, 3.0, 4.0}));
    EXPECT_EQ(most, 1);
}

TEST(BackgroundWriter, ThrowsAFailureOnceWhereItIsAskedNext)
{
    BackgroundWriter writer;
    writer.write(State{}, fail);
    EXPECT_THROW(writer.finish(), FileError);
    EXPECT_NO_THROW(writer.finish());
    writer.write(State{}, fail);
    EXPECT_THROW(writer.write(State{}, [](const State&) {}), FileError);
    writer.write(State{}, fail);
    bool thrown = false;
    for (int k = 0; k < 5000 && !thrown; ++k) {
        try {
            writer.report_failure();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        } catch (const FileError&) {
            thrown = true;
        }
    }
    EXPECT_TRUE(thrown);
}

TEST(BackgroundWriter, ReportsNoFailureOfAJobUnderWay)
{
    std::promise<void> end;
    BackgroundWriter writer;
    writer.write(State{}, [&](const State& state) {
        end.get_future().wait();
        fail(state);
    });
    EXPECT_NO_THROW(writer.report_failure()); // and does not wait
    end.set_value();
    EXPECT_THROW(writer.finish(), FileError);
}

TEST(BackgroundWriter, KeepsTheFailureOfAJobThatWasWaitedFor)
{
    BackgroundWriter writer;
    writer.write(State{}, fail);
    EXPECT_NO_THROW(writer.wait());
    EXPECT_THROW(writer.finish(), FileError);
    EXPECT_NO_THROW(writer.wait()) << "nothing is under way";
}

TEST(BackgroundWriter, IsWaitedForAtItsEnd)
{
    bool done = false;
    {
        BackgroundWriter writer;
        writer.write(State{}, [&](const State& state) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            done = true;
            fail(state); // dropped
        });
    }
    EXPECT_TRUE(done);
}

} // namespace quicksand
