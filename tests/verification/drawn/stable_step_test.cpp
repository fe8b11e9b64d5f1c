// The step that the program chooses bears random motion in bodies that the grid cuts anywhere.
#include "solver/step/stepper.hpp"
#include "solver/step/time_step_control.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

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

/// The grains' largest energy in 500 steps over that after the first, for random velocities.
double growth_in(double degrees, double offset, const std::string& scheme, double conductivity)
{
    const double h = 0.1;
    const auto corners =
        turned({{{0.0, 0.0}, "base"}, {{0.3, 0.0}, "right"}, {{0.3, 1.0}, ""}, {{0.0, 1.0}, "left"}}, degrees,
               {0.0, 0.0});
    AssembledCase assembled = assemble(scene_with(h, {-1.0 + offset * h, -0.2 + 0.7 * offset * h}, 16, 16,
                                                  saturated_column(scheme, "small", conductivity)),
                                       polygon_section(corners));
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
    const double dt = stable_time_step(assembled.problem, state.particles).dt;
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
                    EXPECT_LT(growth_in(degrees, offset, scheme, conductivity), 1.0) // measured 0.93 at most
                        << scheme << ' ' << conductivity << ", " << degrees << " degrees, " << offset;
}

} // namespace
} // namespace quicksand
