// A run gives the same bits whatever the number of threads, and however often it was stopped.
#include "io/results/checkpoint.hpp"
#include "io/results/run_record.hpp"
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstring>
#include <utility>
#include <vector>

namespace quicksand {

namespace {

using namespace testing_program;

const std::string end_time = "run.end_time=4e-3";
// All columns, for one alone is computed before a signal reaches it.
const std::string column_run =
    "run " + example("column") + " --set " + end_time + " --set analysis.columns='\"all\"' -o ";

State final_state(const std::filesystem::path& results)
{
    return read_checkpoint(results / "checkpoint/state.h5",
                           read_run_record(results / "run_manifest.json").state_hash);
}

void expect_same_bits(const State& a, const State& b)
{
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.step, b.step);
    std::vector<Scalars> arrays;
    for_each_array(a.particles, [&](const char*, const Scalars& values) { arrays.push_back(values); });
    std::size_t k = 0;
    for_each_array(b.particles, [&](const char* name, const Scalars& values) {
        ASSERT_EQ(values.size(), arrays[k].size()) << name;
        EXPECT_EQ(std::memcmp(values.data(), arrays[k].data(), values.size() * sizeof(double)), 0) << name;
        ++k;
    });
}

void write_file(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
}

/// Take out the line that holds the text.
void remove_line(const std::filesystem::path& file, const std::string& text)
{
    std::string content = read_file(file);
    const std::size_t place = content.find(text);
    ASSERT_NE(place, std::string::npos) << file;
    const std::size_t begin = content.rfind('\n', place) + 1;
    write_file(file, content.erase(begin, content.find('\n', begin) + 1 - begin));
}

/// What a kill over the last frame and the last rows leaves of a finished run.
void cut_end_off(const std::filesystem::path& results)
{
    for (const std::string series : {"fields", "grid"}) {
        remove_line(results / (series + ".pvd"), "frame_000002.vtu");
        ASSERT_TRUE(std::filesystem::remove(results / series / "frame_000002.vtu"));
    }
    remove_line(results / "history.csv", "\n0.004,");
    remove_line(results / "probes/middle.csv", "\n0.004,");
    const std::filesystem::path manifest = results / "run_manifest.json";
    std::string text = read_file(manifest);
    const std::string finished = "\"status\": \"finished\"";
    ASSERT_NE(text.find(finished), std::string::npos) << text;
    write_file(manifest, text.replace(text.find(finished), finished.size(), "\"status\": \"running\""));
}

/// Run the program with these words and send it the signal once the shell's test holds.
Outcome run_until(const std::string& words, const std::string& test, const std::string& signal = "TERM")
{
    return run_shell("\"$QUICKSAND\" " + words +
                     " & pid=$!\n"
                     "for k in $(seq 3000); do\n"
                     "  " +
                     test +
                     " && break\n"
                     "  sleep 0.01\n"
                     "done\n"
                     "kill -" +
                     signal + " $pid; wait $pid");
}

class SameBits : public ::testing::Test {
protected:
    void SetUp() override
    {
        const Outcome whole = run_program(column_run + (folder / "whole").string() + " --threads 2");
        ASSERT_EQ(whole.code, 0) << whole.output;
    }

    void expect_same_files(const std::string& other)
    {
        for (const char* name : {"probes/upper.csv", "probes/middle.csv", "probes/surface.csv",
                                 "probes/centre_line.csv", "history.csv", "fields.pvd",
                                 "fields/frame_000001.vtu", "grid/frame_000001.vtu", "checkpoint/state.h5"}) {
            EXPECT_EQ(read_file(folder / ("whole/" + std::string(name))),
                      read_file(folder / (other + "/" + name)))
                << name;
        }
    }

    WorkFolder folder;
};

TEST_F(SameBits, ForAnyNumberOfThreads)
{
    const Outcome single = run_program(column_run + (folder / "single").string() + " --threads 1");
    ASSERT_EQ(single.code, 0) << single.output;
    expect_same_bits(final_state(folder / "whole"), final_state(folder / "single"));
    expect_same_files("single");
}

TEST_F(SameBits, AfterAStopAtAFrameAndAResume)
{
    const std::string results = (folder / "parts").string();
    ASSERT_EQ(run_program(column_run + results + " --until 2e-3").code, 0);
    const Outcome second = run_program(column_run + results + " --resume");
    ASSERT_EQ(second.code, 0) << second.output;
    expect_same_bits(final_state(folder / "whole"), final_state(results));
}

TEST_F(SameBits, AfterAKillAndAResume)
{
    const std::string results = (folder / "killed").string();
    const Outcome killed =
        run_until(column_run + results, "grep -q '^0.0004,' " + results + "/history.csv 2>/dev/null");
    ASSERT_EQ(killed.code, 0) << killed.output;
    EXPECT_NE(
        killed.output.find("\nStopping at the next restart point, a few dozen steps on at most. A second "
                           "Ctrl-C or kill ends the run at once.\n"),
        std::string::npos)
        << killed.output;
    EXPECT_NE(killed.output.find("Stopped on request"), std::string::npos) << killed.output;
    EXPECT_NE(read_file(results + "/run_manifest.json").find("\"status\": \"stopped\""), std::string::npos);
    const Outcome resumed = run_program(column_run + results + " --resume");
    ASSERT_EQ(resumed.code, 0) << resumed.output;
    EXPECT_NE(read_file(results + "/run_manifest.json").find("resumed_at_s"), std::string::npos);
    expect_same_bits(final_state(folder / "whole"), final_state(results));
    expect_same_files("killed");
}

TEST_F(SameBits, AfterAKillAtTheEndTimeAndAResume)
{
    const std::string results = (folder / "cut").string();
    std::filesystem::copy(folder / "whole", results, std::filesystem::copy_options::recursive);
    cut_end_off(results);
    const Outcome resumed = run_program(column_run + results + " --resume");
    ASSERT_EQ(resumed.code, 0) << resumed.output;
    EXPECT_NE(resumed.output.find("No step was left: the results reach t = 0.004 s, and what was missing at "
                                  "their end is written."),
              std::string::npos)
        << resumed.output;
    EXPECT_NE(read_file(results + "/run_manifest.json").find("\"status\": \"finished\""), std::string::npos);
    expect_same_bits(final_state(folder / "whole"), final_state(results));
    expect_same_files("cut");
    for (const char* name : {"grid.pvd", "fields/frame_000002.vtu", "grid/frame_000002.vtu", "steps.csv"})
        EXPECT_EQ(read_file(folder / ("whole/" + std::string(name))), read_file(results + "/" + name))
            << name;
    const Outcome again = run_program(column_run + results + " --resume");
    EXPECT_NE(again.output.find("Nothing to do: the results reach t = 0.004 s already."), std::string::npos)
        << again.output;
}

TEST(LastFrame, IsWrittenByAResumeWhereTheRunCouldNot)
{
    const WorkFolder folder;
    const std::string results = (folder / "results").string();
    // a folder in the frame's place fails its writing after the checkpoint of the same time
    std::filesystem::create_directories(results + "/fields/frame_000002.vtu/in_the_way");
    const std::string run = column_run + results + " --set output.checkpoint_interval=1e-6";
    const Outcome failed = run_program(run);
    EXPECT_EQ(failed.code, 4) << failed.output;
    EXPECT_NE(failed.output.find("frame_000002.vtu: cannot"), std::string::npos) << failed.output;
    EXPECT_NE(read_file(results + "/run_manifest.json").find("\"status\": \"failed\""), std::string::npos);
    std::filesystem::remove_all(results + "/fields/frame_000002.vtu");
    const Outcome resumed = run_program(run + " --resume");
    EXPECT_EQ(resumed.code, 0) << resumed.output;
    EXPECT_NE(read_file(results + "/run_manifest.json").find("\"status\": \"finished\""), std::string::npos);
    for (const std::string series : {"fields", "grid"}) {
        EXPECT_TRUE(std::filesystem::is_regular_file(results + "/" + series + "/frame_000002.vtu")) << series;
        EXPECT_NE(read_file(results + "/" + series + ".pvd").find("frame_000002.vtu"), std::string::npos);
    }
}

TEST(Hangup, StopsARunWithACheckpoint)
{
    const WorkFolder folder;
    const std::string results = (folder / "hung_up").string();
    std::signal(SIGHUP, SIG_DFL); // for the program: under nohup it is ignored, and then stays so
    const Outcome outcome =
        run_until(column_run + results, "grep -q '^0.0004,' " + results + "/history.csv 2>/dev/null", "HUP");
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("Stopped on request"), std::string::npos) << outcome.output;
    EXPECT_TRUE(std::filesystem::exists(results + "/checkpoint/state.h5"));
}

TEST(Pipe, WhoseReaderLeavesEndsNoRun)
{
    const WorkFolder folder;
    const std::string results = (folder / "results").string(), code = (folder / "code").string();
    std::signal(SIGPIPE, SIG_DFL); // for the shell: what it ignores its programs ignore
    const Outcome outcome = run_shell("{ \"$QUICKSAND\" " + column_run + results + "; echo $? >" + code +
                                      "; } 2>/dev/null | head -n 1");
    EXPECT_EQ(outcome.output, "Saturated column at 120 g, sine 180 Hz of 24 g\n");
    EXPECT_EQ(read_file(code), "0\n");
    EXPECT_NE(read_file(results + "/run_manifest.json").find("\"status\": \"finished\""), std::string::npos);
    EXPECT_NE(read_file(results + "/log.txt").find(" steps to t = 0.004 s in "), std::string::npos);
}

TEST(FileSizeLimit, EndsARunAsAFullDiskDoes)
{
    const WorkFolder folder;
    const std::string results = (folder / "results").string();
    // rows of the profile come to 16 MB, far more than the other files: its file is the one that is too large
    const std::string run = "run " + example("column") + " -o " + results +
                            " --set run.end_time=1e-3 --set output.probe_interval=2e-6"
                            " --set probes.centre_line.points=400 --set output.frame_interval=1e-4"
                            " --set output.checkpoint_interval=0.01";
    const Outcome failed = run_shell("ulimit -f 8000\n\"$QUICKSAND\" " + run); // of 512 byte
    EXPECT_EQ(failed.code, 4) << failed.output;
    EXPECT_NE(failed.output.find("centre_line.csv: cannot write: File too large"), std::string::npos)
        << failed.output;
    const std::string manifest = read_file(results + "/run_manifest.json");
    EXPECT_NE(manifest.find("\"status\": \"failed\""), std::string::npos) << manifest;
    EXPECT_NE(manifest.find("File too large"), std::string::npos) << manifest;
    const Outcome resumed = run_program(run + " --resume");
    EXPECT_EQ(resumed.code, 0) << resumed.output;
    EXPECT_NE(resumed.output.find("Going on with "), std::string::npos) << resumed.output;
    EXPECT_EQ(run_program("picture " + results + " --field ru -o " + (folder / "ru.png").string()).code, 0);
}

TEST(Benchmark, StopsWithItsRun)
{
    for (const auto& [name, message] :
         {std::pair("grid", "Stopped on request. The runs before are in "),
          std::pair("error", "Stopped on request. What was measured before is in ")}) {
        const WorkFolder folder;
        const Outcome outcome =
            run_until("bench " + std::string(name) + ' ' + example("column") + " -o " + folder.string(),
                      "[ -f " + folder.string() + "/column/*/steps.csv ]");
        EXPECT_EQ(outcome.code, 0) << outcome.output;
        EXPECT_NE(outcome.output.find(message), std::string::npos) << outcome.output;
    }
}

TEST(Settling, GoesOnWhereItWasStopped)
{
    const WorkFolder folder;
    const std::string run =
        "run " + example("dike") +
        " --set grid.cell_size=0.015 --set relaxation.tolerance=1e-4 --set run.end_time=1e-4"
        " --set output.checkpoint_interval=0.001 --threads 1 -o ";
    const Outcome whole = run_program(run + (folder / "whole").string());
    ASSERT_EQ(whole.code, 0) << whole.output;
    const std::string results = (folder / "stopped").string();
    const Outcome stopped = run_until(run + results, "[ -f " + results + "/checkpoint/state.h5 ]");
    ASSERT_EQ(stopped.code, 0) << stopped.output;
    EXPECT_NE(
        stopped.output.find("Stopped on request while settling. Go on with the same command and --resume."),
        std::string::npos)
        << stopped.output;
    EXPECT_NE(stopped.output.find(" times the tolerance, largest at ("), std::string::npos) << stopped.output;
    EXPECT_TRUE(std::filesystem::exists(results + "/settling.pvd"));
    EXPECT_TRUE(std::filesystem::exists(results + "/settling.png"));
    const Outcome resumed = run_program(run + results + " --resume");
    ASSERT_EQ(resumed.code, 0) << resumed.output;
    EXPECT_FALSE(std::filesystem::exists(results + "/settling.pvd")) << "it has settled since";
    EXPECT_EQ(read_file(results + "/history.csv"), read_file(folder / "whole/history.csv"));
    EXPECT_EQ(read_file(results + "/fields.pvd"), read_file(folder / "whole/fields.pvd"));
}

// The end of the run decides which steps suit it.
TEST(Resume, KeepsTheSchemeThatWasChosen)
{
    const WorkFolder folder;
    const std::string run =
        "run " + example("column") + " --set 'analysis.scheme=\"auto\"' -o " + (folder / "results").string();
    const auto scheme = [&] { return read_run_record(folder / "results/run_manifest.json").scheme; };
    ASSERT_EQ(run_program(run + " --set run.end_time=1e-3").code, 0);
    EXPECT_EQ(scheme(), TimeScheme::explicit_steps);
    const Outcome resumed = run_program(run + " --set run.end_time=0.01 --resume --until 2e-3");
    EXPECT_EQ(resumed.code, 0) << resumed.output;
    EXPECT_EQ(scheme(), TimeScheme::explicit_steps);
    ASSERT_EQ(run_program(run + " --set run.end_time=0.01 --overwrite --until 1e-3").code, 0);
    EXPECT_EQ(scheme(), TimeScheme::semi_implicit);
}

} // namespace

} // namespace quicksand
