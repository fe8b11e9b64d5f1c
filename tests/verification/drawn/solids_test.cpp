// Solids without pores on soil: their weight and buoyancy, their stiffness, the water that they seal in.
#include "solver/step/stepper.hpp"
#include "solver/step_length/time_step_control.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double lid_width = 1.0, soil_top = 2.0, lid_thickness = 1.0, solid_cell = 0.25; // [m]
constexpr double lid_density = 2400.0, soil_modulus = 24e6;                               // [kg/m3], M [Pa]

/// A column of elastic soil between rollers on a held base, and a lid of concrete on it, at an angle.
Section lidded_column(double degrees = 0.0)
{
    const auto at = [&](double x, double y) { return turn({x, y}, degrees); };
    const double top = soil_top + lid_thickness;
    Section section = polygon_section({{at(0.0, 0.0), "base"},
                                       {at(lid_width, 0.0), "right"},
                                       {at(lid_width, soil_top), ""},
                                       {at(0.0, soil_top), "left"}});
    const Ring lid = {at(0.0, soil_top), at(lid_width, soil_top), at(lid_width, top), at(0.0, top)};
    section.regions.push_back({"lid", {{lid, {}}}});
    section.curves[1].segments.push_back({at(lid_width, soil_top), at(lid_width, top)});
    section.curves[2].segments.push_back({at(0.0, top), at(0.0, soil_top)});
    section.curves.push_back({"top", {{at(lid_width, top), at(0.0, top)}}});
    bound_section(section);
    return section;
}

const std::string soil_and_lid = R"(
[materials.soil]
model = "linear_elastic"
shear_modulus = "8 MPa"
poisson_ratio = 0.25
porosity = 0.4
hydraulic_conductivity = 1e-3
saturation_above_water = 0.0
[materials.concrete]
model = "linear_elastic"
shear_modulus = "12 GPa"
poisson_ratio = 0.25
water = "none"
density = 2400.0
[regions.soil]
material = "soil"
[regions.lid]
material = "concrete"
)" + base_and_sides;

/// `shift` of the grid's lines against the drawing, in cells; with it the lid ends within cells.
AssembledCase assemble_column(const std::string& tables, double shift = 0.0)
{
    const Vector2 origin = Vector2(-0.25, -0.5) - shift * solid_cell * Vector2(0.0, 1.0);
    return assemble(scene_with(solid_cell, origin, 6, 16, tables + soil_and_lid), lidded_column());
}

/// Turned about the foot of its left side; all sides then lie within cells.
AssembledCase turned_lidded_column(const std::string& tables, double degrees)
{
    return assemble(scene_with(solid_cell, {-3.57, -1.58}, 32, 24, tables + soil_and_lid),
                    lidded_column(degrees));
}

/// Largest deviation of the vertical stress of the soil from that of the weights above, over that at the
/// base.
double stress_error(const AssembledCase& assembled, double level)
{
    const Problem& problem = assembled.problem;
    const Particles& particles = assembled.state.particles;
    const auto buoyant = [&](double density, double from, double to) { // weight of a layer [Pa]
        const double wet = std::clamp(level - from, 0.0, to - from);
        return problem.gravity * (density * (to - from) - 1000.0 * wet);
    };
    const auto soil = [&](double from) { // the pores above the level are empty
        const double wet = std::clamp(level - from, 0.0, soil_top - from);
        return problem.gravity * (0.6 * 2650.0 * (soil_top - from) + 0.4 * 1000.0 * wet - 1000.0 * wet);
    };
    const double lid = buoyant(lid_density, soil_top, soil_top + lid_thickness);
    double worst = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!has_pores(problem, particles, p)) continue;
        const double expected = lid + soil(particles.reference_position.y[p]);
        worst = std::max(worst, std::abs(particles.stress.yy[p] + expected));
    }
    return worst / (lid + soil(0.0));
}

TEST(Solid, WeighsWhatItsDensitySaysLessItsBuoyancy)
{
    for (const double shift : {0.0, 0.37}) {
        for (const double level : {-0.2, 1.5, 2.5, 4.0}) {
            AssembledCase assembled = assemble_column(
                "[water]\nlevel = " + std::to_string(level) + "\n[relaxation]\ntolerance = 1e-5\n", shift);
            const RelaxationReport report =
                relax(assembled.problem, *assembled.scene.relaxation, assembled.state);
            EXPECT_TRUE(report.settled);
            EXPECT_LT(stress_error(assembled, level), shift == 0.0 ? 0.002 : 0.02) << level << ' ' << shift;
        }
    }
}

// Faces and rollers within cells: nodes that follow others and are shared with a solid.
TEST(Solid, SettlesWhereverItLiesOnTheGrid)
{
    Section section = polygon_section({{{-4.0, -4.0}, "base"},
                                       {{4.0, -4.0}, "right"},
                                       {{4.0, 0.0}, ""},
                                       {{0.5, 0.0}, ""},
                                       {{0.5, -2.0}, ""},
                                       {{-0.5, -2.0}, ""},
                                       {{-0.5, 0.0}, ""},
                                       {{-4.0, 0.0}, "left"}});
    section.regions.push_back({"lid", {{{{-0.5, -2.0}, {0.5, -2.0}, {0.5, 0.0}, {-0.5, 0.0}}, {}}}});
    bound_section(section);
    for (const double shift : {0.0, 0.2, 0.5, 0.8}) {
        AssembledCase assembled = assemble(
            scene_with(0.5, {-5.5 + 0.5 * shift, -5.5}, 22, 17,
                       "[sampling]\nparticles_per_cell = [2, 2]\n[water]\nlevel = 1.0\n" + soil_and_lid),
            section);
        RelaxationControls controls;
        controls.tolerance = 1e-4;
        const RelaxationReport report = relax(assembled.problem, controls, assembled.state);
        EXPECT_TRUE(report.settled) << shift;
        EXPECT_LT(report.max_displacement, 3e-3) << shift; // by 10 kPa over some metres of 24 MPa
    }
}

TEST(Solid, TakesNoShorterStepsWhileTheSoilSettles)
{
    AssembledCase stiff = assemble_column("[water]\nlevel = 4.0\n[relaxation]\n");
    AssembledCase soft = stiff;
    for (Material& material : soft.problem.materials)
        if (!material.has_pores) material.law = LinearElastic{8e6, 0.25};
    const RelaxationReport of_stiff = relax(stiff.problem, *stiff.scene.relaxation, stiff.state);
    const RelaxationReport of_soft = relax(soft.problem, *soft.scene.relaxation, soft.state);
    EXPECT_LT(static_cast<double>(of_stiff.steps), 1.5 * static_cast<double>(of_soft.steps));
}

std::string weightless_under_water(double level = 4.0)
{
    return "[gravity]\nacceleration = 0.0\n[water]\nlevel = " + std::to_string(level) + "\n";
}

std::string loaded_top(double ramp)
{
    return "[boundaries.top]\nsoil = \"free\"\nwater = \"drained\"\npressure = \"10 kPa\"\nramp_time = " +
           std::to_string(ramp) + "\n";
}

std::string loaded(const std::string& scheme, double level = 4.0)
{
    return "[analysis]\nscheme = \"" + scheme + "\"\n" + weightless_under_water(level) + loaded_top(0.2);
}

/// Mean excess pore pressure of the soil of a loaded column at an angle, after 1 s, over that which keeps all
/// water in the soil.
double pressure_beneath(AssembledCase assembled, double degrees = 0.0)
{
    constexpr double load = 10e3, storage = 2.2e9 / 0.4; // [Pa]
    begin_shaking(assembled.problem, assembled.state);
    run(assembled.problem, 1.0, {}, assembled.state);
    const Particles& particles = assembled.state.particles;
    double sum = 0.0, volume = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!has_pores(assembled.problem, particles, p)) {
            EXPECT_EQ(excess_pore_pressure(particles, p), 0.0);
            continue;
        }
        const double height = turn(particles.position[p], -degrees).y();
        if (height > soil_top - solid_cell) continue; // soil that shares cells with the lid
        sum += particles.volume[p] * excess_pore_pressure(particles, p);
        volume += particles.volume[p];
    }
    return sum / volume / (load * storage / (soil_modulus + storage));
}

// Soil under a sealed lid keeps its water: of a load it bears M / (M + K_w / n), the water the rest. Through
// a drained top half of it would have gone within 0.2 H^2 / c_v = 0.3 s.
TEST(Solid, SealsTheSoilBeneath)
{
    for (const std::string scheme : {"semi_implicit", "implicit"})
        for (const double shift : {0.0, 0.37, 0.6, 0.92})
            EXPECT_NEAR(pressure_beneath(assemble_column(loaded(scheme), shift)), 1.0, 0.01)
                << scheme << ' ' << shift;
}

TEST(Solid, SealsTheSoilAtAnyAngle)
{
    for (const std::string scheme : {"semi_implicit", "implicit"})
        for (const double degrees : {17.0, -45.0})
            EXPECT_NEAR(pressure_beneath(turned_lidded_column(loaded(scheme), degrees), degrees), 1.0, 0.01)
                << scheme << ' ' << degrees;
}

// The water may end where the lid begins, or within it.
TEST(Solid, SealsTheSoilHoweverHighTheWaterStands)
{
    for (const double above : {0.0, 0.01, 0.6})
        for (const double shift : {0.0, 0.37})
            EXPECT_NEAR(pressure_beneath(assemble_column(loaded("semi_implicit", soil_top + above), shift)),
                        1.0, 0.01)
                << above << ' ' << shift;
    for (const std::string scheme : {"explicit", "implicit"})
        EXPECT_NEAR(pressure_beneath(assemble_column(loaded(scheme, soil_top))), 1.0, 0.01) << scheme;
}

// Of a lid as soft as 100 MPa a load takes load / M off the thickness: the water of its mixture stiffens
// nothing.
TEST(Solid, IsAsStiffAsItsLawUnderWater)
{
    AssembledCase assembled =
        assemble_column("[analysis]\nscheme = \"implicit\"\n" + weightless_under_water() + loaded_top(0.2));
    Problem& problem = assembled.problem;
    for (Material& material : problem.materials)
        if (!material.has_pores) material.law = LinearElastic{40e6, 0.25}; // M = 120 MPa
    begin_shaking(problem, assembled.state);
    run(problem, 1.0, {}, assembled.state);
    const Particles& particles = assembled.state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (has_pores(problem, particles, p)) continue;
        EXPECT_NEAR(particles.stress.yy[p] / -10e3, 1.0, 0.01);
        EXPECT_NEAR((particles.half_edge_2.y[p] / particles.reference_edge_2.y[p] - 1.0) / (-10e3 / 120e6),
                    1.0, 0.02);
    }
}

/// Period in which a suddenly loaded lid swings on dry soil, from the times at which it passes its mean place
/// [s].
double swinging_period(const std::string& scheme)
{
    AssembledCase assembled =
        assemble_column("[analysis]\nscheme = \"" + scheme + "\"\n[gravity]\nacceleration = 0.0\n" +
                        "[boundaries.top]\nsoil = \"free\"\npressure = \"10 kPa\"\n");
    Problem& problem = assembled.problem;
    State& state = assembled.state;
    begin_shaking(problem, state);
    const auto stepper = make_stepper(problem);
    std::vector<double> turns; // times at which the lid stands still
    double before = 0.0;
    while (state.time < 0.4) {
        const double dt = std::min(stable_time_step(problem, state, state.step_scale).dt, 1e-3),
                     time = state.time;
        stepper->advance(problem, dt, state);
        double velocity = 0.0;
        for (std::size_t p = 0; p < state.particles.size(); ++p)
            if (!has_pores(problem, state.particles, p)) velocity += state.particles.velocity_solid.y[p];
        if (before * velocity < 0.0) turns.push_back(time + dt * before / (before - velocity));
        before = velocity;
    }
    return 2.0 * (turns.back() - turns.front()) / static_cast<double>(turns.size() - 1);
}

// A rod of the mass m under a rigid mass m_l: x tan x = m / m_l for the first frequency x c / H.
TEST(Solid, SwingsOnSoilAsARigidMass)
{
    constexpr double density = 0.6 * 2650.0, ratio = density * soil_top / (lid_density * lid_thickness);
    double x = 0.5;
    for (int k = 0; k < 50; ++k) x = std::atan(ratio / x);
    const double period = 2.0 * std::numbers::pi * soil_top / (x * std::sqrt(soil_modulus / density));
    EXPECT_NEAR(swinging_period("implicit") / period, 1.0, 0.01);
    EXPECT_NEAR(swinging_period("explicit") / period, 1.0, 0.01);
}

} // namespace
} // namespace quicksand
