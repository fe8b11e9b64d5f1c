// Soil that reaches beyond the end of its viscous base, in a face that overhangs: what held it at rest.
#include "solver/boundaries/viscous_boundary.hpp"
#include "tests/fixtures/drawn_section.hpp"
#include "tests/fixtures/grain_speed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double corner_height = 4.3; // of the soil [m]

/// Wet elastic soil on a viscous base at a height [m] on a grid of cells of 1 m, whose right face overhangs
/// by 30 degrees.
AssembledCase overhang(const std::string& scheme, double base)
{
    const std::string text = R"([analysis]
scheme = ")" + scheme + R"("
[sampling]
particles_per_cell = [3, 3]
[water]
level = 20.0
[initial]
k0 = 0.6
[materials.soil]
model = "linear_elastic"
porosity = 0.4
shear_modulus = 5e7
poisson_ratio = 0.3
hydraulic_conductivity = 1e-3
[regions.soil]
material = "soil"
[boundaries.base]
soil = "viscous"
[boundaries.left]
soil = "roller"
[boundaries.right]
soil = "free"
[boundaries.surface]
soil = "free"
[relaxation]
)";
    return assemble(scene_with(1.0, {-1.0, 0.0}, 16, 8, text),
                    polygon_section({{{0.0, base}, "base"},
                                     {{10.0, base}, "right"},
                                     {{12.4826062, base + corner_height}, "surface"},
                                     {{0.0, base + corner_height}, "left"}}));
}

double largest_of(const Scalars& values)
{
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

// Forces of 1e10 N/m that cancelled each other at the nodes held the corner. As points moved by parts of a
// cell they did work: in large strain the corner flew off.
TEST(ViscousCorner, IsHeldAtRestByForcesAsLargeAsTheWeightWhichDoNoWork)
{
    for (const std::string scheme : {"explicit", "semi_implicit", "implicit"}) {
        for (const double base : {1.0, 1.1, 1.5, 1.9}) {
            AssembledCase soil = overhang(scheme, base);
            RelaxationControls controls;
            controls.tolerance = 1e-7;
            relax(soil.problem, controls, soil.state);
            double fastest = 0.0;
            for (int part = 1; part <= 10; ++part) {
                run(soil.problem, 0.01 * part, {}, soil.state);
                fastest = std::max(fastest, largest_speed_of_grains(soil.state.particles));
            }
            EXPECT_LT(fastest / std::sqrt(soil.problem.gravity * corner_height), 1e-6)
                << scheme << " " << base;
            const double weight = 12.0 * corner_height * 2e4; // of the body, roughly [N/m]
            EXPECT_LT(largest_of(soil.state.reactions.x), 0.3 * weight) << scheme << " " << base;
            EXPECT_LT(largest_of(soil.state.reactions.y), 0.3 * weight) << scheme << " " << base;
        }
    }
}

/// A block of one particle by two a cell, whose left side lies on stiff rock.
AssembledCase leaning_block(const std::string& interpolation)
{
    const std::string text = R"([analysis]
interpolation = ")" + interpolation +
                             R"("
scheme = "explicit"
[sampling]
particles_per_cell = [1, 2]
[materials.soil]
model = "linear_elastic"
porosity = 0.4
shear_modulus = 5e7
poisson_ratio = 0.3
[regions.soil]
material = "soil"
[boundaries.base]
soil = "fixed"
[boundaries.left]
soil = "viscous"
rock_density = 2500.0
rock_shear_wave_speed = 1000.0
rock_compression_wave_speed = 2500.0
[boundaries.surface]
soil = "free"
pressure = 1e4
ramp_time = 0.02
[relaxation]
)";
    return assemble(
        scene_with(1.0, {-6.0, 0.0}, 18, 8, text),
        polygon_section(
            {{{0.0, 0.4}, "base"}, {{6.0, 0.4}, ""}, {{6.0, 5.6}, "surface"}, {{-3.7, 6.4}, "left"}}));
}

// Pieces of the side lie up to five half edges outside the domains that carry them: they drove the soil.
TEST(ViscousCorner, BrakesEveryNodeAndByTheWholeSide)
{
    const AssembledCase soil = leaning_block("cpdi2");
    ParticlePlaces places;
    std::vector<Dashpot> dashpots;
    gather_dashpots(soil.problem, soil.state.particles, node_conditions(soil.problem, Stage::shaking), places,
                    dashpots);
    ASSERT_FALSE(dashpots.empty());
    double trace = 0.0;
    for (const auto& [node, xx, xy, yy] : dashpots) {
        EXPECT_GE(std::min(xx, yy), 0.0) << node;
        EXPECT_GE(xx * yy - xy * xy, -1e-9 * xx * yy) << node;
        trace += xx + yy;
    }
    EXPECT_NEAR(trace, 2500.0 * (2500.0 + 1000.0) * std::hypot(3.7, 6.0), 1e-6 * trace);
}

TEST(ViscousCorner, MovesUnderALoadBesideStiffRockAsInOtherDomains)
{
    const auto fastest = [](const std::string& interpolation) {
        AssembledCase soil = leaning_block(interpolation);
        soil.problem.gravity = 0.0;
        run(soil.problem, 0.1, {}, soil.state);
        return largest_speed_of_grains(soil.state.particles);
    };
    const double expected = fastest("cpdi");
    EXPECT_NEAR(fastest("cpdi2"), expected, 0.05 * expected);
}

} // namespace
} // namespace quicksand
