// The grid that is chosen where the scene gives none.
#include "io/scene/scene_grid.hpp"
#include "tests/fixtures/slope_example.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

using fixtures::rectangular_section;
using fixtures::SceneFolder;
using fixtures::slope_section;

SceneBoundary wall(const std::string& name, const SoilCondition& soil)
{
    return {{name, soil}, {}};
}

/// The base fixed, rollers at these sides.
Scene scene_with_walls(const std::vector<std::string>& sides)
{
    Scene scene;
    scene.sampling = LatticeSampling{2, 2};
    scene.boundaries = {wall("base", FixedWall{})};
    for (const std::string& side : sides) scene.boundaries.push_back(wall(side, RollerWall{}));
    return scene;
}

GridChoice choose(const Scene& scene, const Section& section)
{
    Diagnostics findings;
    const auto choice = choose_grid(scene, section, findings);
    EXPECT_TRUE(findings.empty()) << findings.render("");
    return choice.value();
}

/// How far a coordinate is from the nearest grid line [cells].
double off_line(double coordinate, double origin, double cell_size)
{
    const double cells = (coordinate - origin) / cell_size;
    return std::abs(cells - std::round(cells));
}

Section transformed(Section section, double scale, const Vector2& move)
{
    const auto transform = [&](Vector2& point) { point = scale * point + move; };
    for (Region& region : section.regions) {
        for (Polygon& polygon : region.polygons) {
            for (Vector2& point : polygon.outer) transform(point);
        }
    }
    for (NamedCurve& curve : section.curves) {
        for (Segment& segment : curve.segments) {
            transform(segment.start);
            transform(segment.end);
        }
    }
    bound_section(section);
    return section;
}

TEST(SceneGrid, PutsWallsAndFlatGroundOnLines)
{
    const GridChoice choice = choose(scene_with_walls({"left", "right"}), slope_section());
    const BackgroundGrid& grid = choice.grid;
    for (const double x : {0.0, 12.0, 4.0, 8.0})
        EXPECT_LT(off_line(x, grid.origin.x(), grid.cell_size), 1e-6);
    for (const double y : {0.0, 2.0, 4.0}) EXPECT_LT(off_line(y, grid.origin.y(), grid.cell_size), 1e-6);
    EXPECT_EQ(grid.origin, Vector2(0.0, 0.0));
    EXPECT_NEAR(grid.cells_x * grid.cell_size, 12.0, 1e-9);
    EXPECT_GE(grid.cells_y * grid.cell_size, 4.0 + 4 * grid.cell_size);
    // a mean of 3 m through 16 cells, moved by less than a fifth
    EXPECT_GT(grid.cell_size, 0.8 * 3.0 / 16.0);
    EXPECT_LT(grid.cell_size, 1.15 * 3.0 / 16.0);
}

TEST(SceneGrid, IsTheSameWhereverAndHoweverLargeTheSoilIs)
{
    for (const auto& sides : {std::vector<std::string>{"left", "right"}, {"right"}, {}}) {
        const Scene scene = scene_with_walls(sides);
        const BackgroundGrid grid = choose(scene, slope_section()).grid;
        for (const double scale : {1.0, 50.0, 0.02}) {
            for (const Vector2& move : {Vector2(0.0, 0.0), Vector2(1000.0, 500.0), Vector2(-0.3, 1.7)}) {
                const BackgroundGrid other = choose(scene, transformed(slope_section(), scale, move)).grid;
                EXPECT_NEAR(other.cell_size, scale * grid.cell_size, 1e-9 * scale * grid.cell_size);
                EXPECT_LT((other.origin - move - scale * grid.origin).norm(),
                          1e-8 * scale * grid.cell_size + 1e-12 * move.norm());
                EXPECT_EQ(other.cells_x, grid.cells_x);
                EXPECT_EQ(other.cells_y, grid.cells_y);
            }
        }
    }
}

TEST(SceneGrid, LeavesRoomWhereNoWallHolds)
{
    const double height = 4.0;
    const BackgroundGrid closed = choose(scene_with_walls({"left", "right"}), slope_section()).grid,
                         open = choose(scene_with_walls({"right"}), slope_section()).grid;
    EXPECT_EQ(closed.origin.x(), 0.0);
    EXPECT_LE(open.origin.x(), -height + 1e-9);
    EXPECT_LT(off_line(12.0, open.origin.x(), open.cell_size), 1e-6) << "the wall that is there";
    EXPECT_NEAR(open.origin.x() + open.cells_x * open.cell_size, 12.0, 1e-9);
    EXPECT_EQ(open.origin.y(), 0.0);
    Scene moving = scene_with_walls({"left"});
    moving.boundaries.push_back(wall("right", MovingWall{}));
    const BackgroundGrid pushed = choose(moving, slope_section()).grid;
    EXPECT_NEAR(pushed.origin.x() + pushed.cells_x * pushed.cell_size, 12.0 + 4 * pushed.cell_size, 1e-9);
    Scene hanging = scene_with_walls({"left", "right"});
    hanging.boundaries.erase(hanging.boundaries.begin());
    const BackgroundGrid below = choose(hanging, slope_section()).grid;
    EXPECT_NEAR(below.origin.y(), -4 * below.cell_size, 1e-9);
}

/// A block may slide on a floor that goes on beyond it.
TEST(SceneGrid, CoversWallsThatGoOnBeyondTheSoil)
{
    Section section = rectangular_section(0.0, 0.0, 6.0, 3.0);
    section.curves.push_back({"floor", {{{6.0, 0.0}, {16.0, -2.0}}}});
    Scene scene = scene_with_walls({});
    scene.boundaries.push_back(wall("floor", RollerWall{}));
    const BackgroundGrid grid = choose(scene, section).grid;
    EXPECT_GE(grid.origin.x() + grid.cells_x * grid.cell_size, 16.0);
    EXPECT_LE(grid.origin.y(), -2.0);
}

TEST(SceneGrid, HasFourCellsThroughTheThinnestRegion)
{
    Section section = rectangular_section(0.0, 0.0, 6.0, 3.0);
    section.regions.push_back({"seam", {{{{0.0, 1.0}, {6.0, 1.0}, {6.0, 1.4}, {0.0, 1.4}}, {}}}});
    section.regions[0].polygons = {{{{0.0, 0.0}, {6.0, 0.0}, {6.0, 1.0}, {0.0, 1.0}}, {}},
                                   {{{0.0, 1.4}, {6.0, 1.4}, {6.0, 3.0}, {0.0, 3.0}}, {}}};
    const GridChoice choice = choose(scene_with_walls({"left", "right"}), section);
    EXPECT_NEAR(choice.grid.cell_size, 0.1, 1e-9) << "0.1 m divides everything";
    ASSERT_EQ(choice.reasons.size(), 2U);
    EXPECT_EQ(choice.reasons[0], "4 cells through the region \"seam\", 0.4 m thick");
    EXPECT_EQ(choice.reasons[1], "room to move: 5 cells above the soil");
}

TEST(SceneGrid, HasTenCellsAlongTheShortestWave)
{
    Scene scene = scene_with_walls({"left", "right"});
    SceneMaterial clay;
    clay.material.name = "clay";
    clay.material.law = LinearElastic{16e6, 0.3};
    clay.material.grain_density = 2500.0;
    clay.material.porosity = 0.36; // dry 1600 kg/m3: 100 m/s
    scene.materials = {clay};
    scene.base_motion = SineMotion{1.0, 10.0, 5.0, 0.0};
    const GridChoice choice = choose(scene, rectangular_section(0.0, 0.0, 60.0, 30.0));
    EXPECT_NEAR(choice.grid.cell_size, 1.0, 1e-9);
    EXPECT_EQ(choice.reasons.at(0), "10 cells along a shear wave of 10 Hz in \"clay\", 100 m/s");
}

TEST(SceneGrid, ChangesTheSizeForWallsAndSaysSo)
{
    // 16 cells through 5.05 m of height, or 10.1 m of width in 32: the walls come before the ground
    const GridChoice choice =
        choose(scene_with_walls({"left", "right"}), rectangular_section(0.0, 0.0, 10.0, 5.05));
    EXPECT_LT(off_line(10.0, 0.0, choice.grid.cell_size), 1e-6);
    ASSERT_EQ(choice.reasons.size(), 3U);
    EXPECT_EQ(choice.reasons[1], "0.3125 m instead of 0.3156, for walls or edges to lie on grid lines");
}

TEST(SceneGrid, StaysWithinTheParticlesThatAMachineRuns)
{
    Section section = rectangular_section(0.0, 0.0, 1000.0, 30.0);
    section.regions.push_back({"film", {{{{0.0, 30.0}, {1000.0, 30.0}, {1000.0, 30.1}, {0.0, 30.1}}, {}}}});
    section.upper.y() = 30.1;
    Diagnostics findings;
    const auto choice = choose_grid(scene_with_walls({"left", "right"}), section, findings);
    ASSERT_TRUE(choice);
    const double particles = 4.0 * 1000.0 * 30.1 / std::pow(choice->grid.cell_size, 2);
    EXPECT_LT(particles, 1.6e5);
    EXPECT_GT(particles, 0.7e5);
    EXPECT_FALSE(findings.has_errors());
    EXPECT_NE(
        findings.render("").find("cells through the region \"film\", 0.1 m thick, where 4 would do: not "
                                 "more than 100000 particles"),
        std::string::npos)
        << findings.render("");
}

TEST(SceneGrid, GivenKeysWin)
{
    Scene scene = scene_with_walls({});
    scene.cell_size = 0.7;
    EXPECT_EQ(choose(scene, slope_section()).grid.cell_size, 0.7);
    scene.grid_origin = Vector2(-0.1, -0.2);
    const BackgroundGrid grid = choose(scene, slope_section()).grid;
    EXPECT_EQ(grid.origin, Vector2(-0.1, -0.2));
    scene.grid_cells = std::pair(30, 20);
    const GridChoice all = choose(scene, slope_section());
    EXPECT_EQ(all.grid.cells_x, 30);
    EXPECT_EQ(all.grid.cells_y, 20);
    EXPECT_TRUE(all.reasons.empty());
    scene.grid_origin = std::nullopt; // cells that were counted by hand begin at the section's corner
    EXPECT_EQ(choose(scene, slope_section()).grid.origin, Vector2(0.0, 0.0));
}

TEST(SceneGrid, ASceneNeedsNone)
{
    const std::string text =
        fixtures::replaced(fixtures::column_scene, "[grid]\ncell_size = \"7.5 mm\"\n", "");
    EXPECT_EQ(SceneFolder().assembly_message(text, fixtures::column_section()), "");
    const AssembledCase column = assemble_case(SceneFolder().read(text), fixtures::column_section());
    EXPECT_NEAR(column.problem.grid.cell_size, 0.0675 / 16.0, 0.2 * 0.0675 / 16.0);
    EXPECT_GT(column.state.particles.size(), 1000U);
    EXPECT_FALSE(column.grid_reasons.empty());
}

} // namespace
} // namespace quicksand
