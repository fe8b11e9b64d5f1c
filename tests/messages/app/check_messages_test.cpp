// What `check` says of the curves and of the state that a scene begins with.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace quicksand {

namespace {

using namespace testing_program;

TEST(CheckMessages, TellTheImpedanceOfTheSoilBesideAViscousCurve)
{
    const WorkFolder folder;
    std::filesystem::copy(example("level_ground_motion"), folder / "ground");
    std::ofstream(folder / "ground/soil.toml")
        << "scene_version = 1\nbase = \"scene.toml\"\n"
           "without = [\"boundaries.base.rock_density\", \"boundaries.base.rock_shear_wave_speed\", "
           "\"boundaries.base.rock_compression_wave_speed\"]\n";
    const Outcome outcome = run_program("check " + (folder / "ground/soil.toml").string() +
                                        " --until 1e-3 -o " + (folder / "check").string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    std::smatch match;
    ASSERT_TRUE(
        std::regex_search(outcome.output, match,
                          std::regex("as sand goes on beyond: rho Vp [0-9.e+]+, rho Vs ([0-9.e+]+) Pa s/m")))
        << outcome.output;
    // at K0 = 0.5 half a particle above the base, 20 m below ground; G = 21.7 * 20 * 13.915^(1/3) (s Pa)^0.5
    const double s = 0.75 * 0.595 * 1670.0 * 9.81 * (20.0 - 0.25 / 6.0), density = 0.595 * 2670.0 + 405.0;
    const double G = 434.0 * std::cbrt(46.0 * 0.55 * 0.55) * std::sqrt(s * 1e5);
    const double expected = std::sqrt(G * density);
    EXPECT_NEAR(std::stod(match[1]), expected, 0.01 * expected);
}

TEST(CheckMessages, ComeOfEverySandThatARunTakes)
{
    const WorkFolder folder;
    const auto agree = [&](const std::string& keys) {
        const std::string scene = example("column") + keys + " --until 2e-5 -o " + folder.string();
        const Outcome check = run_program("check " + scene + "/check"),
                      run = run_program("run " + scene + "/run");
        EXPECT_EQ(run.code, 0) << run.output;
        EXPECT_EQ(check.code, 0) << check.output;
        std::filesystem::remove_all(folder / "run");
        return check.output;
    };
    const std::string cohesive = agree(" --set initial.k0=0 --set materials.sand.cohesion=5000");
    EXPECT_NE(cohesive.find("its cyclic strength is not told: it fails as it is consolidated, at 100 kPa and "
                            "K0 = 0"),
              std::string::npos)
        << cohesive;
    agree(" --set initial.k0=0.1 --set materials.sand.cohesion=5000");
    agree(" --set materials.sand.hydraulic_conductivity=1e-12");
}

TEST(CheckMessages, TellWhichStepsTakeTheLeastTime)
{
    const WorkFolder folder;
    const auto check = [&](const std::string& scene, const std::string& scheme, const std::string& until) {
        const Outcome outcome =
            run_program("check " + example(scene) + " --set analysis.scheme='\"" + scheme + "\"' --until " +
                        until + " -o " + (folder / "check").string());
        EXPECT_EQ(outcome.code, 0) << outcome.output;
        return outcome.output;
    };
    const auto tells = [](const std::string& text, const std::string& words) {
        return text.find(words) != std::string::npos;
    };
    const std::string shaken = check("level_ground_motion", "auto", "1");
    EXPECT_TRUE(tells(shaken, "implicit steps, which suit the scene and take the least time")) << shaken;
    const std::string loaded =
        check("column", "auto", "1e-5"); // a part of the run has the steps of the whole
    EXPECT_TRUE(tells(loaded, "semi-implicit steps, which suit the scene and take the least time")) << loaded;
    const std::string shocked = check("column", "auto", "1e-5 --set run.end_time=1e-5");
    EXPECT_TRUE(tells(shocked, "explicit steps, for so short a run is about sound in the water")) << shocked;
    const std::string dry = check("benchmarks/dry.toml", "implicit", "1e-4");
    EXPECT_TRUE(tells(dry, "limited by the inertia of shear waves")) << dry;
    const std::string fast = check("shake_table", "implicit", "1e-3");
    EXPECT_TRUE(
        tells(fast, "semi-implicit steps at first, which cost less than the implicit ones of 2.78e-5 s that "
                    "accuracy allows"))
        << fast;
}

TEST(CheckMessages, TellOfDampingAndItsFrequencies)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("check " + example("sheet_pile") +
                                        " --set materials.steel.damping_ratio=0.02 --until 1e-3 -o " +
                                        folder.string() + "/check");
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find(" Hz are resolved, damped by 2 % from 0.474 to 19 Hz"), std::string::npos)
        << outcome.output;
}

TEST(CheckMessages, TellWhatABoundaryLeavesUnbalanced)
{
    const WorkFolder folder;
    const std::string check = "check " + example("dike") + " --until 1e-4 -o " + (folder / "check").string();
    const Outcome sound = run_program(check);
    EXPECT_EQ(sound.code, 0) << sound.output;
    EXPECT_NE(sound.output.find("patch tests: 0 % of a constant pressure left unbalanced"), std::string::npos)
        << sound.output;
}

TEST(CheckMessages, RefuseACurveThatLeavesMoreThanTwoPerCent)
{
    // boxes along the grid do not end where the slope does, so that its load and their pressure differ
    const WorkFolder folder;
    const Outcome outcome =
        run_program("check " + example("dike") + " --until 1e-4 --set analysis.interpolation=gimp --set " +
                    "boundaries.surface.pressure=1000 -o " + (folder / "check").string());
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    EXPECT_NE(
        outcome.output.find("error[patch-test]: the nodal forces at the curve \"surface\" leave 4.5 % of a "
                            "pressure on it unbalanced"),
        std::string::npos)
        << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "check"));
}

/// Check a bank with water beside its slope through stages.
Outcome check_bank(const std::string& slope, const std::string& stages)
{
    const WorkFolder folder;
    std::ofstream(folder / "bank.geo") << R"(
Point(1) = {0, 0, 0}; Point(2) = {10, 0, 0}; Point(3) = {10, 5, 0}; Point(4) = {6, 5, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Physical Surface("soil") = {1};
Physical Curve("base") = {1}; Physical Curve("side") = {2}; Physical Curve("slope") = {3, 4};
)";
    std::ofstream(folder / "scene.toml") << R"(scene_version = 1
geometry.file = "bank.geo"
grid.cell_size = 1.0
water.level = 3
materials.soil = { model = "mohr_coulomb", cohesion = 10e3, friction_angle = 30, porosity = 0.4, shear_modulus = 1e7, poisson_ratio = 0.3, hydraulic_conductivity = 1e-4 }
regions.soil.material = "soil"
boundaries.base.soil = "fixed"
boundaries.side.soil = "roller"
[boundaries.slope]
water = "head"
)" + slope + stages;
    return run_program("check " + (folder / "scene.toml").string() + " -o " + (folder / "check").string());
}

TEST(CheckMessages, RefuseWhatAStageOfStabilityWouldRefuse)
{
    const Outcome outcome = check_bank("head = 5\n", R"([[stages]]
name = "full"
kind = "seepage"
[[stages]]
name = "drawdown"
kind = "consolidate"
duration = "1 d"
[stages.boundaries.slope]
head = 2
ramp_time = 36000
[[stages]]
name = "factor"
kind = "stability"
)");
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    EXPECT_NE(
        outcome.output.find("scene.toml:20:8: error[initial-flow]: the water at the curve \"slope\" stands "
                            "2 m high at"),
        std::string::npos)
        << outcome.output;
}

// It has risen in the stage before, and stands.
TEST(CheckMessages, WarnOfNoRampThatHasEnded)
{
    const Outcome outcome = check_bank("head = 5\nramp_time = \"1 h\"\n", R"([[stages]]
name = "rise"
kind = "seepage"
duration = "1 d"
[[stages]]
name = "steady"
kind = "seepage"
)");
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_EQ(outcome.output.find("changes in time"), std::string::npos) << outcome.output;
}

// Its first shaking begins with the water at rest; the second one goes on.
TEST(CheckMessages, TakeAWaveThatGoesOnInALaterStageForNoSuddenRise)
{
    const std::string shakes = R"([[stages]]
name = "gravity"
kind = "settle"
[[stages]]
name = "one"
kind = "shake"
duration = "0.25 s"
[[stages]]
name = "two"
kind = "shake"
duration = "0.25 s"
)";
    const Outcome wave = check_bank("head = 4\nfrequency = 1\n", shakes);
    EXPECT_EQ(wave.code, 0) << wave.output;
    const Outcome sudden = check_bank("head = 3\n", shakes + "boundaries.slope.head = 4\n");
    EXPECT_EQ(sudden.code, 2) << sudden.output;
    EXPECT_NE(sudden.output.find("a variable head begins with the water at rest: give it a ramp_time"),
              std::string::npos)
        << sudden.output;
}

TEST(CheckMessages, AskNothingOfANamedCurveBetweenTwoRegions)
{
    const WorkFolder folder;
    std::ofstream(folder / "layers.geo") << R"(
Point(1) = {0, 0, 0}; Point(2) = {10, 0, 0}; Point(3) = {10, 5, 0}; Point(4) = {0, 5, 0};
Point(5) = {0, 2.7, 0}; Point(6) = {10, 3.1, 0};
Line(1) = {1, 2}; Line(2) = {2, 6}; Line(3) = {6, 5}; Line(4) = {5, 1};
Line(5) = {6, 3}; Line(6) = {3, 4}; Line(7) = {4, 5};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {-3, 5, 6, 7}; Plane Surface(2) = {2};
Physical Surface("low") = {1}; Physical Surface("high") = {2};
Physical Curve("base") = {1}; Physical Curve("sides") = {2, 5, 7, 4};
Physical Curve("top") = {6}; Physical Curve("between") = {3};
)";
    std::ofstream(folder / "scene.toml") << R"(scene_version = 1
[geometry]
file = "layers.geo"
[grid]
cell_size = 0.6
[sampling]
particles_per_cell = [2, 2]
[materials.sand]
model = "linear_elastic"
shear_modulus = "20 MPa"
poisson_ratio = 0.3
porosity = 0.4
[regions.low]
material = "sand"
[regions.high]
material = "sand"
[boundaries.base]
soil = "fixed"
[boundaries.sides]
soil = "roller"
[boundaries.between]
soil = "free"
[boundaries.top]
soil = "free"
[run]
end_time = 1
)";
    const Outcome outcome = run_program("check " + (folder / "scene.toml").string() + " --until 1e-3 -o " +
                                        (folder / "check").string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
}

TEST(CheckMessages, CountTheStepsOfSoilThatSettlesWithinTheTrial)
{
    const WorkFolder folder;
    const std::string words = " --until 1e-4 --set grid.cell_size=0.03 --set relaxation.tolerance=0.9 -o ";
    const Outcome outcome = run_program("check " + example("dike") + words + (folder / "check").string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_TRUE(std::regex_search(outcome.output, std::regex("settling   about 150 steps of [0-9.e-]+ ms\n")))
        << outcome.output;
}

TEST(CheckMessages, SayThatLargeStrainElasticityBeginsFreeOfStress)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("check " + example("verification/bar") + " --until 1e-3 -o " +
                                        (folder / "check").string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("of the weight: the run does not start in equilibrium; soil of "
                                  "neo_hookean is free of stress as drawn, and its weight acts at once"),
              std::string::npos)
        << outcome.output;
    EXPECT_EQ(outcome.output.find("[relaxation] lets the soil settle"), std::string::npos);
}

TEST(CheckMessages, TellTheSteadyFlowAtTheStart)
{
    const WorkFolder folder;
    const std::string scene = example("river_dike/flood.toml") +
                              " --set grid.cell_size=1 --set relaxation.tolerance=0.01 --until 1e-3 -o " +
                              folder.string();
    const std::string check = run_program("check " + scene + "/check").output;
    for (const char* line :
         {"Steady flow at the start\n  [0-9,]+ triangles with edges up to 0\\.[0-9]+ m; the phreatic line is "
          "found in "
          "[0-9]+ iterations, the flow balanced to [0-9.e-]+ of it\n",
          "  discharge 7\\.[0-9]+e-5 m3/s per m, 6\\.[0-9]+ m3 a day\n",
          "  river           takes in 7\\.[0-9]+e-5 m3/s per m, under water up to \\[-6, 3\\]\n",
          "  land            gives off 7\\.[0-9]+e-5 m3/s per m, water leaves into the air up to \\[11\\.",
          "  phreatic line   \\[-30, 3\\], .*, \\[30, 0\\]\n"})
        EXPECT_TRUE(std::regex_search(check, std::regex(line))) << line << '\n' << check;
    const std::string run = run_program("run " + scene + "/run").output;
    EXPECT_TRUE(std::regex_search(
        run,
        std::regex(
            "The water flows steadily at the start, 7\\.[0-9]+e-5 m3/s per m; it leaves land up to \\[11")))
        << run;
    const std::string still = run_program("check " + scene + "/still --set boundaries.river.head=0").output;
    EXPECT_NE(still.find("  none: no water stands above the level, 0 m\n"), std::string::npos) << still;
    const std::string rest = run_program("run " + scene + "/rest --set boundaries.river.head=0").output;
    EXPECT_NE(rest.find("The water does not flow at the start: none stands above the level, 0 m\n"),
              std::string::npos)
        << rest;
}

TEST(CheckMessages, TellTheFlowInTime)
{
    const WorkFolder folder;
    const std::string scene = example("river_dike/drawdown.toml") +
                              " --set grid.cell_size=1 --set relaxation.tolerance=0.01 -o " + folder.string();
    const std::string check = run_program("check " + scene + "/check").output;
    for (const char* line :
         {"Flow after 24h00m\n  [0-9,]+ triangles .* in [0-9]+ iterations, the water balanced to [0-9.e-]+ "
          "of what "
          "has passed the faces\n  the soil loses [0-9.]+ m3 per m of water in that time\n",
          "  river           gives off [0-9.e-]+ m3/s per m, water leaves into the air up to \\[-1"})
        EXPECT_TRUE(std::regex_search(check, std::regex(line))) << line << '\n' << check;
}

} // namespace

} // namespace quicksand
