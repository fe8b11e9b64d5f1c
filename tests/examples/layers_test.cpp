// A fill built in layers by the program: it resumes in the middle, begins with a stage of another run, and
// its results show the soil that is there.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace testing_program;

const std::string drawing = R"(
For k In {0:3}
  Point(1 + 2 * k) = {0, k, 0};
  Point(2 + 2 * k) = {2, k, 0};
  Line(1 + k) = {1 + 2 * k, 2 + 2 * k};
EndFor
For k In {0:2}
  Line(10 + k) = {2 + 2 * k, 4 + 2 * k};
  Line(20 + k) = {3 + 2 * k, 1 + 2 * k};
  Curve Loop(1 + k) = {1 + k, 10 + k, -(2 + k), 20 + k};
  Plane Surface(1 + k) = {1 + k};
EndFor
Physical Surface("ground") = {1};
Physical Surface("lower") = {2};
Physical Surface("upper") = {3};
Physical Curve("base") = {1};
Physical Curve("sides") = {10, 11, 12, 20, 21, 22};
Physical Curve("crest") = {4};
)";

const std::string fill_scene = R"(scene_version = 1
[geometry]
file = "fill.geo"
[grid]
cell_size = 0.25
[water]
level = 2.0
[materials.sand]
model = "mohr_coulomb"
shear_modulus = "20 MPa"
poisson_ratio = 0.25
friction_angle = "35 deg"
cohesion = 500
porosity = 0.4
hydraulic_conductivity = 1e-4
[regions.ground]
material = "sand"
[regions.lower]
material = "sand"
[regions.upper]
material = "sand"
[boundaries.base]
soil = "fixed"
[boundaries.sides]
soil = "roller"
[boundaries.crest]
pressure = "5 kPa"
[probes.low]
at = [1.0, 0.5]
[probes.high]
at = [1.0, 2.5]
[relaxation]
tolerance = 1e-8
[output]
checkpoint_interval = 0.001
frame_interval = 0.001
probe_interval = 0.0005
[[stages]]
name = "ground"
kind = "settle"
[[stages]]
name = "lower"
kind = "settle"
place = ["lower"]
[[stages]]
name = "upper"
kind = "settle"
place = ["upper"]
[[stages]]
name = "rest"
kind = "shake"
duration = "5 ms"
)";

class LayerRun : public testing::Test {
protected:
    LayerRun()
    {
        std::ofstream(folder / "fill.geo") << drawing;
        std::ofstream(folder / "fill.toml") << fill_scene;
    }
    std::string words(const std::string& results, const std::string& more = "") const
    {
        return "run " + (folder / "fill.toml").string() + " --threads 1 -o " + (folder / results).string() +
               ' ' + more;
    }
    void expect_same_end(const std::string& a, const std::string& b) const
    {
        for (const char* file : {"rest/checkpoint/state.h5", "rest/fields.pvd"})
            EXPECT_TRUE(read_file(folder / (a + '/' + file)) == read_file(folder / (b + '/' + file))) << file;
    }

    WorkFolder folder;
};

TEST_F(LayerRun, ResumesInTheMiddleAndBeginsWithAStage)
{
    const Outcome whole = run_program(words("whole"));
    ASSERT_EQ(whole.code, 0) << whole.output;
    const std::string lower = (folder / "parts/lower").string();
    const Outcome stopped = run_shell("\"$QUICKSAND\" " + words("parts") +
                                      " & pid=$!\nfor k in $(seq 6000); do\n  [ -f " + lower +
                                      "/checkpoint/state.h5 ] && break\n  sleep 0.01\ndone\nkill -TERM $pid; "
                                      "wait $pid");
    ASSERT_EQ(stopped.code, 0) << stopped.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "parts/rest")) << stopped.output;
    const Outcome resumed = run_program(words("parts", "--resume"));
    ASSERT_EQ(resumed.code, 0) << resumed.output;
    expect_same_end("whole", "parts");

    const Outcome other = run_program(words("other", "--from " + (folder / "whole").string() + ":lower"));
    ASSERT_EQ(other.code, 0) << other.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "other/lower"));
    expect_same_end("whole", "other");

    EXPECT_TRUE(std::filesystem::exists(folder / "whole/ground/probes/low.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder / "whole/lower/probes/high.csv")) << "its soil is not there";
    EXPECT_TRUE(std::filesystem::exists(folder / "whole/rest/probes/high.csv"));
}

TEST_F(LayerRun, IsCheckedStageByStage)
{
    const Outcome outcome = run_program("check " + (folder / "fill.toml").string());
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("upper                      2  without soil here"), std::string::npos)
        << outcome.output;
    EXPECT_NE(outcome.output.find("crest           no soil beside it here"), std::string::npos)
        << outcome.output;
    int forecasts = 0; // of the three stages that settle
    for (std::size_t at = 0; (at = outcome.output.find("Cost\n  settling   about ", at)) != std::string::npos;
         ++at)
        ++forecasts;
    EXPECT_EQ(forecasts, 3) << outcome.output;
}

TEST_F(LayerRun, ShakesWithTheSoilThatHasSettled)
{
    ASSERT_EQ(run_program(words("whole")).code, 0);
    std::ofstream(folder / "plain.toml")
        << fill_scene.substr(0, fill_scene.find("[[stages]]")) << "[run]\nend_time = 0.01\n";
    const Outcome outcome =
        run_program("run " + (folder / "plain.toml").string() + " -o " + (folder / "plain").string() +
                    " --from " + (folder / "whole").string() + ":ground");
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    EXPECT_NE(outcome.output.find("the stage begins with other soil than the stage before ended with"),
              std::string::npos)
        << outcome.output;
}

} // namespace
} // namespace quicksand
