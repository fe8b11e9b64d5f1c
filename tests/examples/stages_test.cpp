// A scene in stages: each goes on from the one before, a run that was stopped goes on, others begin with an
// end.
#include "io/results/run_record.hpp"
#include "tests/examples/program.hpp"
#include "tests/fixtures/checkout.hpp"
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace quicksand {
namespace {

using namespace testing_program;

const std::string stages = R"(scene_version = 1
base = "scene.toml"

[[stages]]
name = "gravity"
kind = "settle"

[[stages]]
name = "shaking"
kind = "shake"
duration = "4 ms"
[stages.output]
frame_interval = "2 ms"

[[stages]]
name = "after"
kind = "consolidate"
duration = "50 ms"
)";

class Stages : public testing::Test {
protected:
    Stages()
    {
        std::filesystem::copy(in_checkout("examples/column"), folder / "column");
        std::ofstream(folder / "column/staged.toml") << stages;
    }
    std::string scene() const { return (folder / "column/staged.toml").string(); }
    std::string results(const std::string& name) const { return (folder / name).string(); }
    Outcome run(const std::string& words) const { return run_program("run " + words); }
    /// Rows of a history, without the comments that name the scene.
    std::string rows(const std::string& file) const
    {
        const std::string text = read_file(folder / file);
        return text.substr(text.find("\ntime_s"));
    }

    WorkFolder folder;
};

TEST_F(Stages, GoOnFromEachOther)
{
    const Outcome outcome = run(scene() + " -o " + results("a"));
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("Stage 2 of 3: shaking (shake)"), std::string::npos) << outcome.output;
    const std::string table = read_file(folder / "a/stages.csv");
    EXPECT_NE(table.find("\ngravity,settle,finished,0,0,\nshaking,shake,finished,0,0.004,\n"
                         "after,consolidate,finished,0.004,0.05,\n"),
              std::string::npos)
        << table;
    const std::string frames = read_file(folder / "a/stages.pvd");
    EXPECT_NE(frames.find("shaking/fields/frame_000001.vtu"), std::string::npos) << frames;
    EXPECT_NE(frames.find("file=\"after/fields/frame_000050.vtu\""), std::string::npos) << frames;

    const Outcome again = run(scene() + " -o " + results("a") + " --continue");
    EXPECT_EQ(again.code, 0) << again.output;
    EXPECT_NE(again.output.find("finished already"), std::string::npos) << again.output;
    std::filesystem::remove_all(folder / "a/gravity");
    const Outcome late = run(scene() + " -o " + results("a"));
    EXPECT_EQ(late.code, 2) << late.output;
    EXPECT_NE(late.output.find("a/shaking holds a former run"), std::string::npos) << late.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "a/gravity")) << "told before the first stage";
}

// They rode with what lay nearest to the place as drawn whenever soil had settled, by half of a particle or
// more.
TEST_F(Stages, ProbesRideWithTheSameParticleInAllOfThem)
{
    std::ofstream(folder / "block.geo") << R"(Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0};
Point(3) = {1, 4, 0}; Point(4) = {0, 4, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Physical Surface("soil") = {1}; Physical Curve("base") = {1}; Physical Curve("top") = {3};
Physical Curve("left") = {4}; Physical Curve("right") = {2};
)";
    std::ofstream(folder / "block.toml") << R"(scene_version = 1
[geometry]
file = "block.geo"
[grid]
cell_size = 0.5
[materials.soft]
model = "linear_elastic"
porosity = 0.5
shear_modulus = 2e5
poisson_ratio = 0.3
[regions.soil]
material = "soft"
[boundaries.base]
soil = "fixed"
[boundaries.left]
soil = "roller"
[boundaries.right]
soil = "roller"
[boundaries.top]
[probes.high]
at = [0.45, 3.7]
[[stages]]
name = "gravity"
kind = "settle"
[[stages]]
name = "load"
kind = "settle"
[stages.boundaries.top]
pressure = 4e4
[[stages]]
name = "shaking"
kind = "shake"
duration = 0.01
)";
    const Outcome outcome = run((folder / "block.toml").string() + " -o " + results("b"));
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    const auto rider = [&](const std::string& stage) {
        const std::string text = read_file(folder / ("b/" + stage + "/probes/high.csv"));
        const std::string before = "rides with particle ";
        const std::size_t at = text.find(before);
        return at == std::string::npos ? "none" : text.substr(at + before.size(), 4);
    };
    EXPECT_NE(rider("shaking"), "none");
    EXPECT_EQ(rider("shaking"), rider("gravity"));
    EXPECT_EQ(rider("load"), rider("gravity"));
}

TEST_F(Stages, AreTheRunThatSettlesAndShakes)
{
    ASSERT_EQ(run(scene() + " -o " + results("a")).code, 0);
    const std::string plain = (folder / "column/scene.toml").string();
    const std::string same =
        " --set relaxation.damping=0.7 --set run.end_time=0.004 --set output.frame_interval=0.002";
    ASSERT_EQ(run(plain + same + " -o " + results("b")).code, 0);
    EXPECT_TRUE(rows("a/shaking/history.csv") == rows("b/history.csv"));
    ASSERT_EQ(run(plain + same + " --from " + results("a") + ":gravity -o " + results("c")).code, 0);
    EXPECT_TRUE(rows("c/history.csv") == rows("b/history.csv"));
    // the stages up to the one that is named are left out
    ASSERT_EQ(run(scene() + " --from " + results("a") + ":gravity -o " + results("d")).code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "d/gravity"));
    EXPECT_TRUE(rows("d/after/history.csv") == rows("a/after/history.csv"));
}

// Particles are parted at the water level, those of another level stand for other soil.
TEST_F(Stages, GoOnFromAnotherWaterLevelWithTheSameParticles)
{
    const auto settle_at = [&](const std::string& name, const std::string& level) {
        std::ofstream(folder / "column" / (name + ".toml"))
            << "scene_version = 1\nbase = \"scene.toml\"\n[[stages]]\nname = \"" << name
            << "\"\nkind = \"settle\"\n[stages.water]\nlevel = " << level << "\n";
        return (folder / "column" / (name + ".toml")).string();
    };
    ASSERT_EQ(run(settle_at("high", "0.2213") + " -o " + results("a")).code, 0);
    const Outcome lower = run(settle_at("low", "0.1013") + " --from " + results("a") + " -o " + results("b"));
    EXPECT_EQ(lower.code, 0) << lower.output;
    const auto lines = read_run_record(folder / "b/low/run_manifest.json").water_lines;
    ASSERT_TRUE(lines && lines->size() == 1);
    EXPECT_EQ(lines->front().points.front().y(), 0.2213);
    EXPECT_EQ(read_run_record(folder / "b/low/run_manifest.json").particles,
              read_run_record(folder / "a/high/run_manifest.json").particles);
}

TEST_F(Stages, CommandsShowTheOneThatShakes)
{
    ASSERT_EQ(run(scene() + " -o " + results("a")).code, 0);
    const Outcome picture = run_program("picture " + results("a") + " --field displacement");
    EXPECT_EQ(picture.code, 0) << picture.output;
    EXPECT_NE(picture.output.find("a/shaking/pictures"), std::string::npos) << picture.output;
}

// The scene is named from one folder, and its results are read from another.
TEST_F(Stages, FindTheirSceneFromAnyFolder)
{
    const Outcome outcome = run_shell("cd \"" + results("") + "\" && $QUICKSAND run column/staged.toml -o a");
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    const Outcome report = run_program("report " + results("a"));
    EXPECT_EQ(report.code, 0) << report.output;
    EXPECT_EQ(report.output.find("is not there any more"), std::string::npos) << report.output;
    const std::string page = read_file(folder / "a/shaking/report.html");
    EXPECT_NE(page.find("This page is about the stage shaking."), std::string::npos);
    EXPECT_NE(page.find("<td>consolidate</td>"), std::string::npos);
}

TEST_F(Stages, AreCheckedTogether)
{
    const Outcome check = run_program("check " + scene() + " -o " + results("plan"));
    EXPECT_EQ(check.code, 0) << check.output;
    EXPECT_NE(check.output.find("Stage 3 of 3: after (consolidate)"), std::string::npos) << check.output;
    EXPECT_NE(check.output.find("analysis.scheme: "), std::string::npos) << check.output;
    EXPECT_NE(check.output.find("  after liquefaction more steps"), std::string::npos) << check.output;
}

TEST_F(Stages, LiquefiedSandCanHaveAResidualStrength)
{
    std::ofstream(folder / "column/safe.toml")
        << "scene_version = 1\nbase = \"scene.toml\"\n[[stages]]\nkind = \"settle\"\n"
           "[[stages]]\nname = \"safety\"\nkind = \"stability\"\nresidual_strength = 0.1\n";
    const Outcome search = run((folder / "column/safe.toml").string() + " -o " + results("a") +
                               " --set grid.cell_size=0.0225 --set grid.cells=[3,18] --set "
                               "sampling.particles_per_cell=[1,1]");
    EXPECT_EQ(search.code, 0) << search.output;
    EXPECT_NE(
        search.output.find(" particles have liquefied (ru of 0.8 or more): their strength is 0.1 times"),
        std::string::npos)
        << search.output;
    const std::string table = read_file(folder / "a/stages.csv");
    EXPECT_NE(table.find("\nsafety,stability,finished,0,0,32\n"), std::string::npos) << table;
    const Outcome again = run_program("stability " + results("a") + "/settle --seismic-coefficient 0.1");
    EXPECT_EQ(again.code, 0) << again.output;
    EXPECT_NE(again.output.find("The factor of safety is "), std::string::npos) << again.output;
    EXPECT_TRUE(std::filesystem::exists(folder / "a/settle/stability/stability.txt"));
    const Outcome torn = run_program("stability " + results("a") +
                                     "/settle --seismic-coefficient 2 --set "
                                     "materials.sand.constant_volume_friction_deg=1 --set "
                                     "materials.sand.peak_friction_deg=1 --set initial.k0=1");
    EXPECT_EQ(torn.code, 0) << torn.output;
    EXPECT_NE(
        torn.output.find("The factor of safety is less than 0.0352: the slope stands at no strength of "
                         "its soil. Either its pores bear its weight, or forces of the shaking still act."
                         "\nhint: residual_strength in a stage of kind = \"stability\""),
        std::string::npos)
        << torn.output;
}

TEST_F(Stages, AnOriginHasToSuit)
{
    const Outcome nothing = run(scene() + " --from " + results("no") + ":gravity -o " + results("b"));
    EXPECT_EQ(nothing.code, 2);
    EXPECT_EQ(nothing.output, "--from: there are no results " + results("no") +
                                  "\nexpected: RESULTS or RESULTS:STAGE, as results/my_dike:gravity\n");
    ASSERT_EQ(run(scene() + " -o " + results("a")).code, 0);
    const Outcome stage = run(scene() + " --from " + results("a") + ":gravty -o " + results("b"));
    EXPECT_EQ(stage.code, 2);
    EXPECT_EQ(stage.output,
              "--from: " + results("a") + " has no stage gravty\nexpected: one of gravity, shaking, after\n");
    const Outcome last = run(scene() + " --from " + results("a") + " -o " + results("b"));
    EXPECT_EQ(last.code, 2);
    EXPECT_EQ(last.output,
              "--from " + results("a") + " is the last stage of this scene: nothing is left to run\n");
    const Outcome grid = run(scene() + " --set sampling.particles_per_cell=[2,2] --from " + results("a") +
                             ":gravity -o " + results("b"));
    EXPECT_EQ(grid.code, 2);
    EXPECT_NE(grid.output.find("cannot go on from " + results("a") +
                               "/gravity, which has other values of sampling.particles_per_cell"),
              std::string::npos)
        << grid.output;
}

const std::string rest_and_load =
    "scene_version = 1\nbase = \"scene.toml\"\n[[stages]]\nname = \"rest\"\nkind = \"settle\"\n"
    "[[stages]]\nname = \"load\"\nkind = \"shake\"\nduration = \"8 ms\"\n";

TEST_F(Stages, AStageThatSettlesTellsOfThePressuresThatAreLost)
{
    std::ofstream(folder / "column/lost.toml")
        << rest_and_load
        << "[stages.boundaries.surface]\npressure = 2000\n[[stages]]\nname = \"again\"\nkind = \"settle\"\n";
    const Outcome outcome = run((folder / "column/lost.toml").string() + " -o " + results("lost"));
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    const std::size_t told =
        outcome.output.find("warning: soil settles drained in this stage: excess pore pressures of up to");
    EXPECT_NE(told, std::string::npos) << outcome.output;
    EXPECT_GT(told, outcome.output.find("Stage 3 of 3")) << outcome.output;
}

// The run had not kept what a later stage asks for now: it went on without it, and ended in a segmentation
// fault.
TEST_F(Stages, ARunWithoutTheHistoryThatALaterStageAsksForIsNotResumed)
{
    ASSERT_EQ(run(scene() + " -o " + results("a")).code, 0);
    const std::string with_history = "[stages.materials.sand]\nreconsolidation_slope = 0.3\n";
    std::ofstream(folder / "column/staged.toml") << stages << with_history;
    const Outcome resumed = run(scene() + " -o " + results("a") + " --resume");
    EXPECT_EQ(resumed.code, 2) << resumed.output;
    EXPECT_NE(resumed.output.find("cannot be resumed, for its state hangs on what has changed since the run "
                                  "began:\n  no key: histories that later stages ask for, or the program"),
              std::string::npos)
        << resumed.output;

    std::ofstream(folder / "column/drain.toml")
        << "scene_version = 1\nbase = \"scene.toml\"\n[[stages]]\nname = \"drain\"\nkind = \"consolidate\"\n"
           "duration = \"5 ms\"\n"
        << with_history;
    const Outcome from = run((folder / "column/drain.toml").string() + " --from " + results("a") +
                             ":shaking -o " + results("b"));
    EXPECT_EQ(from.code, 0) << from.output;
    EXPECT_NE(from.output.find("warning: the run before kept no history of the sand"), std::string::npos)
        << from.output;
}

TEST_F(Stages, SandForgetsItsShakingWhereSoilSettles)
{
    std::ofstream(folder / "column/forgets.toml")
        << fixtures::replaced(rest_and_load, "8 ms", "40 ms") // the sand liquefies
        << "[[stages]]\nname = \"again\"\nkind = \"settle\"\n[[stages]]\nname = \"drain\"\n"
        << "kind = \"consolidate\"\nduration = \"5 ms\"\n"
        << "[stages.materials.sand]\nreconsolidation_slope = 0.3\n";
    const Outcome outcome = run((folder / "column/forgets.toml").string() + " -o " + results("c"));
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    const std::size_t told = outcome.output.find("warning: sand forgets its shaking where soil settles");
    ASSERT_NE(told, std::string::npos) << outcome.output;
    EXPECT_GT(told, outcome.output.find("Stage 3 of 4")) << outcome.output;
}

// It left a folder that --overwrite did not take for its own.
TEST_F(Stages, AStageThatCannotBeginLeavesNoFolder)
{
    std::ofstream(folder / "column/untied.toml")
        << rest_and_load
        << "[stages.boundaries.left]\nsoil = \"roller\"\n[stages.boundaries.right]\nsoil = \"roller\"\n"
           "[analysis]\ncolumns = \"one\"\n";
    const std::string words = (folder / "column/untied.toml").string() + " -o " + results("untied");
    const Outcome outcome = run(words);
    EXPECT_NE(outcome.output.find("which differ within a region"), std::string::npos) << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(results("untied") + "/load"));
    EXPECT_EQ(run(words + " --overwrite --set analysis.columns=all").code, 0);
}

TEST_F(Stages, SandThatHasNotLiquefiedHasNothingToForget)
{
    std::ofstream(folder / "column/remembers.toml")
        << rest_and_load << "[[stages]]\nname = \"again\"\nkind = \"settle\"\n"
        << "[stages.materials.sand]\nreconsolidation_slope = 0.3\n";
    const Outcome outcome = run((folder / "column/remembers.toml").string() + " -o " + results("d"));
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_EQ(outcome.output.find("forgets"), std::string::npos) << outcome.output;
}

TEST_F(Stages, AStageOfOtherStillWaterLosesNoPressure)
{
    std::ofstream(folder / "column/lower.toml")
        << "scene_version = 1\nbase = \"scene.toml\"\n[[stages]]\nname = \"rest\"\nkind = \"settle\"\n"
           "[[stages]]\nname = \"lower\"\nkind = \"settle\"\n[stages.water]\nlevel = 0.25\n";
    const Outcome outcome = run((folder / "column/lower.toml").string() + " -o " + results("lower"));
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_EQ(outcome.output.find("are lost"), std::string::npos) << outcome.output;
}

TEST_F(Stages, WhatIsWrongWithALaterStageIsToldBeforeTheFirstRuns)
{
    std::ofstream(folder / "column/wrong.toml")
        << rest_and_load << "[stages.boundaries.surfac]\npressure = 2000\n";
    const Outcome outcome = run((folder / "column/wrong.toml").string() + " -o " + results("wrong"));
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    EXPECT_NE(outcome.output.find("did you mean \"surface\"?"), std::string::npos) << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "wrong")) << outcome.output;
}

/// The last number of a column of a history.
double last_of(const std::string& history, const std::string& name)
{
    std::istringstream text(history);
    std::string header, row;
    while (std::getline(text, header) && !header.starts_with("time_s")) {
    }
    for (std::string line; std::getline(text, line);) row = line;
    std::istringstream names(header), numbers(row);
    std::string found, number;
    while (std::getline(names, found, ',') && std::getline(numbers, number, ','))
        if (found == name) return std::stod(number);
    ADD_FAILURE() << "no column " << name;
    return 0.0;
}

TEST_F(Stages, AShakeAfterHoursOfConsolidationMovesAsItDoesWithout)
{
    const std::string begin = "scene_version = 1\nbase = \"scene.toml\"\n[boundaries.surface]\npressure = "
                              "2000\n[[stages]]\nname = \"rest\"\nkind = \"settle\"\n",
                      wait = "[[stages]]\nname = \"wait\"\nkind = \"consolidate\"\nduration = \"5 h\"\n",
                      end = "[[stages]]\nname = \"shaking\"\nkind = \"shake\"\nduration = \"4 ms\"\n"
                            "[stages.boundaries.surface]\npressure = 1500\n";
    std::ofstream(folder / "column/with.toml") << begin << wait << end;
    std::ofstream(folder / "column/without.toml") << begin << end;
    double velocity[2], displacement[2];
    for (const int k : {0, 1}) {
        const std::string name = k == 0 ? "with" : "without";
        const Outcome outcome = run((folder / "column" / (name + ".toml")).string() + " -o " + results(name));
        EXPECT_EQ(outcome.code, 0) << outcome.output;
        const std::string history = read_file(folder / name / "shaking/history.csv");
        velocity[k] = last_of(history, "max_velocity_m_s");
        displacement[k] = last_of(history, "max_displacement_m");
    }
    EXPECT_NEAR(velocity[0], velocity[1], 0.05 * velocity[1]);
    EXPECT_NEAR(displacement[0], displacement[1], 0.05 * displacement[1]);
}

} // namespace
} // namespace quicksand
