// Quays in long steps, where water flows past the wall and its foot.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace quicksand {

namespace {

using namespace testing_program;

/// A wall of steel, half a metre thick, holds 2 m of elastic sand; ground water stands 1 m above the sea.
const char* const quay_drawing = R"(
DefineConstant[tilt = 0.0]; // of the foot against the top [m]
Point(1) = {0, -6, 0}; Point(2) = {12, -6, 0}; Point(3) = {12, 0, 0}; Point(4) = {5.5, 0, 0};
Point(5) = {5.5 + tilt, -4, 0}; Point(6) = {5 + tilt, -4, 0}; Point(7) = {5 + tilt / 2, -2, 0};
Point(8) = {0, -2, 0}; Point(9) = {5, 0, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 7};
Line(7) = {7, 8}; Line(8) = {8, 1}; Line(9) = {4, 9}; Line(10) = {9, 7};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7, 8}; Plane Surface(1) = {1};
Curve Loop(2) = {-5, -4, 9, 10, -6}; Plane Surface(2) = {2};
Physical Surface("sand") = {1}; Physical Surface("wall") = {2};
Physical Curve("base") = {1}; Physical Curve("land_side") = {2}; Physical Curve("sea_side") = {8};
Physical Curve("seabed") = {7}; Physical Curve("land") = {3}; Physical Curve("free") = {9, 10};
)";

const char* const quay_scene = R"(scene_version = 1
[geometry]
file = "quay.geo"
[grid]
cell_size = 0.5
[sampling]
particles_per_cell = [2, 2]
[analysis]
scheme = "implicit"
[water]
level = -2.0
initial_flow = "seepage"
[materials.sand]
model = "linear_elastic"
shear_modulus = 3e7
poisson_ratio = 0.3
porosity = 0.4
hydraulic_conductivity = 1e-4
[materials.steel]
model = "linear_elastic"
water = "none"
shear_modulus = 5e9
poisson_ratio = 0.0
density = 2200.0
[regions.sand]
material = "sand"
[regions.wall]
material = "steel"
[boundaries.base]
soil = "fixed"
[boundaries.sea_side]
soil = "roller"
[boundaries.land_side]
soil = "roller"
water = "head"
head = -1.0
[boundaries.land]
soil = "free"
water = "drained"
[boundaries.seabed]
soil = "free"
water = "drained"
[boundaries.free]
soil = "free"
[[stages]]
name = "flow"
kind = "seepage"
[[stages]]
name = "day"
kind = "consolidate"
duration = "1 d"
)";

// The momentum of water that flows past a seal is none of the grains', and the water of a solid moves with
// it wherever the solid reaches: the wall moved by 0.3 mm in steps of 1,700 s, and to and fro; tilted, the
// run did not get beyond steps of sound.
TEST(Quay, RestsForADayWhileWaterFlowsPastTheWall)
{
    const WorkFolder folder;
    std::ofstream(folder / "quay.geo") << quay_drawing;
    std::ofstream(folder / "scene.toml") << quay_scene;
    for (const char* tilt : {"0", "0.4", "-0.4"}) {
        SCOPED_TRACE(tilt);
        const Outcome outcome =
            run_program("run " + (folder / "scene.toml").string() + " --overwrite --threads 1 -o " +
                        (folder / "out").string() + " --set geometry.parameters.tilt=" + tilt);
        ASSERT_EQ(outcome.code, 0) << outcome.output;
        EXPECT_EQ(outcome.output.find("went bad"), std::string::npos) << outcome.output;
        const std::filesystem::path history = folder / "out/day/history.csv";
        EXPECT_LT(numbers_of(history, "max_displacement_m").back(), 5e-5);
        EXPECT_LT(numbers_of(history, "max_velocity_m_s").back(), 1e-10);
        EXPECT_LT(numbers_of(history, "mean_stress_checkerboard").back(), 5e-3);
    }
}

// Slivers of sand get into the cells of a wall that lies on grid lines at once.
TEST(Quay, ConsolidatesInLongSteps)
{
    const WorkFolder folder;
    for (const char* file : {"scene.toml", "sheet_pile.geo"})
        std::filesystem::copy(std::filesystem::path(example("sheet_pile")) / file, folder / file);
    std::ofstream(folder / "drains.toml") << R"(scene_version = 1
base = "scene.toml"
without = ["motion", "run.end_time"]
[[stages]]
name = "ground_water"
kind = "seepage"
[[stages]]
name = "minute"
kind = "consolidate"
duration = "60 s"
)";
    const Outcome outcome = run_program("run " + (folder / "drains.toml").string() + " --threads 1 -o " +
                                        (folder / "out").string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    std::string last; // of the rows time, step, ...
    std::ifstream steps(folder / "out/minute/steps.csv");
    for (std::string line; std::getline(steps, line);) last = line;
    EXPECT_LT(std::stoi(last.substr(last.find(',') + 1)), 300) << last; // 112, with waves thousands
}

} // namespace

} // namespace quicksand
