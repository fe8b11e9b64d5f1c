// Faces that slide with less than the strength of the soil: slabs and blocks on soil against Coulomb's law.
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double slab_cell = 0.25, bed_height = 1.0, slab_thickness = 0.5; // [m]
constexpr double slab_density = 2400.0;                                    // [kg/m3]
constexpr double radians_per_degree = std::numbers::pi / 180.0;
const double face_friction = std::tan(20.0 * radians_per_degree); // of the faces [-]

const std::string concrete = R"([materials.concrete]
model = "linear_elastic"
shear_modulus = "200 MPa"
poisson_ratio = 0.2
water = "none"
density = 2400.0
[regions.slab]
material = "concrete"
[regions.soil]
material = "soil"
)";

std::string soil_of_law(const std::string& law)
{
    return "[materials.soil]\nporosity = 0.4\n" + law;
}

const std::string friction_soil = R"(model = "mohr_coulomb"
shear_modulus = "20 MPa"
poisson_ratio = 0.3
friction_angle = 38.0
)";

struct Sampled {
    double shift = 0.0; // of the grid's lines against the drawing [cells]
    int per_cell = 2;   // particles along an edge of a cell
};

/// A slab on a column of dry soil between tied sides, settled: a piece of one without ends.
AssembledCase slab_on_soil(const std::string& tables, const Sampled& sampled = {})
{
    constexpr double width = 0.5, top = bed_height + slab_thickness;
    Section section = polygon_section({{{0.0, 0.0}, "base"},
                                       {{width, 0.0}, "right"},
                                       {{width, bed_height}, ""},
                                       {{0.0, bed_height}, "left"}});
    section.regions.push_back(
        {"slab", {{{{0.0, bed_height}, {width, bed_height}, {width, top}, {0.0, top}}, {}}}});
    section.curves[1].segments.push_back({{width, bed_height}, {width, top}});
    section.curves[2].segments.push_back({{0.0, top}, {0.0, bed_height}});
    bound_section(section);
    const std::string count = std::to_string(sampled.per_cell);
    AssembledCase assembled =
        assemble(scene_with(slab_cell, {-0.25, -0.5 - sampled.shift * slab_cell}, 4, 10,
                            "[sampling]\nparticles_per_cell = [" + count + ", " + count + "]\n" + tables +
                                concrete + base_and_tied_sides),
                 section);
    RelaxationControls controls;
    controls.tolerance = 1e-4;
    EXPECT_TRUE(relax(assembled.problem, controls, assembled.state).settled);
    begin_shaking(assembled.problem, assembled.state);
    return assembled;
}

Vector2 velocity_of_slab(const AssembledCase& assembled)
{
    const Particles& particles = assembled.state.particles;
    Vector2 momentum = Vector2::Zero();
    double mass = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (assembled.problem.region_names[static_cast<std::size_t>(particles.region[p])] != "slab") continue;
        momentum += particles.mass_solid[p] * particles.velocity_solid[p];
        mass += particles.mass_solid[p];
    }
    return momentum / mass;
}

/// Mean acceleration of the slab under a push per mass in a quarter of a second from a time on: 0.2 s where
/// it breaks loose; 0.3 s where it sticks, and the slip that the vibrations of the push cause has ended
/// [m/s2].
Vector2 acceleration(AssembledCase& assembled, const Vector2& push, double from = 0.2)
{
    constexpr double ramp = 0.15; // a sudden push would swing to twice its force [s]
    assembled.problem.body_acceleration = [push](const Vector2&, double time) {
        return Vector2(std::min(time / ramp, 1.0) * push);
    };
    run(assembled.problem, from, {}, assembled.state);
    const Vector2 before = velocity_of_slab(assembled);
    const double start = assembled.state.time;
    run(assembled.problem, from + 0.25, {}, assembled.state);
    return (velocity_of_slab(assembled) - before) / (assembled.state.time - start);
}

double slab_acceleration(const std::string& tables, double push, const Sampled& sampled = {})
{
    AssembledCase assembled = slab_on_soil(tables, sampled);
    return acceleration(assembled, {push, 0.0}).x();
}

std::string face(const std::string& keys)
{
    return "[interfaces.foot]\nregions = [\"slab\", \"soil\"]\n" + keys;
}

// A slab that slides is pushed by its weight's share less the friction of its face.
TEST(Interface, SlidesAtItsFriction)
{
    const std::string tables = soil_of_law(friction_soil) + face("friction_angle = 20.0\n");
    for (const double shift : {0.0, 0.3, 0.6, 0.9})
        for (const int per_cell : {2, 3})
            for (const double push : {0.5, -0.5})
                EXPECT_NEAR(std::copysign(
                                slab_acceleration(tables, push * standard_gravity, {shift, per_cell}), 1.0) /
                                standard_gravity,
                            0.5 - face_friction, 0.02 * face_friction)
                    << shift << ' ' << per_cell << ' ' << push;
}

TEST(Interface, SticksBelowItsFriction)
{
    const std::string tables = soil_of_law(friction_soil) + face("friction_angle = 20.0\n");
    for (const double shift : {0.0, 0.6}) {
        AssembledCase assembled = slab_on_soil(tables, {shift, 2});
        const Vector2 push(0.97 * face_friction * standard_gravity, 0.0);
        EXPECT_NEAR(acceleration(assembled, push, 0.3).x() / standard_gravity, 0.0, 0.001) << shift;
    }
}

TEST(Interface, HasAShareOfTheSoilsStrength)
{
    const double share = 0.5 * std::tan(38.0 * radians_per_degree);
    EXPECT_NEAR(slab_acceleration(soil_of_law(friction_soil) + face("strength_ratio = 0.5\n"),
                                  0.6 * standard_gravity) /
                    standard_gravity,
                0.6 - share, 0.02 * share);
}

// Adhesion alone: the face slides at c, whatever its weight.
TEST(Interface, SlidesAtItsAdhesion)
{
    constexpr double adhesion = 4e3; // [Pa]
    const std::string clay = "model = \"mohr_coulomb\"\nshear_modulus = \"20 MPa\"\npoisson_ratio = 0.45\n"
                             "friction_angle = 0.0\ncohesion = 20e3\n";
    // of the slab and the half of the cell that slides with it
    const double mass = slab_density * slab_thickness + 0.5 * slab_cell * 0.6 * 2650.0;
    const double share = adhesion / mass / standard_gravity;
    EXPECT_NEAR(slab_acceleration(soil_of_law(clay) + face("friction_angle = 0.0\ncohesion = 4000.0\n"),
                                  0.6 * standard_gravity) /
                    standard_gravity,
                0.6 - share, 0.03 * share);
}

/// A slab of 6 x 0.5 m on as long a bed of soil, drawn level and turned; both ends are free.
AssembledCase slab_on_slope(double slope_degrees)
{
    constexpr double length = 6.0, bed = 1.5, fine = 0.5 * slab_cell;
    const auto at = [&](double x, double y) { return turn({x, y}, -slope_degrees); };
    Section section = polygon_section(
        {{at(0.0, 0.0), "base"}, {at(length, 0.0), ""}, {at(length, bed), ""}, {at(0.0, bed), ""}});
    section.regions.push_back(
        {"slab",
         {{{at(0.0, bed), at(length, bed), at(length, bed + slab_thickness), at(0.0, bed + slab_thickness)},
           {}}}});
    bound_section(section);
    const std::string strong =
        "model = \"mohr_coulomb\"\nshear_modulus = \"20 MPa\"\npoisson_ratio = 0.3\nfriction_angle = 38.0\n"
        "cohesion = 20e3\n";
    AssembledCase assembled = assemble(scene_with(fine, {-1.0, -5.13}, 72, 68,
                                                  "[sampling]\nparticles_per_cell = [2, 2]\n" +
                                                      soil_of_law(strong) + face("friction_angle = 20.0\n") +
                                                      concrete + "[boundaries.base]\nsoil = \"fixed\"\n"),
                                       section);
    begin_shaking(assembled.problem, assembled.state);
    return assembled;
}

// The edge is at an angle to the grid.
TEST(Interface, SlidesOnASlopeAboveItsAngleAndRestsBelow)
{
    for (const double slope : {17.0, 25.0, 35.0}) {
        AssembledCase assembled = slab_on_slope(slope);
        const double along =
            acceleration(assembled, Vector2::Zero()).dot(turn({1.0, 0.0}, -slope)) / standard_gravity;
        const double share = face_friction * std::cos(slope * radians_per_degree);
        EXPECT_NEAR(along, std::max(0.0, std::sin(slope * radians_per_degree) - share), 0.05 * share)
            << slope;
    }
}

TEST(Interface, SlidesInSandOfEveryLaw)
{
    for (const std::string law :
         {"model = \"ubcsand\"\nrelative_density = 0.6\n", "model = \"pm4sand\"\nrelative_density = 0.6\n"})
        EXPECT_NEAR(
            slab_acceleration(soil_of_law(law) + face("friction_angle = 20.0\n"), 0.5 * standard_gravity) /
                standard_gravity,
            0.5 - face_friction, 0.04 * face_friction)
            << law;
}

} // namespace
} // namespace quicksand
