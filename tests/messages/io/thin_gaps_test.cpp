// Gaps in the soil that are thinner than the grid sees.
#include "tests/fixtures/drawn_section.hpp"
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using fixtures::NamedCorner;
using fixtures::polygon_section;
using fixtures::SceneFolder;

const std::string slot_scene = R"(scene_version = 1
[geometry]
file = "column.geo"
[grid]
cell_size = 0.25
origin = [0, 0]
cells = [16, 10]
[materials.sand]
model = "linear_elastic"
shear_modulus = "8 MPa"
poisson_ratio = 0.3
porosity = 0.4
[regions.soil]
material = "sand"
)" + fixtures::base_and_sides +
                               R"([boundaries.wall]
soil = "roller"
[run]
end_time = 1.0
)";

/// Soil of 4 x 2 m with a slot from its surface down to y = 0.5 m, from x = `left` to `right` at its foot and
/// moved by `lean` at the surface.
Section slot(double left, double right, double lean = 0.0)
{
    return polygon_section({{{0.0, 0.0}, "base"},
                            {{4.0, 0.0}, "right"},
                            {{4.0, 2.0}, ""},
                            {{right + lean, 2.0}, "wall"},
                            {{right, 0.5}, "wall"},
                            {{left, 0.5}, "wall"},
                            {{left + lean, 2.0}, ""},
                            {{0.0, 2.0}, "left"}});
}

TEST(ThinGap, IsToldWithItsPlaceAndWidth)
{
    EXPECT_EQ(
        SceneFolder().assembly_message(slot_scene, slot(1.9, 2.0)),
        R"(scene.toml:21:1: warning[thin-gap]: soil lies 0.1 m beyond the curve "wall", near (1.95, 1.938) m, less than two cells of 0.25 m: both sides have nodes in common, move together and let water pass
   21 | [boundaries.wall]
      | ^~~~~~~~~~~~~~~~~
expected: a gap of at least 0.5 m
hint: choose smaller cells, or draw what fills the gap as a region of its own
to accept it: accept = ["boundaries.wall"] at the top of the scene
)");
}

TEST(ThinGap, OfTwoCellsOrOfOneAlongTheGridIsNone)
{
    EXPECT_EQ(SceneFolder().assembly_message(slot_scene, slot(1.9, 2.4)), "");
    EXPECT_EQ(SceneFolder().assembly_message(slot_scene, slot(1.75, 2.0)), "");
    EXPECT_NE(SceneFolder().assembly_message(slot_scene, slot(1.8, 2.05)), "");
    EXPECT_NE(SceneFolder().assembly_message(slot_scene, slot(1.75, 2.0, 0.6)), "");
}

TEST(ThinGap, TheTipOfASpikeIsNone)
{
    // rock that rises 0.8 m into the soil, with a tip of 60 degrees
    const Section section = polygon_section({{{0.0, 0.0}, "base"},
                                             {{1.5, 0.0}, "wall"},
                                             {{1.962, 0.8}, "wall"},
                                             {{2.424, 0.0}, ""},
                                             {{4.0, 0.0}, "right"},
                                             {{4.0, 2.0}, ""},
                                             {{0.0, 2.0}, "left"}});
    EXPECT_EQ(SceneFolder().assembly_message(slot_scene, section), "");
}

} // namespace
} // namespace quicksand
