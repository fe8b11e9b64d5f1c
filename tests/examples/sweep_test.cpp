// A sweep of four short runs: interrupted, gone on with, collected, and handed to other programs.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace quicksand {

namespace {

using namespace testing_program;

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& file)
{
    std::ifstream stream(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// In a folder whose name needs quotes in a shell.
class SweepProgram : public testing::Test {
protected:
    void SetUp() override
    {
        fs::create_directory(folder / "it's");
        write("");
    }
    void write(const std::string& more, const std::string& second = "\"24 g\"") const
    {
        std::ofstream(sweep) << "sweep_version = 1\nscene = \"" << example("column")
                             << "\"\nset = [\"run.end_time=1e-3\", \"output.history_interval=1e-4\"]\n"
                                "[vary.\"motion.amplitude\"]\nvalues = [\"12 g\", "
                             << second << "]\n[vary.\"materials.sand.porosity\"]\nvalues = [0.405, 0.42]\n"
                             << more;
    }
    Outcome call(const std::string& words) const
    {
        return run_program("sweep \"" + sweep.string() + "\" -o \"" + out.string() + "\" --threads 1 " +
                           words);
    }
    fs::path manifest(int run) const { return out / ("run_000" + std::to_string(run)) / "run_manifest.json"; }
    /// What sweep.csv has in a run's row.
    std::string row(int run) const
    {
        for (const std::string& line : lines_of(out / "sweep.csv"))
            if (line.starts_with(std::to_string(run) + ",")) return line;
        return "";
    }

    WorkFolder folder;
    const fs::path sweep = folder / "it's" / "sweep.toml", out = folder / "it's" / "out";
};

TEST_F(SweepProgram, DoesWhatIsMissing)
{
    const Outcome first = call("--jobs 2");
    ASSERT_EQ(first.code, 0) << first.output;
    expect_mention(first, "4 runs, 4 left to do, 2 at a time with 1 thread each");
    expect_mention(first, "4 runs: 4 finished (4 ");
    EXPECT_TRUE(fs::exists(out / "sweep.png"));
    EXPECT_EQ(std::distance(fs::directory_iterator(out / "drawings"), fs::directory_iterator()), 1)
        << "four runs have one drawing";
    EXPECT_TRUE(row(1).starts_with("1,run_0001,117.72,0.405,finished,")) << row(1);
    EXPECT_TRUE(row(4).starts_with("4,run_0004,235.44,0.42,finished,")) << row(4);
    EXPECT_NE(header_of(out / "sweep.csv").find(",crest_settlement_m_peak,crest_settlement_m_final,"),
              std::string::npos);
    const std::string of_third = row(3);

    fs::remove_all(out / "run_0002"); // as never begun
    const auto before = read_file(manifest(1));
    std::string text = read_file(manifest(3)); // as killed
    text.replace(text.find("\"finished\""), 10, "\"running\"");
    std::ofstream(manifest(3)) << text;
    const Outcome second = call("");
    ASSERT_EQ(second.code, 0) << second.output;
    expect_mention(second, "4 runs, 2 left to do");
    expect_mention(second, "run_0002: ");
    expect_mention(second, "run_0003: ");
    EXPECT_EQ(second.output.find("run_0001: "), std::string::npos) << second.output;
    EXPECT_EQ(read_file(manifest(1)), before) << "a finished run is left alone";
    EXPECT_TRUE(row(2).starts_with("2,run_0002,117.72,0.42,finished,")) << row(2);
    // The wall time is that of the last process; what stands behind it is the same.
    const auto results = [](std::string cells) {
        for (int k = 0; k < 7; ++k) cells.erase(0, cells.find(',') + 1);
        return cells;
    };
    EXPECT_EQ(results(row(3)), results(of_third));

    fs::remove(out / "sweep.csv");
    const Outcome third = call("--collect");
    EXPECT_EQ(third.code, 0) << third.output;
    EXPECT_TRUE(row(4).starts_with("4,run_0004,")) << third.output;
}

TEST_F(SweepProgram, ListsItsRunsWithoutWritingThem)
{
    const Outcome outcome = call("--dry-run");
    EXPECT_EQ(outcome.code, 0);
    expect_mention(outcome, "run_0003  motion.amplitude = 235.44 m/s2  materials.sand.porosity = 0.405\n");
    EXPECT_FALSE(fs::exists(out));
}

TEST_F(SweepProgram, ChecksAllRunsBeforeTheFirst)
{
    write("", "\"24 kg\"");
    const Outcome outcome = call("");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome,
                   "sweep.toml: runs 3, 4 cannot be run:\n--set 'motion.amplitude=\"24 kg\"': error[unit]");
    EXPECT_FALSE(fs::exists(out));
}

TEST_F(SweepProgram, RecordsARunThatFailsAndDoesTheOthers)
{
    std::ofstream(sweep) << "sweep_version = 1\nscene = \"" << example("column")
                         << "\"\nset = [\"run.end_time=2e-4\"]\n[vary.\"boundaries.surface.traction\"]\n"
                            "values = [[0, 1e9], [0, 0]]\n";
    const Outcome outcome = call("");
    EXPECT_EQ(outcome.code, 3) << outcome.output;
    expect_mention(outcome, "run_0001: failed with exit code 3");
    expect_mention(outcome, "2 runs: 1 failed, 1 finished");
    EXPECT_NE(row(1).find(",failed,"), std::string::npos) << row(1);
    EXPECT_NE(row(2).find(",finished,"), std::string::npos) << row(2);
}

TEST_F(SweepProgram, LeavesOtherResultsAlone)
{
    ASSERT_EQ(call("").code, 0);
    write("", "\"25 g\"");
    const Outcome changed = call("");
    EXPECT_EQ(changed.code, 2);
    expect_mention(changed,
                   "out/run_0003 holds the results of another run: the scene or the sweep has changed since");
    const Outcome none =
        run_program("sweep \"" + sweep.string() + "\" --collect -o " + (folder / "none").string());
    EXPECT_EQ(none.code, 2);
    expect_mention(none, "there is no sweep in ");
}

TEST_F(SweepProgram, WritesACommandForEachRun)
{
    const Outcome outcome = call("--engine parallel --jobs 3");
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    expect_mention(outcome, "it'\\''s/out' && sh run_parallel.sh\n");
    expect_mention(outcome, " --collect");
    const std::vector<std::string> commands = lines_of(out / "commands.txt");
    ASSERT_EQ(commands.size(), 4U);
    EXPECT_TRUE(commands[2].starts_with("env 'QUICKSAND_DRAWINGS=")) << commands[2];
    EXPECT_NE(commands[2].find(" --set 'motion.amplitude=\"24 g\"' --set materials.sand.porosity=0.405 -o '"),
              std::string::npos)
        << commands[2];
    EXPECT_NE(
        read_file(out / "run_parallel.sh").find("\nparallel --jobs 3 --joblog parallel.log < commands.txt\n"),
        std::string::npos);
    for (int call_number = 0; call_number < 2; ++call_number) { // the second finds all runs finished
        const Outcome all = run_shell("sh \"" + (out / "commands.txt").string() + "\"");
        ASSERT_EQ(all.code, 0) << all.output;
        EXPECT_EQ(all.output.find("Nothing to do") != std::string::npos, call_number == 1) << all.output;
    }
    expect_mention(call("--collect"), "4 runs: 4 finished");
}

TEST_F(SweepProgram, WritesAJobArrayForSlurm)
{
    const Outcome outcome = call("--engine slurm");
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    expect_mention(outcome, "&& sbatch sweep.slurm\n");
    const std::string script = read_file(out / "sweep.slurm");
    EXPECT_NE(script.find("#SBATCH --array=1-4\n"), std::string::npos) << script;
    const Outcome second = run_shell("cd \"" + out.string() + "\" && SLURM_ARRAY_TASK_ID=2 sh sweep.slurm");
    EXPECT_EQ(second.code, 0) << second.output;
    EXPECT_TRUE(fs::exists(manifest(2)));
    EXPECT_FALSE(fs::exists(manifest(1)));
    expect_mention(call("--collect"), "4 runs: 1 finished (1 good), 3 missing");
}

TEST_F(SweepProgram, WritesASnakefile)
{
    const Outcome outcome = call("--engine snakemake --jobs 2");
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    expect_mention(outcome, "&& snakemake --keep-going --cores 2\n");
    const std::string rules = read_file(out / "Snakefile");
    EXPECT_NE(rules.find("expand(\"ended/{name}\", name=commands)"), std::string::npos) << rules;
    EXPECT_NE(rules.find("commands = {f\"run_{k:04}\": line for k, line in enumerate(lines, 1)}"),
              std::string::npos)
        << rules;
}

TEST_F(SweepProgram, DrawsAFragilityCurve)
{
    write("[fragility]\nquantity = \"max_displacement_m\"\nthreshold = 1e-12\n");
    const Outcome outcome = call("");
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    expect_mention(outcome, "Fragility: no curve, for all runs exceed the threshold");
    EXPECT_TRUE(fs::exists(out / "fragility.png"));
    EXPECT_EQ(header_of(out / "fragility.csv"), "motion.amplitude_m_s2,runs,exceeding,share,probability");
}

} // namespace

} // namespace quicksand
