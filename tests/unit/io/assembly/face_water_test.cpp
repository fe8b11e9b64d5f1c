// Water before the soil's faces: the same water said in several words, and what a curve takes by default.
#include "io/assembly/face_water.hpp"
#include "solver/measure/monitors.hpp"
#include "tests/fixtures/slope_example.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {
namespace {

using fixtures::SceneFolder;
using fixtures::slope_scene;
using fixtures::slope_section;

constexpr double water_weight = 1000.0 * standard_gravity; // [N/m3]

AssembledCase assemble_slope(const std::string& water, const std::string& ground = "soil = \"free\"")
{
    return assemble_case(SceneFolder().read(slope_scene(water, ground)), slope_section());
}

const Boundary& boundary(const AssembledCase& assembled, const std::string& name)
{
    const auto& all = assembled.problem.boundaries;
    return *std::find_if(all.begin(), all.end(), [&](const Boundary& b) { return b.name == name; });
}

void expect_same(const AssembledCase& a, const AssembledCase& b)
{
    EXPECT_EQ(a.problem.water->level, b.problem.water->level);
    EXPECT_EQ(a.problem.water->rises_above_level, b.problem.water->rises_above_level);
    std::vector<const Scalars*> arrays;
    for_each_array(a.state.particles, [&](const char*, const Scalars& values) { arrays.push_back(&values); });
    std::size_t k = 0;
    for_each_array(b.state.particles,
                   [&](const char* name, const Scalars& values) { EXPECT_EQ(*arrays[k++], values) << name; });
}

/// Largest excess pressure that the water beyond the ground has at the start [Pa].
double largest_outer_excess(const AssembledCase& assembled)
{
    const Boundary& ground = boundary(assembled, "ground");
    double largest = 0.0;
    if (!has_outer_water(ground.water)) return largest;
    for (const Segment& segment : ground.segments) {
        for (double fraction = 0.0; fraction <= 1.0; fraction += 0.125) {
            const Vector2 point = segment.start + fraction * (segment.end - segment.start);
            largest = std::max(largest, std::abs(outer_excess_pressure(assembled.problem, ground, point)));
        }
    }
    return largest;
}

TEST(FaceWater, StillWaterIsTheSameHoweverItIsSaid)
{
    for (const double height : {5.0, 3.0}) { // above the crest, and up to the middle of the slope
        const std::string y = height == 5.0 ? "5" : "3";
        const std::string line = "level = -7\nphreatic_line = [[0, " + y + "], [12, " + y + "]]";
        const std::string head = "soil = \"free\"\nwater = \"head\"\nhead = " + y;
        const AssembledCase level = assemble_slope("level = " + y);
        EXPECT_EQ(level.problem.water->level, height);
        for (const AssembledCase& other :
             {assemble_slope("level = " + y, head), assemble_slope(line), assemble_slope(line, head)}) {
            expect_same(level, other);
            EXPECT_EQ(largest_outer_excess(other), 0.0);
            EXPECT_TRUE(other.state.particles.water_table.empty());
        }
    }
}

TEST(FaceWater, CountsFromTheLowestWaterOfTheLine)
{
    const std::string line = "phreatic_line = [[0, 3.8], [6, 3], [12, 3]]";
    const AssembledCase low = assemble_slope("level = -7\n" + line),
                        high = assemble_slope("level = 3\n" + line);
    expect_same(low, high);
    EXPECT_EQ(low.problem.water->level, 3.0);
    EXPECT_EQ(largest_outer_excess(low), 0.0) << "the water before the slope is still";
}

TEST(FaceWater, ACurveBelowTheLineTakesItsHead)
{
    // the section turned around, so that the higher water stands before the slope
    Section section = slope_section();
    for (NamedCurve& curve : section.curves) {
        for (Segment& segment : curve.segments)
            segment = {{12.0 - segment.end.x(), segment.end.y()},
                       {12.0 - segment.start.x(), segment.start.y()}};
    }
    Ring& ring = section.regions[0].polygons[0].outer;
    for (Vector2& point : ring) point.x() = 12.0 - point.x();
    std::reverse(ring.begin(), ring.end());
    bound_section(section);
    const std::string line = "level = 1\nphreatic_line = [[0, 3.5], [7, 3.5], [12, 2]]";
    for (const char* words :
         {"soil = \"free\"", "soil = \"free\"\nwater = \"drained\"",
          "soil = \"free\"\nwater = \"impervious\"", "soil = \"free\"\nwater = \"head\"\nhead = 3.5"}) {
        const AssembledCase dam = assemble_case(SceneFolder().read(slope_scene(line, words)), section);
        const Boundary& ground = boundary(dam, "ground");
        ASSERT_TRUE(has_outer_water(ground.water)) << words;
        EXPECT_FALSE(ground.pieces.empty());
        const auto excess = [&](double x, double y) {
            return outer_excess_pressure(dam.problem, ground, {x, y});
        };
        EXPECT_EQ(dam.problem.water->level, 2.0);
        EXPECT_NEAR(excess(1.0, 2.0), 1.5 * water_weight, 1e-9);
        EXPECT_NEAR(excess(6.0, 3.0), 0.5 * water_weight, 1e-9);
        EXPECT_EQ(excess(7.5, 3.75), 0.0) << "above the water";
        const auto heads = heads_of_line(dam.scene, dam.problem.grid, ground);
        EXPECT_EQ(heads.has_value(), !std::holds_alternative<PrescribedWater>(ground.water));
        EXPECT_EQ(heads.value_or(std::pair(3.5, 3.5)), std::pair(3.5, 3.5));
        EXPECT_FALSE(has_outer_water(boundary(dam, "base").water)) << "a wall needs none";
        EXPECT_FALSE(heads_of_line(dam.scene, dam.problem.grid, boundary(dam, "left")));
    }
}

TEST(FaceWater, AHeadWithAHistoryBeginsAtTheLine)
{
    const AssembledCase falling =
        assemble_slope("level = 1\nphreatic_line = [[0, 3.8], [6, 3], [12, 3]]",
                       "soil = \"free\"\nwater = \"head\"\nhead = 2\nramp_time = \"2 s\"");
    const Boundary& ground = boundary(falling, "ground");
    const auto excess = [&](double factor) {
        return outer_excess_pressure(falling.problem, ground, {10.0, 2.0}, factor);
    };
    EXPECT_EQ(excess(0.0), 0.0);
    EXPECT_NEAR(excess(0.5), -0.5 * water_weight, 1e-9);
    EXPECT_NEAR(excess(1.0), -water_weight, 1e-9);
    // half of the way down the water is a level, not half of the pressures
    EXPECT_NEAR(outer_excess_pressure(falling.problem, ground, {7.0, 2.8}, 0.5), -0.2 * water_weight, 1e-9);
}

TEST(FaceWater, NothingHasRisenAtTheStart)
{
    for (const std::string flow : {"coupled", "undrained", "drained"}) {
        std::string water =
            "flow = \"" + flow + "\"\nlevel = -7\nphreatic_line = [[0, 3.8], [8, 2], [12, 1.5]]";
        std::string text = slope_scene(water);
        if (flow != "coupled") text = fixtures::replaced(text, "hydraulic_conductivity = 1e-4\n", "");
        AssembledCase slope = assemble_case(SceneFolder().read(text), slope_section());
        begin_shaking(slope.problem, slope.state);
        const Particles& particles = slope.state.particles;
        ASSERT_EQ(particles.water_table.size(), particles.size());
        double highest = 0.0;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            EXPECT_NEAR(risen_pore_pressure(slope.problem, particles, p), 0.0, 1e-9);
            highest = std::max(highest, excess_pore_pressure(particles, p));
        }
        EXPECT_GT(highest, water_weight) << "the water stands above the level";
        const Monitors sums = monitor(slope.problem, slope.state, {});
        EXPECT_NEAR(sums.max_excess_pore_pressure, 0.0, 1e-9);
        EXPECT_NEAR(sums.max_ru, 0.0, 1e-12);
    }
}

TEST(FaceWater, AnExcessOfTheSceneHasRisen)
{
    const AssembledCase loaded = assemble_case(
        SceneFolder().read(slope_scene("level = -7\nphreatic_line = [[0, 3.8], [8, 2], [12, 1.5]]") +
                           "[initial]\nexcess_pore_pressure = \"3 kPa\"\n"),
        slope_section());
    const Particles& particles = loaded.state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto m = static_cast<std::size_t>(particles.material[p]);
        EXPECT_NEAR(risen_pore_pressure(loaded.problem, particles, p),
                    loaded.problem.materials[m].saturated ? 3000.0 : 0.0, 1e-9);
    }
}

} // namespace
} // namespace quicksand
