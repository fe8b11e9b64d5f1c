// Scenes and results folders that cannot be used, and runs that go bad.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

using namespace testing_program;

const std::string short_column = "run " + example("column") + " --until 5e-6 -o ";

TEST(SceneFolder, AMissingSceneIsNamed)
{
    const Outcome outcome = run_program("run no/such/scene.toml");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "there is no scene no/such/scene.toml\nhint: name a scene file or its folder");
}

TEST(SceneFolder, AFolderWithoutASceneIsNamed)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("check " + folder.string());
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "holds no scene.toml\nhint: name the scene file itself");
}

TEST(SceneFolder, AWrongOverrideIsGuessed)
{
    const Outcome outcome = run_program("check " + example("column") + " --set motion.amplitud=3");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "amplitude");
}

TEST(ResultsFolder, AFormerRunIsNotOverwritten)
{
    const WorkFolder folder;
    const std::string results = (folder / "results").string();
    EXPECT_EQ(run_program(short_column + results).code, 0);
    const Outcome again = run_program(short_column + results);
    EXPECT_EQ(again.code, 2);
    expect_mention(again, "holds a former run");
    expect_mention(again, "--overwrite");
    EXPECT_EQ(run_program(short_column + results + " --overwrite").code, 0);
}

TEST(ResultsFolder, AFolderThatCannotBeMadeIsAFileError)
{
    const Outcome outcome = run_program(short_column + "/proc/quicksand/results");
    EXPECT_EQ(outcome.code, 4);
    expect_mention(outcome, "/proc/quicksand/results: cannot create the folder: ");
}

TEST(ResultsFolder, OfARunWithoutALogCanBeOverwritten)
{
    const WorkFolder folder;
    const std::string results = (folder / "results").string();
    std::filesystem::create_directory(results);
    std::filesystem::create_symlink("/proc/quicksand/log.txt", results + "/log.txt");
    const Outcome outcome = run_program(short_column + results);
    EXPECT_EQ(outcome.code, 4);
    expect_mention(outcome, "log.txt: cannot write");
    EXPECT_NE(read_file(results + "/run_manifest.json").find("\"status\": \"failed\""), std::string::npos);
    EXPECT_EQ(run_program(short_column + results + " --overwrite").code, 0);
}

TEST(ResultsFolder, AUsersFolderSurvivesACheck)
{
    const WorkFolder folder;
    std::filesystem::create_directory(folder / "trial");
    std::ofstream(folder / "trial/notes.txt") << "mine";
    const Outcome outcome = run_program("check " + example("column") + " --until 1e-3 -o " + folder.string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_EQ(read_file(folder / "trial/notes.txt"), "mine");
    for (const auto& item : std::filesystem::directory_iterator(folder.string())) {
        const std::string name = item.path().filename().string();
        EXPECT_TRUE(name == "trial" || !name.starts_with("trial")) << name << " is left over";
    }
}

TEST(FullDisk, CutsNoPlanOffSilently)
{
    const WorkFolder folder;
    std::filesystem::create_symlink("/dev/full", folder / "check.txt");
    const Outcome outcome = run_program("check " + example("column") + " --until 1e-3 -o " + folder.string());
    EXPECT_EQ(outcome.code, 4) << outcome.output;
    expect_mention(outcome, "check.txt: cannot write");
}

TEST(FullDisk, CutsNoLogOffSilently)
{
    const WorkFolder folder;
    const std::string results = (folder / "results").string();
    ASSERT_EQ(run_program(short_column + results).code, 0);
    std::filesystem::remove(results + "/log.txt");
    std::filesystem::create_symlink("/dev/full", results + "/log.txt");
    const Outcome outcome = run_program("run " + example("column") + " --until 1e-5 --resume -o " + results);
    EXPECT_EQ(outcome.code, 4) << outcome.output;
    expect_mention(outcome, "log.txt: cannot write");
    EXPECT_NE(read_file(results + "/run_manifest.json").find("\"status\": \"failed\""), std::string::npos);
}

TEST(ResultsFolder, AFileIsNoFolder)
{
    const WorkFolder folder;
    std::ofstream(folder / "file") << "mine";
    const Outcome outcome = run_program(short_column + (folder / "file").string());
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "is a file, not a folder");
    EXPECT_EQ(read_file(folder / "file"), "mine");
}

TEST(ResultsFolder, WithoutACheckpointThereIsNothingToResume)
{
    const WorkFolder folder;
    const Outcome outcome = run_program(short_column + folder.string() + " --resume");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "cannot be resumed");
}

TEST(ResultsFolder, AnotherSceneCannotResume)
{
    const WorkFolder folder;
    EXPECT_EQ(run_program(short_column + (folder / "a").string()).code, 0);
    const Outcome outcome =
        run_program("run " + example("column") + " --set initial.k0=0.6 --resume --until 1e-5 -o " +
                    (folder / "a").string());
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome,
                   "a cannot be resumed, for its state hangs on what has changed since the run began:\n"
                   "  initial.k0: 0.5 -> 0.6\n");
    expect_mention(outcome, "only title, figures, relaxation.tolerance, relaxation.max_steps, run.end_time, "
                            "durations and intervals of output may be others");
    expect_mention(outcome, "hint: begin anew with --overwrite, or in another folder with -o");
}

TEST(ResultsFolder, OfAFinishedRunHasNothingToResume)
{
    const WorkFolder folder;
    const std::string run = short_column + (folder / "results").string();
    ASSERT_EQ(run_program(run).code, 0);
    const Outcome again = run_program(run + " --resume");
    EXPECT_EQ(again.code, 0) << again.output;
    expect_mention(again, "Nothing to do: the results reach t = 5e-6 s already.");
}

TEST(Probes, OneOutsideTheSoilIsNamedWithTheNearestParticle)
{
    const WorkFolder folder;
    const Outcome outcome = run_program(short_column + (folder / "results").string() +
                                        " --set 'probes.far.kind=\"material\"' --set 'probes.far.at=[5, 5]'");
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    expect_mention(outcome,
                   "the probe \"far\" at (5, 5) m lies outside the soil: the nearest particle is at ");
    EXPECT_FALSE(std::filesystem::exists(folder / "results"));
}

TEST(ResultsFolder, APictureNeedsResults)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("picture " + folder.string());
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    expect_mention(outcome, "fields.pvd: there is no such series. Is this the results folder of a run?");
}

TEST(ResultsFolder, AProbeNeedsResults)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("probe " + folder.string() + " --at 0.1,0.2 --fields ru -o " +
                                        (folder / "a.csv").string());
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "Is this the results folder of a run?");
}

TEST(NumericalFailure, IsToldKeptAndCoded)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("run " + example("dike") +
                                        " --set relaxation.max_steps=50 --set relaxation.tolerance=1e-9 -o " +
                                        (folder / "results").string());
    EXPECT_EQ(outcome.code, 3);
    expect_mention(outcome, "does not settle");
    expect_mention(outcome, "likely causes");
    EXPECT_NE(read_file(folder / "results/run_manifest.json").find("\"status\": \"failed\""),
              std::string::npos);
    EXPECT_NE(read_file(folder / "results/log.txt").find("does not settle"), std::string::npos);
}

TEST(NumericalFailure, OfSoilThatCannotStandEndsSoonWithItsPlace)
{
    const WorkFolder folder;
    const Outcome outcome = run_program(
        "run " + example("verification/griffiths_lane") +
        " --set grid.cell_size=1 --set materials.soil.cohesion=500 --set relaxation.damping=0.7 -o " +
        (folder / "results").string());
    EXPECT_EQ(outcome.code, 3) << outcome.output;
    expect_mention(outcome, "while settling, in phase 'relaxation' of step ");
    expect_mention(outcome, "the soil runs away instead of settling: it has moved ");
    expect_mention(outcome, " of the weight and largest at (");
    expect_mention(outcome, "\n  particle ");
    expect_mention(outcome,
                   "  the soil as it is: " + (folder / "results/settling.pvd").string() + " (ParaView)");
    EXPECT_TRUE(std::filesystem::exists(folder / "results/settling/frame_000000.vtu"));
    EXPECT_TRUE(std::filesystem::exists(folder / "results/settling.png"));
    expect_mention(outcome, "likely causes: the soil does not bear its weight, the loads and the pore "
                            "pressures (quicksand stability tells "
                            "its factor of safety)");
}

TEST(NumericalFailure, TellsWhatIsStillGood)
{
    const WorkFolder folder;
    const std::string results = (folder / "results").string();
    const Outcome outcome = run_program("run " + example("column") +
                                        " --until 2e-4 --set output.frame_interval=2e-5"
                                        " --set 'boundaries.surface.traction=[0, 1e9]' -o " +
                                        results);
    EXPECT_EQ(outcome.code, 3) << outcome.output;
    expect_mention(outcome, "a particle has left the grid");
    expect_mention(outcome, "last good frame: " + results + "/fields/frame_00000");
    expect_mention(outcome,
                   "last checkpoint: " + results + "/checkpoint/state.h5 (go on from it with --resume)");
}

TEST(NumericalFailure, OfABodyThatNothingHoldsIsTold)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("stability " + example("verification/griffiths_lane") +
                                        " --set grid.cell_size=2 --set boundaries.base.soil=free"
                                        " --set boundaries.right.soil=free -o " +
                                        (folder / "results").string());
    EXPECT_EQ(outcome.code, 3) << outcome.output;
    expect_mention(outcome, "the body does not come to rest at any strength of its soil");
    expect_mention(outcome, "likely causes: a wall is missing among the boundaries");
}

} // namespace

} // namespace quicksand
