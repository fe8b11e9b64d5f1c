// Layers of soil that are thinner than cells resolve.
#include "tests/fixtures/drawn_section.hpp"
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

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

/// Ground of `width` and 4 m, the region "soil" with a seam of 0.3 m in its middle.
Section layered(double width)
{
    Section section = polygon_section(
        {{{0.0, 0.0}, "base"}, {{width, 0.0}, "right"}, {{width, 4.0}, "surface"}, {{0.0, 4.0}, "left"}});
    const auto box = [width](double lower, double upper) {
        return Region{"", {{{{0.0, lower}, {width, lower}, {width, upper}, {0.0, upper}}, {}}}};
    };
    section.regions = {box(0.0, 2.0), box(2.0, 2.3), box(2.3, 4.0)};
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

std::string message_of(const std::string& seam, double width)
{
    return SceneFolder().assembly_message(layered_scene(regions(seam)), layered(width));
}

TEST(ThinLayer, IsToldWithTheCellsThroughIt)
{
    const std::string message = message_of("clay", 8.0);
    EXPECT_NE(
        message.find(
            R"(scene.toml:26:1: warning[thin-layer]: the region "seam" is 1.2 cells thick: where it lies at an angle to the grid it is too strong, and settles too little where it is far softer than the soil beside it
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
        EXPECT_EQ(message_of(seam, 8.0).find("thin-layer"), std::string::npos) << seam;
}

// The layers of a column are as wide as it is.
TEST(ThinLayer, CountsNoCellsAlongAColumn)
{
    const std::string message = message_of("clay", 0.5);
    EXPECT_NE(message.find("the region \"seam\" is 1.2 cells thick"), std::string::npos) << message;
    EXPECT_EQ(message.find("the region \"lower\""), std::string::npos) << message;
}

} // namespace
} // namespace quicksand
