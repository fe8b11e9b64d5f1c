// The step that the program chooses bears random motion in bodies that the grid cuts anywhere.
#include "solver/measure/balances.hpp"
#include "solver/run/simulation.hpp"
#include "solver/step/stepper.hpp"
#include "solver/vibration/step_bound.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace quicksand {
namespace {

using namespace fixtures;

/// Twice the kinetic energy of the grains [J/m].
double grain_energy(const Particles& particles)
{
    double energy = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p)
        energy += particles.mass_solid[p] * particles.velocity_solid[p].squaredNorm();
    return energy;
}

/// A column turned by an angle, its grid shifted by an offset in cells.
AssembledCase turned_column(double degrees, double offset, const std::string& keys)
{
    const double h = 0.1;
    const auto corners =
        turned({{{0.0, 0.0}, "base"}, {{0.3, 0.0}, "right"}, {{0.3, 1.0}, ""}, {{0.0, 1.0}, "left"}}, degrees,
               {0.0, 0.0});
    return assemble(scene_with(h, {-1.0 + offset * h, -0.2 + 0.7 * offset * h}, 16, 16, keys),
                    polygon_section(corners));
}

/// The grains' largest energy in 500 steps, at a part of the run's own step, over that after the first, for
/// random velocities.
double growth_in(AssembledCase assembled, double part)
{
    State& state = assembled.state;
    begin_shaking(assembled.problem, state);
    std::mt19937_64 random(7);
    const auto velocity = [&random] { // [m/s]; the same on every machine, which distributions are not
        return 1e-3 * (static_cast<double>(random() >> 11) * 0x1p-52 - 1.0);
    };
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const double x = velocity(), y = velocity();
        state.particles.velocity_solid.set(p, {x, y});
        state.particles.velocity_fluid.set(p, {y, x});
    }
    const auto stepper = make_stepper(assembled.problem);
    const double dt = part * measure_time_step(assembled.problem, state).dt;
    stepper->advance(assembled.problem, dt, state);
    const double first = grain_energy(state.particles);
    double most = 0.0;
    for (int step = 0; step < 500 && most < 100.0 * first; ++step) {
        stepper->advance(assembled.problem, dt, state);
        most = std::max(most, grain_energy(state.particles));
    }
    return most / first;
}

TEST(StableStep, BearsRandomMotionAtAnyAngleAndOffset)
{
    for (const std::string scheme : {"explicit", "semi_implicit"})
        for (const double conductivity : {1e-5, 1e-1})
            for (const double degrees : {0.0, 1.0, 5.0, 17.0, 30.0, 45.0})
                for (const double offset : {0.0, 0.1, 0.25, 0.5, 0.9})
                    EXPECT_LT(growth_in(turned_column(degrees, offset,
                                                      saturated_column(scheme, "small", conductivity)),
                                        1.0),
                              1.0) // measured 0.93 at most
                        << scheme << ' ' << conductivity << ", " << degrees << " degrees, " << offset;
}

TEST(StableStep, BearsRandomMotionWithEveryInterpolation)
{
    const std::string keys = saturated_column("semi_implicit", "small", 1e-5);
    for (const std::string interpolation : {"linear", "gimp", "cpgimp", "cpdi2"}) {
        const std::string chosen = "interpolation = \"" + interpolation + "\"\n";
        const std::string analysis = "[analysis]\n";
        std::string scene = keys;
        scene.insert(scene.find(analysis) + analysis.size(), chosen);
        for (const double degrees : {0.0, 17.0, 30.0})
            for (const double offset : {0.0, 0.5})
                EXPECT_LT(growth_in(turned_column(degrees, offset, scene), 1.0), 1.0)
                    << interpolation << ", " << degrees << " degrees, " << offset;
    }
}

// The step is not far below what the body bears: cells of nearly incompressible soil that shear and bend.
TEST(StableStep, IsCloseToTheLimitOfSoilThatIsNearlyIncompressible)
{
    std::string keys = saturated_column("semi_implicit", "small", 1e-5);
    const std::string ratio = "poisson_ratio = ";
    const std::size_t value = keys.find(ratio) + ratio.size();
    keys.replace(value, keys.find('\n', value) - value, "0.49");
    for (const double degrees : {0.0, 17.0}) {
        EXPECT_LT(growth_in(turned_column(degrees, 0.3, keys), 1.0), 1.0) << degrees;
        EXPECT_GT(growth_in(turned_column(degrees, 0.3, keys), 1.5), 1.0) << degrees;
    }
}

// Cells in the tip have the pressure of another one, with a slope over both. Its force made motion grow that
// the grid's nodes do not know of, from whatever moves the body: here it begins out of equilibrium.
TEST(StableStep, BearsASlopeOfPressureOverTheTipOfAWedge)
{
    const std::string soil = "model = \"linear_elastic\"\nshear_modulus = \"50 MPa\"\npoisson_ratio = 0.3\n";
    const std::string tables = section_in_water(3, "semi_implicit", "20.0", soil) + "[initial]\nk0 = 0.6\n";
    const std::vector<NamedCorner> to_right = {
        {{0.0, 0.0}, "base"}, {{10.0, 0.0}, "right"}, {{2.5522, 4.3}, ""}, {{0.0, 4.3}, "left"}};
    const std::vector<NamedCorner> to_left = {
        {{0.0, 0.0}, "base"}, {{10.0, 0.0}, "right"}, {{10.0, 4.3}, ""}, {{7.4478, 4.3}, "left"}};
    for (const auto& corners : {to_right, to_left})
        for (const double offset : {0.0, 0.3, 0.6}) {
            AssembledCase wedge =
                assemble(scene_with(1.0, {-1.0 + offset, -1.0 + 0.7 * offset}, 14, 8, tables),
                         polygon_section(corners));
            begin_shaking(wedge.problem, wedge.state);
            open_balances(wedge.problem, wedge.state);
            run(wedge.problem, 1.5, {}, wedge.state);
            EXPECT_EQ(wedge.state.times_halved, 0) << offset;
            EXPECT_LT(std::abs(balance(wedge.problem, wedge.state).energy_error), 0.01) << offset;
        }
}

} // namespace
} // namespace quicksand
