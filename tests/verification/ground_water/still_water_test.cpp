// Still water beside and above a slope, said in several ways: one settled state, one run, and no excess
// pressure.
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

/// A slope of sand 4 m high off the grid lines; `water` are keys of [water], `face` those of its curve.
AssembledCase still_slope(const std::string& water, const std::string& face, const std::string& motion)
{
    const std::string text = "[analysis]\nscheme = \"semi_implicit\"\n[water]\n" + water + R"(
[materials.sand]
model = "ubcsand"
relative_density = "50 %"
porosity = 0.43
hydraulic_conductivity = 1e-4
[regions.soil]
material = "sand"
)" + base_and_sides + R"([boundaries.ground]
soil = "free"
)" + face + "\n[relaxation]\ntolerance = 1e-7\n" +
                             motion;
    return assemble(scene_with(1.0, {-1.0, -1.0}, 18, 9, text), polygon_section({{{0.13, 0.21}, "base"},
                                                                                 {{16.0, 0.21}, "right"},
                                                                                 {{16.0, 2.21}, "ground"},
                                                                                 {{12.0, 2.21}, "ground"},
                                                                                 {{4.0, 5.21}, "ground"},
                                                                                 {{0.13, 5.21}, "left"}}));
}

void settle_slope(AssembledCase& body)
{
    relax(body.problem, *body.scene.relaxation, body.state);
}

struct WaterDescription {
    std::string keys, face;
};

std::vector<WaterDescription> descriptions(const std::string& y)
{
    const std::string line = "level = 0.0\nphreatic_line = [[0, " + y + "], [16, " + y + "]]";
    const std::string head = "water = \"head\"\nhead = " + y;
    return {{"level = " + y, ""}, {"level = " + y, head}, {line, ""}, {line, head}};
}

TEST(StillWater, GivesOneSettledStateAndOneRunHoweverItIsSaid)
{
    const std::string motion = "[motion]\nkind = \"sine\"\namplitude = 2.0\nfrequency = 5.0\n";
    for (const std::string y : {"6.0", "3.6"}) { // above the crest, and on the slope
        std::vector<AssembledCase> all;
        for (const WaterDescription& water : descriptions(y))
            all.push_back(still_slope(water.keys, water.face, motion));
        for (AssembledCase& body : all) settle_slope(body);
        const Particles& first = all.front().state.particles;
        for (const AssembledCase& other : all) EXPECT_EQ(other.state.particles.stress.yy, first.stress.yy);
        for (AssembledCase& body : all) run(body.problem, 0.1, {}, body.state);
        for (const AssembledCase& other : all) {
            EXPECT_EQ(other.state.particles.pore_pressure, first.pore_pressure) << y;
            EXPECT_EQ(other.state.particles.position.x, first.position.x) << y;
        }
    }
}

TEST(StillWater, LeavesNoExcessPressureInSandAtRest)
{
    for (const WaterDescription& water : descriptions("3.6")) {
        AssembledCase body = still_slope(water.keys, water.face, "");
        settle_slope(body);
        run(body.problem, 0.5, {}, body.state);
        const Particles& particles = body.state.particles;
        double largest = 0.0;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const double bears = std::max(particles.initial_vertical_effective_stress[p], 1e3);
            largest = std::max(largest, std::abs(excess_pore_pressure(particles, p)) / bears);
        }
        EXPECT_LT(largest, 1e-4) << water.keys << ' ' << water.face;
    }
}

} // namespace
} // namespace quicksand
