// Faces of soil above the water table: whether they are sealed is nothing to the water below.
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double column_cell = 0.1;       // [m]
constexpr double risen_pressure = 5000.0; // excess pressure at the start, below the water table [Pa]

/// A column whose surface lies within a cell, with an excess pressure below a water table. The
/// surface falls to the right by the slope.
AssembledCase column(double level, double slope, const std::string& scheme, const std::string& surface)
{
    const std::string tables =
        "[analysis]\nscheme = \"" + scheme + "\"\n[water]\nlevel = " + std::to_string(level) +
        "\n[initial]\nexcess_pore_pressure = " + std::to_string(risen_pressure) + "\n" + base_and_sides +
        "[boundaries.surface]\nwater = \"" + surface + "\"\n[materials.soil]\n" +
        "hydraulic_conductivity = 1e-4\n" + elastic.substr(elastic.find("]") + 1);
    const double left = 0.96, right = left - 0.4 * slope;
    return assemble(
        scene_with(column_cell, {-0.2, -0.2}, 8, 14, tables),
        polygon_section(
            {{{0.0, 0.0}, "base"}, {{0.4, 0.0}, "right"}, {{0.4, right}, "surface"}, {{0.0, left}, "left"}}));
}

/// Excess pressures of the particles after some time, in the order of their numbers [Pa].
Scalars pressures_after(double time, AssembledCase drawn)
{
    run(drawn.problem, time, {}, drawn.state);
    const Particles& particles = drawn.state.particles;
    Scalars pressure(particles.size());
    for (std::size_t p = 0; p < particles.size(); ++p)
        pressure[static_cast<std::size_t>(particles.identifier[p])] = particles.pore_pressure[p];
    return pressure;
}

TEST(DryFaces, HoldNoWaterBelowThem)
{
    for (const std::string scheme : {"explicit", "semi_implicit", "implicit"})
        for (const double slope : {0.0, 0.2})
            for (const double level : {0.7, 0.76, 0.81, 0.87}) {
                const Scalars drained = pressures_after(0.02, column(level, slope, scheme, "drained")),
                              sealed = pressures_after(0.02, column(level, slope, scheme, "impervious"));
                double difference = 0.0;
                for (std::size_t p = 0; p < drained.size(); ++p)
                    difference = std::max(difference, std::abs(sealed[p] - drained[p]));
                EXPECT_LT(difference, 1e-9 * risen_pressure)
                    << scheme << ", slope " << slope << ", level " << level;
            }
}

TEST(DryFaces, AreThoseBesideSoilWithoutWater)
{
    const AssembledCase dry = column(0.8, 0.2, "semi_implicit", "impervious");
    for (const Boundary& boundary : dry.problem.boundaries)
        for (const Segment& segment : boundary.segments)
            EXPECT_EQ(segment.is_dry, boundary.name == "surface");
    // the surface dips into the water at its right end
    const AssembledCase dipping = column(0.9, 0.2, "semi_implicit", "impervious");
    for (const Boundary& boundary : dipping.problem.boundaries)
        for (const Segment& segment : boundary.segments) EXPECT_FALSE(segment.is_dry) << boundary.name;
}

// A load above the water reaches it by less than single precision's smallest number at first: nothing to
// solve for, where the solver divided zero by zero.
TEST(DryFaces, LeaveWaterThatNothingHasReachedAtRest)
{
    const std::string tables = "[analysis]\nscheme = \"semi_implicit\"\n[gravity]\nacceleration = 0.0\n"
                               "[water]\nlevel = 4.0\n" +
                               base_and_sides + "[boundaries.surface]\npressure = 2e4\n[materials.soil]\n" +
                               "hydraulic_conductivity = 1e-5\n" + elastic.substr(elastic.find("]") + 1);
    AssembledCase drawn = assemble(
        scene_with(0.5, {-0.5, -0.5}, 6, 18, tables),
        polygon_section(
            {{{0.0, 0.0}, "base"}, {{2.0, 0.0}, "right"}, {{2.0, 8.0}, "surface"}, {{0.0, 8.0}, "left"}}));
    EXPECT_TRUE(run(drawn.problem, 0.1, {}, drawn.state));
}

} // namespace
} // namespace quicksand
