// The inertia of implicit steps where walls are slanted and cells are cut.
#include "solver/measure/balances.hpp"
#include "solver/step_length/time_step_control.hpp"
#include "tests/fixtures/drawn_section.hpp"
#include "tests/fixtures/inertia_apart.hpp"
#include "tests/fixtures/stored_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace quicksand {
namespace {

using namespace fixtures;

/// A saturated column between rollers on a held base, at an angle to the grid.
AssembledCase column_at(double degrees, double conductivity)
{
    constexpr double h = 0.1;
    const std::vector<NamedCorner> column = {
        {{0.0, 0.0}, "base"}, {{0.5, 0.0}, "right"}, {{0.5, 1.0}, ""}, {{0.0, 1.0}, "left"}};
    return assemble(scene_with(h, {-1.1 + 0.3 * h, -0.3 + 0.6 * h}, 24, 21,
                               saturated_column("implicit", "large", conductivity)),
                    polygon_section(turned(column, degrees, {0.0, 0.0})));
}

/// Small velocities that change from particle to particle.
void stir(State& state)
{
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> velocity(-1e-3, 1e-3);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const double x = velocity(generator), y = velocity(generator);
        state.particles.velocity_solid.set(p, {x, y});
        state.particles.velocity_fluid.set(p, {x, y});
    }
}

// One factor has grains, water, walls and followers; the momentum balance has them node by node.
TEST(DrawnInertia, IsThatOfTheChangeOfVelocityAtAnyAngle)
{
    for (const double degrees : {0.0, 30.0, 75.0}) {
        for (const double conductivity : {1e-2, 1e-4}) {
            AssembledCase assembled = column_at(degrees, conductivity);
            const Problem& problem = assembled.problem;
            State& state = assembled.state;
            begin_shaking(problem, state);
            stir(state);
            SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
            constexpr double dt = 1e-3; // some four times that of the skeleton's waves
            for (int k = 0; k < 5; ++k) {
                advance_semi_implicit_step(problem, dt, state, work);
                EXPECT_FALSE(work.walls.rows.empty());
                EXPECT_LT(inertia_apart(problem, dt, work), 1e-3) << degrees << ' ' << conductivity;
            }
        }
    }
}

// In the long steps after a load that came at once the work of the soil was -7.4 J, that of the load .87 of
// what its way says: stresses before the steps worked, for as long as forces act on velocities.
TEST(DrawnInertia, LeavesWorksThoseOfStressesAndLoadsOnTheirWay)
{
    AssembledCase assembled = assemble(
        scene_with(0.5, {-0.5, -0.5}, 18, 19,
                   R"([analysis]
scheme = "implicit"
strain = "small"
[gravity]
acceleration = 0.0
[sampling]
particles_per_cell = [2, 2]
[materials.soil]
model = "linear_elastic"
shear_modulus = 1e7
poisson_ratio = 0.25
porosity = 0.4
[regions.soil]
material = "soil"
[boundaries.surface]
soil = "free"
pressure = 1000.0
ramp_time = 0.02
)" + base_and_sides),
        polygon_section(
            {{{0.0, 0.0}, "base"}, {{8.0, 0.0}, "right"}, {{8.0, 8.0}, "surface"}, {{0.0, 8.0}, "left"}}));
    State& state = assembled.state;
    begin_shaking(assembled.problem, state);
    open_balances(assembled.problem, state);
    run(assembled.problem, 40.0, {}, state);
    const double settled = 8.0 * 1000.0 / 3e7, of_load = 8.0 * 1000.0 * settled; // [m], [J/m]
    EXPECT_NEAR(stored_energy(assembled.problem, state.particles), 0.5 * of_load, 0.01 * of_load);
    // half of an explicit step of the vibrations before, 2 ms at 6 mm/s under the load, stands between
    EXPECT_NEAR(state.balance_terms->boundary_work, of_load, 0.05 * of_load);
    EXPECT_NEAR(state.balance_terms->skeleton_work, 0.5 * of_load, 0.06 * of_load);
    EXPECT_LT(std::abs(balance(assembled.problem, state).energy_error), 1e-9);
}

} // namespace
} // namespace quicksand
