// Layers of soil that are thinner than cells resolve.
#include "io/assembly/thin_layers.hpp"
#include "tests/fixtures/drawn_section.hpp"
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

using fixtures::polygon_section;
using fixtures::SceneFolder;

std::string layered_scene(const std::string& materials_of_regions)
{
    return R"(scene_version = 1
[geometry]
file = "column.geo"
[grid]
cell_size = 0.25
[materials.sand]
model = "linear_elastic"
shear_modulus = "8 MPa"
poisson_ratio = 0.3
porosity = 0.4
[materials.clay]
model = "linear_elastic"
shear_modulus = "1 MPa"
poisson_ratio = 0.3
porosity = 0.4
[materials.wall]
model = "linear_elastic"
shear_modulus = "1 GPa"
poisson_ratio = 0.3
water = "none"
density = 2400
)" + materials_of_regions +
           fixtures::base_and_sides + R"([boundaries.surface]
[run]
end_time = 1.0
)";
}

/// Ground of `width` and 4 m with a seam of 0.3 m in its middle that rises by `slope`.
Section layered(double width, double slope)
{
    Section section = polygon_section(
        {{{0.0, 0.0}, "base"}, {{width, 0.0}, "right"}, {{width, 4.0}, "surface"}, {{0.0, 4.0}, "left"}});
    const double rise = slope * width, low = 2.0 - 0.5 * rise, high = low + 0.3 * std::hypot(1.0, slope);
    const auto part = [&](double left, double right, double left_top, double right_top) {
        return Region{"", {{{{0.0, left}, {width, right}, {width, right_top}, {0.0, left_top}}, {}}}};
    };
    section.regions = {part(0.0, 0.0, low, low + rise), part(low, low + rise, high, high + rise),
                       part(high, high + rise, 4.0, 4.0)};
    section.regions[0].name = "lower", section.regions[1].name = "seam", section.regions[2].name = "upper";
    bound_section(section);
    return section;
}

std::string regions(const std::string& seam)
{
    return "[regions.lower]\nmaterial = \"sand\"\n[regions.upper]\nmaterial = \"sand\"\n[regions.seam]\n"
           "material = \"" +
           seam + "\"\n";
}

std::string message_of(const std::string& seam, const Section& section)
{
    return SceneFolder().assembly_message(layered_scene(regions(seam)), section);
}

TEST(ThinLayer, IsToldWithTheCellsThroughIt)
{
    const std::string message = message_of("clay", layered(8.0, 0.1));
    EXPECT_NE(
        message.find(
            R"(scene.toml:26:1: warning[thin-layer]: the region "seam" is 1.2 cells thick and lies at an angle to the grid: it is too strong where it is weak
   26 | [regions.seam]
      | ^~~~~~~~~~~~~~
expected: cells of at most 0.075 m, 4 through the layer
hint: without grid.cell_size the program chooses such cells
to accept it: accept = ["regions.seam"] at the top of the scene
)"),
        std::string::npos)
        << message;
}

TEST(ThinLayer, IsNoneOfASoilThatGoesOnBesideNorASolid)
{
    for (const std::string seam : {"sand", "wall"})
        EXPECT_EQ(message_of(seam, layered(8.0, 0.1)).find("thin-layer"), std::string::npos) << seam;
}

TEST(ThinLayer, IsNoneOfASoilThatDiffersByItsDampingAlone)
{
    const std::string clay = "shear_modulus = \"1 MPa\"\n";
    const std::string scene = fixtures::replaced(layered_scene(regions("clay")), clay,
                                                 "shear_modulus = \"8 MPa\"\ndamping_ratio = 0.03\n");
    EXPECT_EQ(SceneFolder().assembly_message(scene, layered(8.0, 0.1)).find("thin-layer"), std::string::npos);
}

TEST(ThinLayer, MayBeLevel)
{
    EXPECT_EQ(message_of("clay", layered(8.0, 0.0)).find("thin-layer"), std::string::npos);
}

// The slopes of a dike are no faces of a layer, and 2.98 cells are not three.
TEST(ThinLayer, IsNoDikeOnLevelGround)
{
    Section dike;
    dike.regions = {
        {"ground", {{{{0.0, 0.0}, {20.0, 0.0}, {20.0, 3.0}, {16.0, 3.0}, {4.0, 3.0}, {0.0, 3.0}}, {}}}},
        {"dike", {{{{4.0, 3.0}, {16.0, 3.0}, {11.0, 5.0}, {9.0, 5.0}}, {}}}}};
    Scene scene;
    scene.regions = {{.name = "dike", .material = "clay", .place = {}},
                     {.name = "seam", .material = "clay", .place = {}}};
    scene.materials.resize(1);
    scene.materials[0].material.name = "clay";
    Diagnostics none, some;
    check_layers(scene, dike, 1.0, none); // 2 cells high
    EXPECT_EQ(none.render(""), "");
    check_layers(scene, layered(8.0, 0.1), 0.3 / 2.98, some);
    EXPECT_NE(some.render("").find("2.9 cells thick"), std::string::npos) << some.render("");
}

// From corner to corner, in two parts, and where no soil is.
TEST(ThinLayer, IsToldByItsShapeAlone)
{
    Section steep = layered(4.0, 0.8);
    EXPECT_NE(message_of("clay", steep).find("thin-layer"), std::string::npos);
    Section twice = layered(8.0, 0.1);
    Polygon above = twice.regions[1].polygons[0];
    for (Vector2& corner : above.outer) corner.y() += 0.8;
    twice.regions[1].polygons.push_back(above);
    Diagnostics findings;
    Scene scene;
    scene.materials.resize(1);
    scene.materials[0].material.name = "clay";
    scene.regions = {{.name = "seam", .material = "clay", .place = {}}};
    check_layers(scene, twice, 0.25, findings);
    EXPECT_NE(findings.render("").find("1.2 cells thick"), std::string::npos) << findings.render("");
    Diagnostics none;
    twice.regions[1].polygons.clear();
    check_layers(scene, twice, 0.25, none);
    EXPECT_EQ(none.render(""), "");
}

} // namespace
} // namespace quicksand
