// The bearing capacity of clay under a strip, (2 + pi) c (Prandtl 1920), as a factor of safety: for clay
// without friction it does not depend on the weight of the soil, and nothing of it on the size of the
// drawing.
#include "solver/run/strength_reduction.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace quicksand {
namespace {

using namespace fixtures;

struct Strip {
    double width = 4.0;         // [m]
    double gravity = 0.0;       // [m/s2]
    double cohesion = 20e3;     // [Pa]
    double depth = 1.0;         // of the ground over the width [-]
    Vector2 shift = {0.0, 0.0}; // of the grid's lines [cells]
};

constexpr double prandtl_factor = 1.285; // (2 + pi) c over the pressure

AssembledCase ground_under(const Strip& strip)
{
    const double B = strip.width, reach = 2.5 * B, depth = strip.depth * B, cell = B / 8.0;
    const Section section = polygon_section({{{-reach, -depth}, "base"},
                                             {{reach, -depth}, "right"},
                                             {{reach, 0.0}, ""},
                                             {{0.5 * B, 0.0}, "load"},
                                             {{-0.5 * B, 0.0}, ""},
                                             {{-reach, 0.0}, "left"}});
    const double pressure = (2.0 + std::numbers::pi) * strip.cohesion / prandtl_factor;
    const std::string gravity = std::to_string(strip.gravity);
    const std::string tables =
        "[analysis]\nstrain = \"small\"\n[sampling]\nparticles_per_cell = [2, 2]\n" + base_and_sides +
        "[boundaries.load]\npressure = " + std::to_string(pressure) +
        "\n[initial]\nk0 = 1.0\n[materials.soil]\nmodel = \"mohr_coulomb\"\nporosity = "
        "0.4\ngrain_density = 3000\nshear_modulus = \"10 MPa\"\npoisson_ratio = "
        "0.49\nfriction_angle = 0\ncohesion = " +
        std::to_string(strip.cohesion) +
        "\n[regions.soil]\nmaterial = \"soil\"\n[relaxation]\n[gravity]\nacceleration = " + gravity + "\n";
    const Vector2 origin = Vector2(-reach - 2.0 * cell, -depth - 2.0 * cell) - cell * strip.shift;
    const int across = static_cast<int>(std::lround(2.0 * reach / cell)) + 5,
              down = static_cast<int>(std::lround(depth / cell)) + 5;
    return assemble(scene_with(cell, origin, across, down, tables), section);
}

double factor_of(const Strip& strip)
{
    AssembledCase assembled = ground_under(strip);
    relax(assembled.problem, *assembled.scene.relaxation, assembled.state);
    StrengthReductionControls controls;
    controls.tolerance = 0.01;
    return safety_factor(assembled.problem, controls, assembled.state).factor;
}

TEST(Bearing, OfClayWithoutFrictionDoesNotDependOnItsWeight)
{
    for (const double gravity : {0.0, 0.01, 1.0, standard_gravity})
        EXPECT_NEAR(factor_of({.gravity = gravity}), prandtl_factor, 0.03) << gravity;
}

TEST(Bearing, IsThatOfAModelAndOfStrongClay)
{
    EXPECT_NEAR(factor_of({.width = 0.1, .gravity = standard_gravity}), prandtl_factor, 0.03);
    EXPECT_NEAR(factor_of({.gravity = standard_gravity, .cohesion = 200e3, .depth = 0.75}), prandtl_factor,
                0.03);
    EXPECT_NEAR(factor_of({.gravity = 1.0, .shift = {0.3, 0.4}}), prandtl_factor, 0.05);
}

} // namespace
} // namespace quicksand
