// The steady flow that a scene begins with stays steady in a run of two phases, and drives slopes.
#include "io/assembly/initial_flow.hpp"
#include "solver/measure/particle_quantities.hpp"
#include "solver/run/simulation.hpp"
#include "solver/run/strength_reduction.hpp"
#include "tests/fixtures/dam_example.hpp"
#include "tests/fixtures/wedge_example.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double water_weight = 1000.0 * standard_gravity; // of water [N/m3]

/// Changes of the pore pressure in a run, over that of the difference of the heads [-].
struct Change {
    double mean = 0.0, most = 0.0;
};

Change change_in_run(double cell_size, double duration)
{
    DamScene scene;
    scene.cell_size = cell_size;
    scene.rest = "[analysis]\nscheme = \"semi_implicit\"\n";
    AssembledCase dam = assemble(text_of(scene), dam_section());
    RelaxationControls controls;
    controls.tolerance = 1e-4;
    relax(dam.problem, controls, dam.state, {}, {});
    const Scalars before = dam.state.particles.pore_pressure;
    run(dam.problem, duration, {}, dam.state);
    Change change;
    double wet = 0.0;
    const Particles& particles = dam.state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!dam.problem.materials[static_cast<std::size_t>(particles.material[p])].saturated) continue;
        const double part =
            std::abs(particles.pore_pressure[p] - before[static_cast<std::size_t>(p)]) / (8.0 * water_weight);
        change.mean += part;
        change.most = std::max(change.most, part);
        wet += 1.0;
    }
    change.mean /= wet;
    return change;
}

TEST(InitialFlow, StaysSteadyInARun)
{
    // measured after 2 s: mean 0.0010 and 0.0006, most 0.0166, 0.0144 and 0.0075: cells round the pressure
    // where the free surface leaves the dam
    const Change coarse = change_in_run(1.0, 2.0), fine = change_in_run(0.5, 2.0),
                 finest = change_in_run(0.25, 2.0);
    EXPECT_LT(coarse.mean, 0.0015);
    EXPECT_LT(coarse.most, 0.02);
    EXPECT_LT(fine.mean, 0.0009);
    EXPECT_LT(fine.most, 0.016);
    EXPECT_LT(finest.most, 0.009);
    EXPECT_LT(fine.mean, 0.7 * coarse.mean);
    EXPECT_LT(finest.most, 0.7 * fine.most);
}

/// Elastic ground whose water flows from the level to a head on its surface, at rest in the end.
std::string ground_under_head(const std::string& scheme, double level, double head)
{
    return section_in_water(2, scheme, fmt::format("{}\ninitial_flow = \"seepage\"", level),
                            "model = \"linear_elastic\"\nshear_modulus = \"10 MPa\"\npoisson_ratio = 0.3\n") +
           fmt::format("[boundaries.ground]\nsoil = \"free\"\nwater = \"head\"\nhead = {}\n", head);
}

/// Largest change of the pore pressure of any particle in a time after the body has settled [Pa].
double largest_change(AssembledCase body, double tolerance, double time)
{
    RelaxationControls controls;
    controls.tolerance = tolerance;
    relax(body.problem, controls, body.state, {}, {});
    begin_shaking(body.problem, body.state);
    const Scalars before = body.state.particles.pore_pressure;
    run(body.problem, time, {}, body.state);
    double most = 0.0;
    for (std::size_t p = 0; p < before.size(); ++p)
        most = std::max(most, std::abs(body.state.particles.pore_pressure[p] - before[p]));
    return most;
}

/// Largest change of the pore pressure within 20 ms in ground on slanted rock under a head of 8 m, over that
/// of the head [-].
double change_under_still_water(double level, const std::string& scheme)
{
    const Section section = polygon_section(
        {{{0.0, 0.0}, "base"}, {{12.0, 4.0}, "right"}, {{12.0, 6.0}, "ground"}, {{0.0, 6.0}, "left"}});
    constexpr double head = 8.0; // [m]
    const std::string tables = ground_under_head(scheme, level, head);
    return largest_change(assemble(scene_with(0.6, {0.0, -0.1}, 20, 11, tables), section), 1e-7, 0.02) /
           (head * water_weight);
}

// The excess pressure has a kink at the level to which it refers, still water has none.
TEST(InitialFlow, OfStillWaterRestsWhereverTheLevelLies)
{
    for (const char* scheme : {"semi_implicit", "implicit"})
        for (const double level : {1.0, 2.35, 5.0})
            EXPECT_LT(change_under_still_water(level, scheme), 1e-3) << scheme << ' ' << level;
}

/// Largest change of the pore pressure within 0.2 s in ground that rises out of still water which stands at
/// `head` [Pa].
double change_beside_still_water(double head)
{
    const Section section = polygon_section({{{0.0, 0.0}, "base"},
                                             {{12.0, 0.0}, "right"},
                                             {{12.0, 6.1}, "ground"},
                                             {{7.0, 6.1}, "ground"},
                                             {{4.0, 4.4}, "ground"},
                                             {{0.0, 4.4}, "left"}});
    const std::string tables = ground_under_head("semi_implicit", 1.0, head);
    return largest_change(assemble(scene_with(0.4, {0.0, 0.0}, 31, 17, tables), section), 1e-6, 0.2);
}

// Rows of particles are 0.2 m high: a table at 5.65 m was one at 5.6 or 5.8 m.
TEST(InitialFlow, BeginsWithATableWithinParticles)
{
    for (const double head : {5.6, 5.65, 5.7, 5.75})
        EXPECT_LT(change_beside_still_water(head), 50.0) << head; // measured 33 to 43
}

/// A slope of 1:2, 3 m high on 3 m of ground, behind which water stands on a head.
AssembledCase slope_behind_water(double head, const std::string& soil)
{
    const Section section = polygon_section({{{0.0, 0.0}, "base"},
                                             {{24.0, 0.0}, "land_side"},
                                             {{24.0, 3.0}, "land"},
                                             {{16.0, 3.0}, "land"},
                                             {{10.0, 6.0}, "land"},
                                             {{0.0, 6.0}, "river_side"}});
    const std::string tables = R"([water]
level = 3.0
initial_flow = "seepage"
[sampling]
particles_per_cell = [2, 2]
[boundaries.base]
soil = "fixed"
[boundaries.land_side]
soil = "roller"
[boundaries.land]
soil = "free"
[boundaries.river_side]
soil = "roller"
water = "head"
head = )" + std::to_string(head) +
                               "\n" + soil;
    return assemble(scene_with(1.0, {0.0, 0.0}, 24, 7, tables), section);
}

/// Largest change of the vertical effective stress in days of steady flow [Pa].
double change_of_stress(double conductivity)
{
    AssembledCase slope = slope_behind_water(5.9, "[analysis]\nscheme = \"implicit\"\n"
                                                  "[materials.soil]\nmodel = \"linear_elastic\"\n"
                                                  "shear_modulus = 1e7\npoisson_ratio = 0.3\nporosity = 0.4\n"
                                                  "hydraulic_conductivity = " +
                                                      fmt::format("{}", conductivity) +
                                                      "\n[regions.soil]\nmaterial = \"soil\"\n");
    RelaxationControls controls;
    controls.tolerance = 1e-6;
    relax(slope.problem, controls, slope.state, {}, {});
    begin_shaking(slope.problem, slope.state);
    run(slope.problem, 1e5, {}, slope.state);
    return change_of_vertical_stress(1e6, slope);
}

/// The same in a drained wedge with a sharp tip, whose base and side lie off the lines of the grid.
double change_in_wedge(const Vector2& origin, double conductivity)
{
    AssembledCase wedge = settled_wedge(origin, 1e-5, conductivity);
    run(wedge.problem, 0.1 / conductivity, {}, wedge.state); // 1,500 times the time of Terzaghi's solution
    return change_of_vertical_stress(1.0 / conductivity, wedge);
}

double factor_of_slope(double head)
{
    AssembledCase slope = slope_behind_water(head, "[materials.soil]\nhydraulic_conductivity = 1e-4" +
                                                       mohr_coulomb.substr(mohr_coulomb.find("]") + 1));
    begin_shaking(slope.problem, slope.state);
    StrengthReductionControls controls;
    controls.tolerance = 0.01;
    return safety_factor(slope.problem, controls, slope.state).factor;
}

TEST(InitialFlow, LeavesStressesAsTheyAreForDays)
{
    // of some 50 kPa at the base; a stress that grows by 1e-4 Pa/s fails
    EXPECT_LT(change_of_stress(1e-5), 100.0);
}

TEST(InitialFlow, LeavesStressesAsTheyAreWhereverTheGridLies)
{
    // of some 20 kPa at the base
    for (const Vector2& origin : {Vector2(-0.61, -0.57), Vector2(-0.5, -0.57), Vector2(-0.53, -0.69)})
        for (const double conductivity : {1e-3, 1e-5})
            EXPECT_LT(change_in_wedge(origin, conductivity), 100.0)
                << origin.transpose() << ", " << conductivity;
}

TEST(InitialFlow, TakesSafetyFromASlopeAsTheRiverRises)
{
    const double low = factor_of_slope(3.0), middle = factor_of_slope(5.0), high = factor_of_slope(5.9);
    EXPECT_LT(middle, 0.99 * low);
    EXPECT_LT(high, 0.95 * middle);
}

} // namespace
} // namespace quicksand
