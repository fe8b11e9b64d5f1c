#include "io/files/atomic_file.hpp"
#include "io/files/file_error.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/run_manifest.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <thread>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

/// A state whose every number is another one.
State varied_state(bool saturated, bool with_cycles = false)
{
    const Problem problem = fixtures::small_problem(saturated);
    State state = fixtures::small_state(problem);
    if (with_cycles) add_memory(state.particles, 15);
    double value = 1.0 / 3.0;
    for_each_array(state.particles, [&](const char*, Scalars& values) {
        for (double& entry : values) entry += (value += 1.0 / 7.0);
    });
    state.time = 0.1;
    state.step = 12345678901;
    if (saturated) {
        state.balance_terms.emplace();
        for_each_number(*state.balance_terms,
                        [&](const char*, double& entry) { entry = value += 1.0 / 7.0; });
    }
    if (saturated) state.reactions = {{1.0 / 3.0, -2e5, 0.0}, {7.0, 1.0 / 9.0, 1e-300}}; // a viscous base

    state.last_step = 1.0 / 7.0;
    state.whole_step = 2.0 / 7.0;
    return state;
}

bool same_bits(const State& a, const State& b)
{
    std::vector<Scalars> of_a;
    for_each_array(a.particles, [&](const char*, const Scalars& values) { of_a.push_back(values); });
    bool same = a.time == b.time && a.step == b.step && a.last_step == b.last_step &&
                a.whole_step == b.whole_step && a.stage == b.stage && a.reactions.x == b.reactions.x &&
                a.reactions.y == b.reactions.y;
    std::size_t k = 0;
    for_each_array(b.particles, [&](const char*, const Scalars& values) {
        const Scalars& other = of_a[k++];
        same =
            same && values.size() == other.size() &&
            (values.empty() || std::memcmp(values.data(), other.data(), values.size() * sizeof(double)) == 0);
    });
    std::vector<double> balances[2];
    for (const State* state : {&a, &b}) {
        if (!state->balance_terms) continue;
        for_each_number(*state->balance_terms,
                        [&](const char*, double entry) { balances[state == &b].push_back(entry); });
    }
    same = same && a.balance_terms.has_value() == b.balance_terms.has_value() && balances[0] == balances[1];
    return same && a.particles.identifier == b.particles.identifier &&
           a.particles.material == b.particles.material && a.particles.region == b.particles.region;
}

void write_text(const std::filesystem::path& path, const std::string& text)
{
    std::ofstream(path, std::ios::binary) << text;
}

/// What is said of a checkpoint that cannot be read.
template <class Failure>
std::string checkpoint_refusal(const std::filesystem::path& path)
{
    try {
        read_checkpoint(path, "abc");
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "";
}

} // namespace

TEST(Checkpoint, ReadsBackToTheSameBits)
{
    const TemporaryFolder folder;
    for (const bool saturated : {true, false}) {
        for (const bool with_cycles : {true, false}) {
            const State written = varied_state(saturated, with_cycles);
            write_checkpoint(folder / "checkpoint/state.h5", written, "abc");
            EXPECT_TRUE(same_bits(written, read_checkpoint(folder / "checkpoint/state.h5", "abc")));
        }
    }
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

TEST(Checkpoint, OfEqualStatesIsTheSameFileAtAnyTime)
{
    const TemporaryFolder folder;
    const State state = varied_state(true, true);
    write_checkpoint(folder / "first.h5", state, "abc");
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // HDF5 counts whole seconds
    write_checkpoint(folder / "second.h5", state, "abc");
    EXPECT_TRUE(read_text(folder / "first.h5") == read_text(folder / "second.h5"));
}

TEST(Checkpoint, KeepsTheTwistOfQuadrilaterals)
{
    const TemporaryFolder folder;
    State written = varied_state(true);
    written.particles.twist.x = written.particles.volume;
    written.particles.twist.y = written.particles.stress.xx;
    write_checkpoint(folder / "state.h5", written, "abc");
    EXPECT_TRUE(same_bits(written, read_checkpoint(folder / "state.h5", "abc")));
}

TEST(Checkpoint, KeepsTheWaterTable)
{
    const TemporaryFolder folder;
    State written = varied_state(true);
    written.particles.water_table = written.particles.stress.xy;
    write_checkpoint(folder / "state.h5", written, "abc");
    EXPECT_TRUE(same_bits(written, read_checkpoint(folder / "state.h5", "abc")));
}

TEST(Checkpoint, KeepsTheArraysOfEveryFlowOfWater)
{
    const TemporaryFolder folder;
    for (const WaterFlow flow : {WaterFlow::coupled, WaterFlow::undrained, WaterFlow::drained}) {
        Problem problem = fixtures::small_problem(true);
        problem.water->flow = flow;
        problem.water->cavitation_pressure = 2e3;
        const State written = fixtures::small_state(problem);
        EXPECT_EQ(written.particles.tension_deficit.empty(), flow == WaterFlow::drained);
        write_checkpoint(folder / "state.h5", written, "abc");
        const State read = read_checkpoint(folder / "state.h5", "abc");
        EXPECT_TRUE(same_bits(written, read));
        EXPECT_EQ(carried_flow(read.particles), flow);
    }
}

TEST(Checkpoint, KeepsTheColumnsOfFreeFields)
{
    TemporaryFolder folder;
    const auto path = folder / "checkpoint.h5";
    State state = varied_state(true);
    state.free_fields = {{varied_state(true, true), {}}, {varied_state(true), {}}};
    state.free_fields[1].column.time = 0.2;
    write_checkpoint(path, state, "a hash");
    const State back = read_checkpoint(path, "a hash");
    EXPECT_TRUE(same_bits(back, state));
    ASSERT_EQ(back.free_fields.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_TRUE(same_bits(back.free_fields[k].column, state.free_fields[k].column));
}

TEST(Checkpoint, AMissingFileIsTheUsers)
{
    EXPECT_EQ(checkpoint_refusal<InputError>("/nowhere/state.h5"),
              "/nowhere/state.h5: there is no checkpoint to resume from");
}

TEST(Checkpoint, AnotherScenesIsRefused)
{
    const TemporaryFolder folder;
    write_checkpoint(folder / "state.h5", varied_state(true), "abc");
    try {
        read_checkpoint(folder / "state.h5", "xyz");
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("another scene (hash abc, this one has xyz)"),
                  std::string::npos);
    }
}

TEST(Checkpoint, ATruncatedFileIsAFileError)
{
    const TemporaryFolder folder;
    write_checkpoint(folder / "state.h5", varied_state(true), "abc");
    const std::string text = fixtures::text_of(folder / "state.h5");
    for (const std::size_t size : {std::size_t(0), std::size_t(100), text.size() / 2, text.size() - 1}) {
        write_text(folder / "state.h5", text.substr(0, size));
        EXPECT_EQ(checkpoint_refusal<FileError>(folder / "state.h5"),
                  (folder / "state.h5").string() + ": cannot read the checkpoint: it is damaged at: " +
                      (size == 0 ? "its end, it is cut off" : "its checksum") +
                      "; start the run anew with --overwrite")
            << size;
    }
}

TEST(Checkpoint, AFileOfAnotherKindIsAFileError)
{
    const TemporaryFolder folder;
    write_text(folder / "state.h5", "notes" + text_hash("notes"));
    EXPECT_NE(checkpoint_refusal<FileError>(folder / "state.h5").find("it is damaged at: opening the file"),
              std::string::npos);
}

TEST(Checkpoint, AFlippedByteIsAFileErrorWhereverItIs)
{
    const TemporaryFolder folder;
    write_checkpoint(folder / "state.h5", varied_state(true), "abc");
    const std::string text = fixtures::text_of(folder / "state.h5");
    for (std::size_t place = 0; place < text.size(); place += 211) {
        std::string damaged = text;
        damaged[place] = static_cast<char>(damaged[place] ^ 0x55);
        write_text(folder / "state.h5", damaged);
        EXPECT_THROW(read_checkpoint(folder / "state.h5", "abc"), FileError) << "byte " << place;
    }
}

TEST(Checkpoint, AFullDiskKeepsTheFormerOne)
{
    const TemporaryFolder folder;
    const State former = varied_state(true);
    write_checkpoint(folder / "state.h5", former, "abc");
    State later = former;
    later.time = 0.2;
    {
        const fixtures::FullDisk full(4096);
        EXPECT_THROW(write_checkpoint(folder / "state.h5", later, "abc"), FileError);
    }
    EXPECT_TRUE(same_bits(former, read_checkpoint(folder / "state.h5", "abc")));
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

TEST(Checkpoint, WriterWritesWhenItsWallTimeHasPassed)
{
    const TemporaryFolder folder;
    const State state = varied_state(true);
    const auto background = std::make_shared<BackgroundWriter>();
    CheckpointWriter patient(folder / "patient.h5", 3600.0, state, "abc", background);
    CheckpointWriter eager(folder / "eager.h5", 1e-9, state, "abc", background);
    StepReport report;
    eager.after_step(report); // no restart point
    EXPECT_FALSE(std::filesystem::exists(folder / "eager.h5"));
    report.is_restart_point = true;
    patient.after_step(report);
    eager.after_step(report);
    eager.finish();
    EXPECT_FALSE(std::filesystem::exists(folder / "patient.h5"));
    EXPECT_TRUE(same_bits(state, read_checkpoint(folder / "eager.h5", "abc")));
}

} // namespace quicksand
