// Water tables that lie within cells, with dry soil above them.
#include "solver/measure/balances.hpp"
#include "solver/verification/solutions/terzaghi.hpp"
#include "tests/fixtures/drawn_section.hpp"
#include "tests/fixtures/grain_speed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace quicksand {
namespace {

using namespace fixtures;

/// Soil on an uneven smooth base between smooth sides, shaken, with water up to a level [m]; `particles` a
/// cell along each side.
AssembledCase shaken_ground(const std::string& particles, const std::string& level, double conductivity)
{
    const std::string text = R"(scene_version = 1
[geometry]
file = "drawing.geo"
[grid]
cell_size = 0.900017242
[run]
end_time = 1.0
[sampling]
particles_per_cell = [)" + particles +
                             "]\n[analysis]\nscheme = \"explicit\"\n[water]\nlevel = " + level + R"(
[initial]
k0 = 0.82
[boundaries.base]
soil = "roller"
[boundaries.left]
soil = "roller"
[boundaries.right]
soil = "roller"
[motion]
kind = "sine"
amplitude = 0.5
frequency = 20
[relaxation]
[materials.soil]
hydraulic_conductivity = )" + std::to_string(conductivity) +
                             elastic.substr(elastic.find("]") + 1);
    return assemble(text, polygon_section({{{0.0, 0.915031559}, "base"},
                                           {{3.02191607, 0.379912006}, "base"},
                                           {{5.58885234, 0.356276202}, "base"},
                                           {{7.79448192, 1.21286719}, "base"},
                                           {{9.62238773, 0.97105387}, "right"},
                                           {{9.62238773, 7.54574645}, "surface"},
                                           {{0.380017654, 7.54574645}, "left"}}));
}

/// Largest velocity of the grains within the time, from rest [m/s].
double fastest_within(double time, AssembledCase ground)
{
    RelaxationControls controls;
    controls.tolerance = 1e-5;
    relax(ground.problem, controls, ground.state);
    double largest = 0.0;
    for (int part = 1; part <= 10; ++part) {
        run(ground.problem, 0.1 * part * time, {}, ground.state);
        largest = std::max(largest, largest_speed_of_grains(ground.state.particles));
    }
    return largest;
}

// Explicit steps of any length made energy here within hundredths of a second, and threw the soil about.
TEST(WaterTable, WithinCellsAboveACutBaseKeepsExplicitStepsStable)
{
    for (const std::string particles : {"1, 3", "3, 3", "4, 4"})
        for (const std::string level : {"2.2", "2.4"})
            for (const double conductivity : {1e-3, 1e-6}) {
                const double fastest = fastest_within(0.1, shaken_ground(particles, level, conductivity));
                EXPECT_LT(fastest, 0.03) << particles << ", " << level << " m, " << conductivity << " m/s";
            }
}

// With three particles a cell their centres lie on a level in the middle of cells, and the particles of a
// flow are not parted there.
TEST(WaterTable, LetsParticlesRestWhoseCentresLieOnIt)
{
    const std::string text = R"(scene_version = 1
[geometry]
file = "drawing.geo"
[grid]
cell_size = 1.0
[run]
end_time = 1.0
[sampling]
particles_per_cell = [3, 3]
[analysis]
strain = "large"
[water]
level = 2.5
initial_flow = "seepage"
[boundaries.base]
soil = "fixed"
[boundaries.left]
soil = "roller"
water = "head"
head = 2.5
[boundaries.right]
soil = "roller"
water = "head"
head = 2.5
[boundaries.surface]
soil = "free"
[motion]
kind = "sine"
amplitude = 0.5
frequency = 2
[relaxation]
[materials.soil]
hydraulic_conductivity = 1e-3
)" + elastic.substr(elastic.find("]") + 1);
    AssembledCase ground = assemble(
        text,
        polygon_section(
            {{{0.0, 0.0}, "base"}, {{6.0, 0.0}, "right"}, {{6.0, 4.0}, "surface"}, {{0.0, 4.0}, "left"}}));
    RelaxationControls controls;
    controls.max_steps = 3000;
    const RelaxationReport report = relax(ground.problem, controls, ground.state);
    EXPECT_TRUE(report.settled);
    EXPECT_LT(report.unbalanced.of_weight, controls.tolerance);
}

/// Ground from the origin on, on a fixed base between rollers; `water` are keys of its water, `tables`
/// others.
AssembledCase box_of_ground(double cell, const Vector2& size, const std::string& scheme,
                            const std::string& water, double conductivity, const std::string& tables)
{
    const auto cells = [&](double side) { return static_cast<int>(std::ceil(side / cell)); };
    const std::string soil = "[materials.soil]\nhydraulic_conductivity = " + std::to_string(conductivity) +
                             elastic.substr(elastic.find("]") + 1);
    return assemble(scene_with(cell, {0.0, 0.0}, cells(size.x()), cells(size.y()),
                               "[sampling]\nparticles_per_cell = [2, 2]\n[analysis]\nscheme = \"" + scheme +
                                   "\"\n[water]\n" + water + base_and_sides + tables + "[relaxation]\n" +
                                   soil),
                    polygon_section({{{0.0, 0.0}, "base"},
                                     {{size.x(), 0.0}, "right"},
                                     {size, "surface"},
                                     {{0.0, size.y()}, "left"}}));
}

// Slopes that followed the means slowly made 12 to 19 % of the energy put in, whatever the step.
TEST(WaterTable, WithinCellsMakesNoEnergyOverManyCycles)
{
    for (const std::string scheme : {"explicit", "semi_implicit"}) {
        AssembledCase ground =
            box_of_ground(1.0, {6.0, 7.5}, scheme, "level = 6.4\nbulk_modulus = 1e8\n", 1e-6,
                          "[motion]\nkind = \"sine\"\namplitude = 0.5\nfrequency = 3\ncycles = 5\n");
        relax(ground.problem, RelaxationControls(), ground.state);
        begin_shaking(ground.problem, ground.state);
        open_balances(ground.problem, ground.state);
        run(ground.problem, 6.0, {}, ground.state);
        EXPECT_LT(std::abs(energy_balance(ground.problem, ground.state).error()), 0.02) << scheme;
    }
}

// Explicit steps gave all particles of the cells at the table their mean: 0.66 for 1.02, 0.49 and 0.11 kPa.
TEST(WaterTable, WithinCellsLeavesTheirParticlesTheSlopeOfTheExcessPressure)
{
    for (const std::string scheme : {"explicit", "semi_implicit", "implicit"})
        for (const double level : {4.1, 4.4, 4.5}) {
            AssembledCase ground =
                box_of_ground(0.5, {2.0, 5.13}, scheme, "level = " + std::to_string(level) + "\n", 2e-4,
                              "[initial]\nexcess_pore_pressure = \"5 kPa\"\n");
            SaturatedSoil soil; // that of `elastic`
            soil.constrained_modulus = 24e6;
            soil.porosity = 0.4;
            soil.hydraulic_conductivity = 2e-4;
            relax(ground.problem, RelaxationControls(), ground.state);
            // the mean over two periods of the wave that the sudden drainage of the table has set off
            const double per_time = time_factor(soil, level, 1.0), middle = 0.1 / per_time;
            constexpr int samples = 40;
            const Particles& particles = ground.state.particles;
            std::map<std::int32_t, double> errors; // [Pa]
            for (int k = 0; k < samples; ++k) {
                const double time = middle + 0.4 * (static_cast<double>(k) / samples - 0.5);
                run(ground.problem, time, {}, ground.state);
                for (std::size_t p = 0; p < particles.size(); ++p) {
                    const double depth = level - particles.position.y[p];
                    if (depth < 0.0) continue;
                    const double exact = 5e3 * terzaghi_pressure_ratio(depth / level, time * per_time);
                    errors[particles.identifier[p]] += (excess_pore_pressure(particles, p) - exact) / samples;
                }
            }
            double largest = 0.0;
            for (const auto& [particle, error] : errors) largest = std::max(largest, std::abs(error));
            EXPECT_LT(largest, 80.0) << scheme << ", " << level << " m"; // [Pa]
        }
}

std::string shared_cell_scene(double level, const std::string& scheme)
{
    return "[analysis]\nscheme = \"" + scheme + "\"\n[water]\nlevel = " + std::to_string(level) + R"(
[sampling]
particles_per_cell = [3, 3]
[materials.soil]
model = "linear_elastic"
shear_modulus = "10 MPa"
poisson_ratio = 0.3
porosity = 0.5
hydraulic_conductivity = 1e-5
[regions.soil]
material = "soil"
)" + base_and_sides +
           "[boundaries.surface]\npressure = 2e4\nramp_time = 1.0\n";
}

/// Ground 8 m high.
Section ground_section()
{
    return polygon_section(
        {{{0.0, 0.0}, "base"}, {{2.0, 0.0}, "right"}, {{2.0, 8.0}, "surface"}, {{0.0, 8.0}, "left"}});
}

/// The same with a solid, the region "block", in its corner.
Section ground_with_block()
{
    Section section = polygon_section({{{0.5, 0.0}, "base"},
                                       {{2.0, 0.0}, "right"},
                                       {{2.0, 8.0}, "surface"},
                                       {{0.0, 8.0}, "left"},
                                       {{0.0, 1.0}, ""},
                                       {{0.5, 1.0}, ""}});
    section.regions.push_back({"block", {{{{0.0, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {0.0, 1.0}}, {}}}});
    for (NamedCurve& curve : section.curves) {
        if (curve.name == "base") curve.segments.push_back({{0.0, 0.0}, {0.5, 0.0}});
        if (curve.name == "left") curve.segments.push_back({{0.0, 1.0}, {0.0, 0.0}});
    }
    bound_section(section);
    return section;
}

const std::string block_of_solid = R"([materials.block]
model = "linear_elastic"
shear_modulus = "100 MPa"
poisson_ratio = 0.3
water = "none"
density = 2400
[regions.block]
material = "block"
)";

/// The largest size of the energy error of 6 s from rest, over those of whole seconds [-].
double largest_energy_error(const std::string& scene, const Section& section)
{
    AssembledCase assembled = assemble(scene_with(0.5, {0.0, 0.0}, 4, 18, scene), section);
    State& state = assembled.state;
    begin_shaking(assembled.problem, state);
    open_balances(assembled.problem, state);
    double largest = 0.0;
    for (double time = 1.0; time <= 6.0; ++time) {
        run(assembled.problem, time, {}, state);
        largest = std::max(largest, std::abs(energy_balance(assembled.problem, state).error()));
    }
    EXPECT_EQ(state.times_halved, 0);
    return largest;
}

TEST(WaterTable, MakesNoEnergyAnywhereWithinACell)
{
    for (const std::string scheme : {"semi_implicit", "implicit"})
        for (const double level : {4.0, 4.05, 4.1, 4.2, 4.3, 4.45, 4.6, 4.7})
            EXPECT_LT(largest_energy_error(shared_cell_scene(level, scheme), ground_section()), 1e-3)
                << level << " m, " << scheme;
}

TEST(WaterTable, MakesNoEnergyWithinACellAboveASolid)
{
    for (const double level : {4.1, 4.2})
        EXPECT_LT(largest_energy_error(shared_cell_scene(level, "semi_implicit") + block_of_solid,
                                       ground_with_block()),
                  1e-3)
            << level << " m";
}

} // namespace
} // namespace quicksand
