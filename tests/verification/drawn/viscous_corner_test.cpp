// Soil that reaches beyond the end of its viscous base, in a face that overhangs: what held it at rest.
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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
                for (std::size_t p = 0; p < soil.state.particles.size(); ++p)
                    fastest = std::max(fastest, soil.state.particles.velocity_solid[p].norm());
            }
            EXPECT_LT(fastest / std::sqrt(soil.problem.gravity * corner_height), 1e-6)
                << scheme << " " << base;
            const double weight = 12.0 * corner_height * 2e4; // of the body, roughly [N/m]
            EXPECT_LT(largest_of(soil.state.reactions.x), 0.3 * weight) << scheme << " " << base;
            EXPECT_LT(largest_of(soil.state.reactions.y), 0.3 * weight) << scheme << " " << base;
        }
    }
}

} // namespace
} // namespace quicksand
