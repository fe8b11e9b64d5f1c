// The steady flow that a scene begins with: pressures, saturated soil, and what must not matter.
#include "io/assembly/initial_flow.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/run/simulation.hpp"
#include "tests/fixtures/dam_example.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double weight = 1000.0 * standard_gravity; // of water [N/m3]

AssembledCase assemble_dam(const DamScene& dam, const Section& section = dam_section())
{
    return fixtures::assemble(text_of(dam), section);
}

/// Pore pressure with its static part, of the particle nearest to a point; 0 where the soil is dry [Pa].
double pressure_at(const AssembledCase& dam, const Vector2& point)
{
    const Particles& particles = dam.state.particles;
    std::size_t nearest = 0;
    for (std::size_t p = 1; p < particles.size(); ++p)
        if ((particles.position[p] - point).norm() < (particles.position[nearest] - point).norm())
            nearest = p;
    const auto m = static_cast<std::size_t>(particles.material[nearest]);
    if (!dam.problem.materials[m].saturated) return 0.0;
    return particles.pore_pressure[nearest] +
           static_water_pressure(dam.problem, particles.position.y[nearest]);
}

TEST(InitialFlow, HasTheDischargeOfDupuit)
{
    for (const double ratio : {1.0, 0.1}) {
        DamScene scene;
        scene.east = std::to_string(ratio * 1e-3);
        const AssembledCase dam = assemble_dam(scene);
        ASSERT_TRUE(dam.initial_flow);
        const double dupuit = (11.0 * 11.0 - 3.0 * 3.0) / 2.0 / (8.0 / 1e-3 + 8.0 / (ratio * 1e-3));
        EXPECT_NEAR(dam.initial_flow->discharge, dupuit, 0.005 * dupuit) << ratio;
        EXPECT_LT(dam.initial_flow->imbalance, 1e-8);
        double net = 0.0;
        for (const FaceFlow& face : dam.initial_flow->faces) {
            net += face.inflow;
            if (face.name != "right") continue;
            EXPECT_NEAR(face.entry.value().y(), 3.0, 1e-9);
            EXPECT_GT(face.exit.value().y(), 3.0) << "a face of seepage above the tail water";
            EXPECT_LT(face.exit.value().y(), 8.0);
        }
        EXPECT_NEAR(net, 0.0, 1e-8 * dupuit);
    }
}

TEST(InitialFlow, SetsPressuresAndSaturatedSoil)
{
    const AssembledCase dam = assemble_dam(DamScene{});
    const FlowField& field = dam.initial_flow->field;
    const Particles& particles = dam.state.particles;
    EXPECT_TRUE(dam.problem.water->rises_above_level);
    EXPECT_EQ(dam.problem.water->level, 3.0);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 x = particles.position[p];
        const bool wet = dam.problem.materials[static_cast<std::size_t>(particles.material[p])].saturated;
        EXPECT_EQ(wet, x.y() < field.surface(x.x()).value()) << x.transpose();
        const double pressure = wet ? weight * (field.head(x) - x.y()) : 0.0;
        if (wet) {
            const double excess = particles.pore_pressure[p];
            EXPECT_NEAR(pressure, excess + static_water_pressure(dam.problem, x.y()), 1e-6);
            EXPECT_GE(excess, -1e-6);
        }
        EXPECT_LE(pressure, std::max(0.0, weight * (11.0 - x.y()) + 1e-6));
        EXPECT_LE(particles.stress.yy[p], 0.0);
    }
}

TEST(InitialFlow, NothingHasRisenAtTheStartOrAfterSettling)
{
    for (const std::string flow : {"coupled", "undrained", "drained"}) {
        for (const bool settles : {false, true}) {
            DamScene scene;
            scene.water += "\nflow = \"" + flow + "\"";
            AssembledCase dam = assemble_dam(scene);
            if (settles) {
                RelaxationControls controls;
                controls.tolerance = 1e-3;
                relax(dam.problem, controls, dam.state, {}, {});
            } else {
                begin_shaking(dam.problem, dam.state);
            }
            const Monitors sums = monitor(dam.problem, dam.state, {});
            EXPECT_NEAR(sums.max_excess_pore_pressure, 0.0, 1e-6) << flow;
            EXPECT_NEAR(sums.max_ru, 0.0, 1e-9) << flow;
            EXPECT_GT(pressure_at(dam, {0.25, 1.25}), 9.0 * weight) << flow;
        }
    }
}

TEST(InitialFlow, KnowsNoPlaceNoSideAndNoScaleOfConductivity)
{
    const AssembledCase dam = assemble_dam(DamScene{});
    DamScene shifted, mirrored, looser;
    shifted.water = "level = -4.25\ninitial_flow = \"seepage\"";
    shifted.left = "water = \"head\"\nhead = 3.75";
    mirrored.left = "water = \"drained\"";
    mirrored.right = "water = \"head\"\nhead = 11";
    looser.west = looser.east = "5e-2";
    const Vector2 move(100.5, -7.25);
    const AssembledCase there = assemble_dam(shifted, dam_section(move)), turned = assemble_dam(mirrored),
                        fast = assemble_dam(looser);
    const double discharge = dam.initial_flow->discharge;
    EXPECT_NEAR(there.initial_flow->discharge, discharge, 1e-3 * discharge);
    EXPECT_NEAR(turned.initial_flow->discharge, discharge, 2e-3 * discharge);
    EXPECT_NEAR(fast.initial_flow->discharge, 50.0 * discharge, 1e-6 * 50.0 * discharge);
    for (const Vector2& point : {Vector2(1.25, 2.25), Vector2(5.25, 6.25), Vector2(12.25, 1.25)}) {
        const double pressure = pressure_at(dam, point);
        EXPECT_NEAR(pressure_at(there, point + move), pressure, 0.02 * weight);
        EXPECT_NEAR(pressure_at(turned, {16.0 - point.x(), point.y()}), pressure, 0.02 * weight);
        EXPECT_NEAR(pressure_at(fast, point), pressure, 1e-6 * weight);
    }
}

TEST(InitialFlow, IsStillWaterWhereAllHeadsAreTheLevel)
{
    DamScene seeping, still;
    seeping.left = still.left = "water = \"head\"\nhead = 3";
    still.water = "level = 3";
    const AssembledCase a = assemble_dam(seeping), b = assemble_dam(still);
    EXPECT_FALSE(a.initial_flow);
    EXPECT_FALSE(a.problem.water->rises_above_level);
    std::vector<const Scalars*> arrays;
    for_each_array(a.state.particles, [&](const char*, const Scalars& values) { arrays.push_back(&values); });
    std::size_t k = 0;
    for_each_array(b.state.particles,
                   [&](const char* name, const Scalars& values) { EXPECT_EQ(*arrays[k++], values) << name; });
}

TEST(InitialFlow, StandsAtOneHeadWithoutFlow)
{
    DamScene scene;
    scene.left = scene.right = "water = \"head\"\nhead = 7";
    const AssembledCase dam = assemble_dam(scene);
    EXPECT_NEAR(dam.initial_flow->discharge, 0.0, 1e-9);
    for (const double x : {0.5, 8.0, 15.5}) EXPECT_NEAR(*dam.initial_flow->field.surface(x), 7.0, 0.1);
    EXPECT_NEAR(pressure_at(dam, {8.25, 2.25}), 4.75 * weight, 0.01 * weight);
}

TEST(InitialFlow, AHeadThatRisesBeginsAtTheLevel)
{
    DamScene scene;
    scene.left += "\nramp_time = \"5 s\"";
    EXPECT_FALSE(assemble_dam(scene).initial_flow);
}

TEST(InitialFlow, ADrainWithoutPressureLowersTheLine)
{
    DamScene drained;
    drained.right = "water = \"pore_pressure\"\npore_pressure = 0";
    drained.water = "level = 0\ninitial_flow = \"seepage\"";
    const AssembledCase dam = assemble_dam(drained);
    const double dupuit = 1e-3 * 11.0 * 11.0 / (2.0 * 16.0);
    EXPECT_NEAR(dam.initial_flow->discharge, dupuit, 0.005 * dupuit);
    EXPECT_LT(*dam.initial_flow->field.surface(15.5), *dam.initial_flow->field.surface(8.0));
}

} // namespace
} // namespace quicksand
