// Soil in failure in implicit steps: it slides as in steps that waves limit, moved by its weight alone or
// shaken.
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {
namespace {

using namespace fixtures;

/// What moves the layer, or how it is wet.
struct Case {
    std::string name, tables, conductivity, scheme_of_waves, end_time;
};

/// A layer of 1.4 m on rock of 25 degrees, with friction of 15 degrees.
AssembledCase steep_layer(const Case& drawn, const std::string& scheme)
{
    const std::string text = R"(scene_version = 1
[geometry]
file = "drawing.geo"
[grid]
cell_size = 0.35
origin = [-7.0, -3.5]
[analysis]
scheme = ")" + scheme + "\"\n" +
                             drawn.tables + R"(
[materials.sand]
model = "mohr_coulomb"
shear_modulus = 20e6
poisson_ratio = 0.3
friction_angle = 15.0
cohesion = 0.0
porosity = 0.4
)" + drawn.conductivity + R"(
[regions.soil]
material = "sand"
[boundaries.base]
soil = "fixed"
[run]
end_time = )" + drawn.end_time +
                             "\n";
    return assemble(text, polygon_section({{{0.13, 0.21}, "base"},
                                           {{8.286770083, 4.013564356}, "top"},
                                           {{6.420166489, 4.467206307}, "top"},
                                           {{0.9823197665, 1.931496737}, "top"}}));
}

/// Largest displacement of the soil at the end of the run [m].
double slides_by(AssembledCase layer)
{
    run(layer.problem, layer.scene.end_time, {}, layer.state);
    const Particles& particles = layer.state.particles;
    double largest = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p)
        largest = std::max(largest, (particles.position[p] - particles.reference_position[p]).norm());
    return largest;
}

class FlowingSoil : public testing::TestWithParam<Case> {};

// The elastic stiffness in the place of that of flowing soil let it come to rest: 0.07 m in 0.6 s, not 1.36
// m.
TEST_P(FlowingSoil, SlidesInImplicitStepsAsInThoseThatWavesLimit)
{
    const double by_waves = slides_by(steep_layer(GetParam(), GetParam().scheme_of_waves));
    EXPECT_GT(by_waves, 0.2);
    EXPECT_NEAR(slides_by(steep_layer(GetParam(), "implicit")), by_waves, 0.04 * by_waves);
}

INSTANTIATE_TEST_SUITE_P(
    All, FlowingSoil,
    testing::Values(
        Case{"Dry", "", "", "explicit", "0.4"},
        Case{"UnderWater", "[water]\nlevel = 7\n", "hydraulic_conductivity = 1e-3", "semi_implicit", "0.5"},
        Case{"AfterShaking", "[motion]\nkind = \"sine\"\namplitude = 0.5\nfrequency = 5.0\ncycles = 1\n", "",
             "explicit", "0.5"},
        Case{"Shaken", "[motion]\nkind = \"sine\"\namplitude = 0.02\nfrequency = 2.0\n", "", "explicit",
             "0.5"}),
    [](const testing::TestParamInfo<Case>& drawn) { return drawn.param.name; });

} // namespace
} // namespace quicksand
