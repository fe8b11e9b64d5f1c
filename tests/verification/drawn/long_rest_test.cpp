// Soil at rest stays at rest in implicit steps of hours, wherever the grid lies.
#include "solver/run/simulation.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace quicksand {
namespace {

using namespace fixtures;

/// Largest change of the vertical stress of a dry wedge in 1e5 s [Pa].
double change_at_rest(const Vector2& origin)
{
    const Section section = polygon_section(
        {{{0.0, 0.0}, "base"}, {{6.0, 0.0}, "side"}, {{6.0, 2.0}, "face"}, {{4.0, 2.0}, "face"}});
    const std::string tables = R"([analysis]
scheme = "implicit"
[sampling]
particles_per_cell = [2, 2]
[boundaries.base]
soil = "fixed"
[boundaries.side]
soil = "roller"
[boundaries.face]
soil = "free"
[materials.soil]
model = "linear_elastic"
shear_modulus = 1e7
poisson_ratio = 0.3
porosity = 0.4
[regions.soil]
material = "soil"
)";
    AssembledCase wedge = assemble(scene_with(0.25, origin, 30, 13, tables), section);
    RelaxationControls controls;
    controls.tolerance = 1e-7;
    relax(wedge.problem, controls, wedge.state, {}, {});
    begin_shaking(wedge.problem, wedge.state);
    const Scalars before = wedge.state.particles.stress.yy;
    run(wedge.problem, 1e5, {}, wedge.state);
    double most = 0.0;
    for (std::size_t p = 0; p < before.size(); ++p)
        most = std::max(most, std::abs(wedge.state.particles.stress.yy[p] - before[p]));
    return most;
}

TEST(LongRest, ChangesNoStress)
{
    // of 30 kPa at the base; what settling has left out of balance goes on
    for (const Vector2& origin : {Vector2(-0.5, -0.5), Vector2(-0.61, -0.57), Vector2(-0.53, -0.69)})
        EXPECT_LT(change_at_rest(origin), 1.0) << origin.transpose();
}

} // namespace
} // namespace quicksand
