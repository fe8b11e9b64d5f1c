// What soil has moved by in all stages: in frames, probes, figures and the report.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace quicksand {
namespace {

using namespace testing_program;

const std::string drawing = R"(
Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 4, 0}; Point(4) = {0, 4, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Physical Surface("soil") = {1}; Physical Curve("base") = {1}; Physical Curve("sides") = {2, 4};
Physical Curve("crest") = {3};
)";

/// 4 m of dry soil with M = 2 MPa, under 10 and 20 kPa in its second and fourth stage and 10 kPa less at the
/// end.
const std::string scene = R"(scene_version = 1
[geometry]
file = "column.geo"
[grid]
cell_size = 0.25
[materials.soil]
model = "linear_elastic"
shear_modulus = "1 MPa"
poisson_ratio = 0.0
grain_density = 2650
porosity = 0.4
[regions.soil]
material = "soil"
[boundaries.base]
soil = "fixed"
[boundaries.sides]
soil = "roller"
[probes.top]
kind = "surface"
at = [0.5, 4.0]
[probes.middle]
at = [0.5, 2.0]
[probes.place]
kind = "fixed"
at = [0.5, 2.0]
[relaxation]
tolerance = 1e-8
[figures.total]
quantity = "total_settlement"
probes = ["top"]
[[stages]]
name = "gravity"
kind = "settle"
[[stages]]
name = "load"
kind = "settle"
[stages.boundaries.crest]
pressure = "10 kPa"
[[stages]]
name = "pause"
kind = "shake"
duration = "1 ms"
displacements = "zero"
[[stages]]
name = "more"
kind = "settle"
[stages.boundaries.crest]
pressure = "20 kPa"
[[stages]]
name = "less"
kind = "settle"
[stages.boundaries.crest]
pressure = "10 kPa"
[[stages]]
name = "end"
kind = "shake"
duration = "1 ms"
)";

class TotalDisplacement : public testing::Test {
protected:
    TotalDisplacement()
    {
        std::ofstream(folder / "column.geo") << drawing;
        std::ofstream(folder / "scene.toml") << scene;
    }
    void run(const std::string& more)
    {
        const Outcome outcome = run_program("run " + (folder / "scene.toml").string() + " --threads 1 -o " +
                                            results() + ' ' + more);
        ASSERT_EQ(outcome.code, 0) << outcome.output;
    }
    std::string results() const { return (folder / "results").string(); }

    /// The first number of a column of a probe.
    double first(const std::string& stage, const std::string& probe, const std::string& column) const
    {
        return numbers_of(folder / ("results/" + stage + "/probes/" + probe + ".csv"), column).front();
    }

    WorkFolder folder;
};

constexpr double settled = 10e3 * 4.0 / 2e6; // under 10 kPa [m]

TEST_F(TotalDisplacement, IsTheSumOfTheStagesButTheFirst)
{
    run("--set analysis.strain=small");
    for (const auto& [stage, sum] :
         {std::pair("gravity", 0.0), std::pair("load", 1.0), std::pair("pause", 1.0), std::pair("more", 2.0),
          std::pair("less", 1.0), std::pair("end", 1.0)}) {
        EXPECT_NEAR(first(stage, "top", "total_uy_m"), -sum * settled, 1e-4 * settled) << stage;
        EXPECT_NEAR(first(stage, "middle", "total_uy_m"),
                    -sum * settled * first(stage, "middle", "y_m") / 4.0, 1e-4 * settled)
            << stage;
        EXPECT_NEAR(first(stage, "place", "total_uy_m"), -sum * settled / 2.0, 1e-4 * settled) << stage;
        EXPECT_NEAR(first(stage, "top", "uy_m"), 0.0, 1e-9) << stage;
    }
}

// Soil that is shorter by 0.5 % under its first load settles less under the second.
TEST_F(TotalDisplacement, IsThatOfTheShapeInLargeStrain)
{
    run("--set analysis.strain=large");
    const double before = first("gravity", "top", "y_m");
    for (const std::string stage : {"load", "pause", "more", "less", "end"})
        EXPECT_NEAR(first(stage, "top", "total_uy_m"), first(stage, "top", "y_m") - before, 1e-3 * settled)
            << stage;
    EXPECT_NEAR(first("more", "top", "total_uy_m"), -2.0 * settled, 0.05 * settled);
}

TEST_F(TotalDisplacement, GoesOnFromAStageOfAnotherRun)
{
    run("");
    const std::string others = (folder / "others").string();
    const Outcome other = run_program("run " + (folder / "scene.toml").string() + " --threads 1 --from " +
                                      results() + ":more -o " + others);
    ASSERT_EQ(other.code, 0) << other.output;
    EXPECT_TRUE(read_file(others + "/end/probes/top.csv") == read_file(results() + "/end/probes/top.csv"));

    // it would run the earlier stages anew, and go on with the old history behind them
    const Outcome resumed =
        run_program("run " + (folder / "scene.toml").string() + " --threads 1 --resume -o " + others);
    EXPECT_EQ(resumed.code, 2) << resumed.output;
    EXPECT_NE(
        resumed.output.find("has results of the stage less and none of gravity before it: the run began "
                            "with the end of another one, or that stage is new or was deleted\nhint: go on "
                            "with the same --from RESULTS:STAGE, or run all stages anew with --overwrite"),
        std::string::npos)
        << resumed.output;
    EXPECT_FALSE(std::filesystem::exists(others + "/gravity"));
}

// Its crest was called high enough by what later stages had taken of it.
TEST_F(TotalDisplacement, GoesOnInASceneWithoutStages)
{
    run("--set analysis.strain=small");
    std::ofstream(folder / "plain.toml")
        << scene.substr(0, scene.find("[[stages]]"))
        << "[boundaries.crest]\npressure = \"20 kPa\"\n[run]\nend_time = \"1 ms\"\n";
    const std::string plain = (folder / "plain").string();
    const Outcome outcome =
        run_program("run " + (folder / "plain.toml").string() + " --set analysis.strain=small --from " +
                    results() + ":more -o " + plain);
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(header_of(plain + "/probes/top.csv").find("total_uy_m"), std::string::npos);
    ASSERT_EQ(run_program("report " + plain + " --required-height 3.97").code, 0);
    EXPECT_NE(read_file(plain + "/report.html").find("The crest falls below the required height."),
              std::string::npos);
}

TEST_F(TotalDisplacement, CountsInTheReportsCrestAndInFigures)
{
    run("--set analysis.strain=small");
    ASSERT_EQ(run_program("report " + results() + " --required-height 3.99").code, 0);
    const std::string page = read_file(results() + "/end/report.html");
    EXPECT_NE(page.find("3.98 m"), std::string::npos);
    EXPECT_NE(page.find("The crest falls below the required height."), std::string::npos);
    ASSERT_EQ(run_program("figures " + results()).code, 0);
    EXPECT_TRUE(std::filesystem::exists(results() + "/end/figures/total.png"));
    const Outcome frame = run_program("probe " + results() + " --at 0.5,3.9 --fields total_displacement -o " +
                                      results() + "/at.csv");
    EXPECT_EQ(frame.code, 0) << frame.output;
}

// What the first of two shakes has settled and the second one keeps lies in its first frame already.
TEST_F(TotalDisplacement, CountsOnceInTheReportsCrestWhereAStageKeepsIt)
{
    std::ofstream(folder / "scene.toml", std::ios::app)
        << "[stages.boundaries.crest]\npressure = \"30 kPa\"\nramp_time = \"0.1 s\"\n"
           "[[stages]]\nname = \"after\"\nkind = \"shake\"\nduration = \"20 ms\"\n";
    for (const std::string strain : {"small", "large"}) {
        run("--overwrite --set stages.end.duration=0.3 --set analysis.strain=" + strain);
        const auto of_top = [&](const std::string& stage, const std::string& column) {
            return numbers_of(folder / ("results/" + stage + "/probes/top.csv"), column).back();
        };
        const double kept = -of_top("end", "uy_m"), expected = 4.0 + of_top("after", "total_uy_m");
        EXPECT_GT(kept, settled);
        for (const double above : {-0.25 * settled, 0.25 * settled}) { // of the probe's and the crest's rows
            ASSERT_EQ(
                run_program("report " + results() + " --required-height " + std::to_string(expected + above))
                    .code,
                0);
            const bool falls = read_file(results() + "/after/report.html")
                                   .find("The crest falls below the required height.") != std::string::npos;
            EXPECT_EQ(falls, above > 0.0) << strain << ' ' << expected << ' ' << kept;
        }
    }
}

TEST_F(TotalDisplacement, IsNotThereWithoutStages)
{
    std::ofstream(folder / "scene.toml")
        << scene.substr(0, scene.find("[[stages]]")) << "[run]\nend_time = \"1 ms\"\n";
    run("");
    EXPECT_EQ(header_of(folder / "results/probes/top.csv").find("total"), std::string::npos);
}

} // namespace
} // namespace quicksand
