// Waves that leave through viscous boundaries, the compliant base, and soil that stays on it.
#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "solver/run/simulation.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace quicksand {
namespace {

using namespace fixtures;

/// A column of 3 cells and `rows` rows of 0.5 m on a viscous base, sides tied, top free.
Problem column_on_viscous_base(int rows)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 3, rows + 2};
    problem.materials = {stiff_sand()};
    problem.gravity = 0.0;
    problem.boundaries = rectangle(0.0, 0.0, 1.5, 0.5 * rows, ViscousFace{}, TiedSide{}, FreeFace{});
    problem.boundaries[0].water = Impervious{};
    problem.tied_sides = TiedSides{"left", "right", 0.0, 1.5};
    return problem;
}

State column_state(Problem& problem, int rows)
{
    State state = fill(problem, 2, [=](const Vector2& x) { return x.x() < 1.5 && x.y() < 0.5 * rows; });
    attach_boundaries(problem, state.particles);
    return state;
}

struct Moduli {
    double density, compression, shear;
};

Moduli moduli(const Problem& problem)
{
    const Material& sand = problem.materials[0];
    const LinearElastic& law = std::get<LinearElastic>(sand.law);
    const double n = sand.porosity, water = problem.water ? n * problem.water->density : 0.0;
    const double stiffness = problem.water ? problem.water->bulk_modulus / n : 0.0;
    return {(1.0 - n) * sand.grain_density + water, constrained_modulus(law) + stiffness, shear_modulus(law)};
}

/// Energy of vertical and horizontal motion and of their strains, without relative motion of the water.
double energy(const Problem& problem, const Particles& particles)
{
    const Moduli soil = moduli(problem);
    double sum = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double total = particles.stress.yy[p] - (problem.water ? particles.pore_pressure[p] : 0.0);
        sum += particles.volume[p] * (0.5 * soil.density * particles.velocity_solid[p].squaredNorm() +
                                      0.5 * total * total / soil.compression +
                                      0.5 * particles.stress.xy[p] * particles.stress.xy[p] / soil.shear);
    }
    return sum;
}

/// A pulse on its way down, v = f(y + c t), with the stress rho c v; two wavelengths of a wave of 20 cells
/// under a smooth envelope. axis 0: shear wave.
void send_down(const Problem& problem, int axis, double speed, State& state)
{
    const Moduli soil = moduli(problem);
    Particles& particles = state.particles;
    // as in a run under way: velocities stand half a step before the stresses
    state.last_step = stable_time_step(problem, particles).dt;
    const double early = 0.5 * speed * state.last_step;
    const double wavelength = 20 * problem.grid.cell_size, middle = 25.0, reach = 15.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto pulse = [&](double s) {
            if (std::abs(s) > reach) return 0.0;
            const double envelope = std::pow(std::cos(0.5 * std::numbers::pi * s / reach), 2);
            return 1e-3 * envelope * std::sin(2.0 * std::numbers::pi * s / wavelength);
        };
        const double place = particles.position.y[p] - middle;
        const double v = pulse(place - early);
        Vector2 velocity = Vector2::Zero();
        velocity[axis] = v;
        particles.velocity_solid.set(p, velocity);
        if (problem.water) particles.velocity_fluid.set(p, velocity);
        // the mean over the cell: what of the stress varies within a cell does not move with the wave
        const double h = problem.grid.cell_size, cell = h * std::floor(particles.position.y[p] / h) - middle;
        double mean = 0.0;
        for (int k = 0; k < 8; ++k) mean += 0.125 * pulse(cell + h * (k + 0.5) / 8.0);
        const double stress = soil.density * speed * mean; // total
        if (axis == 0) {
            particles.stress.xy[p] = stress;
            continue;
        }
        const LinearElastic& law = std::get<LinearElastic>(problem.materials[0].law);
        const double skeleton = stress * constrained_modulus(law) / soil.compression;
        particles.stress.yy[p] = skeleton;
        particles.stress.xx[p] = particles.stress.zz[p] = skeleton * 0.3 / 0.7;
        if (problem.water) particles.pore_pressure[p] = skeleton - stress;
    }
}

/// Energy left in the column after the pulse has been at the base, in parts of its own.
double reflected_energy(Problem problem, int axis)
{
    State state = column_state(problem, 100);
    const Moduli soil = moduli(problem);
    const double speed = std::sqrt((axis == 0 ? soil.shear : soil.compression) / soil.density);
    send_down(problem, axis, speed, state);
    const double before = energy(problem, state.particles);
    run(problem, 45.0 / speed, {}, state); // the last of the pulse comes to the base after 40 m
    return energy(problem, state.particles) / before;
}

TEST(ViscousBase, LetsWavesOfTwentyCellsOutOfDrySoil)
{
    for (const int axis : {0, 1}) {
        const double left = reflected_energy(column_on_viscous_base(100), axis);
        EXPECT_LT(left, 1.2e-4) << "axis " << axis; // measured 0.9e-4 and 0.7e-4
    }
}

TEST(ViscousBase, LetsWavesOfTwentyCellsOutOfSaturatedSoil)
{
    for (const int axis : {0, 1}) {
        Problem problem = column_on_viscous_base(100);
        problem.water = water_to(50.0);
        problem.materials[0].hydraulic_conductivity = 1e-6; // no motion of the water relative to the grains
        const double left = reflected_energy(problem, axis);
        EXPECT_LT(left, 1.2e-4) << "axis " << axis; // measured 0.97e-4 and 1.04e-4
    }
}

TEST(ViscousBase, HoldsTheSoilThatRestsOnIt)
{
    for (const bool saturated : {false, true}) {
        Problem problem = column_on_viscous_base(20);
        problem.gravity = 9.81;
        if (saturated) problem.water = water_to(10.0);
        State state = column_state(problem, 20);
        set_level_ground_stress(problem, 10.0, 0.5, state);
        const double start = state.particles.position.y[0];
        run(problem, 2.0, {}, state);
        EXPECT_NEAR(state.particles.position.y[0], start, 1e-9);
        for (std::size_t p = 0; p < state.particles.size(); ++p)
            ASSERT_LT(state.particles.velocity_solid[p].norm(), 1e-8 * std::sqrt(9.81 * 10.0));
        double sum = 0.0;
        for (const double force : state.reactions.y) sum += force;
        const Moduli soil = moduli(problem);
        const double weight = (soil.density - (saturated ? 1000.0 : 0.0)) * 9.81 * 15.0;
        EXPECT_NEAR(sum, weight, 1e-9 * weight);
    }
}

TEST(ViscousBase, HoldsTheSoilBetweenViscousSides)
{
    Problem problem = column_on_viscous_base(20);
    problem.gravity = 9.81;
    problem.boundaries = rectangle(0.0, 0.0, 1.5, 10.0, ViscousFace{}, ViscousFace{}, FreeFace{});
    problem.tied_sides.reset();
    State state = column_state(problem, 20);
    set_level_ground_stress(problem, 10.0, 0.5, state);
    run(problem, 1.0, {}, state);
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        ASSERT_LT(state.particles.velocity_solid[p].norm(), 1e-8 * std::sqrt(9.81 * 10.0));
}

/// Amplitude of the surface's motion over the outcrop's, after the beginning has died away.
double amplification(Problem problem, int rows, double frequency)
{
    SineMotion sine{1.0, frequency, std::numeric_limits<double>::infinity(), 4.0};
    problem.base_motion = sine;
    State state = column_state(problem, rows);
    const double period = 1.0 / frequency, omega = 2.0 * std::numbers::pi * frequency;
    constexpr int samples = 60;
    const double begin = 16.0 * period;
    std::complex<double> relative = 0.0;
    std::size_t top = 0;
    for (int k = 0; k < samples; ++k) {
        const double time = begin + period * k / samples;
        run(problem, time, {}, state);
        top = 0;
        for (std::size_t p = 0; p < state.particles.size(); ++p) {
            if (state.particles.position.y[p] > state.particles.position.y[top]) top = p;
        }
        // the velocity at the surface, from that of the highest particle and its slope
        const double v = state.particles.velocity_solid.x[top] +
                         state.particles.half_edge_2.y[top] * state.particles.affine_velocity_solid.xy[top];
        relative += v * std::polar(2.0 / samples, -omega * (time - 0.5 * state.last_step));
    }
    // the outcrop's acceleration sin(w t) has the amplitude -i, its velocity -i / (i w)
    const std::complex<double> outcrop = -1.0 / omega;
    return std::abs((relative + outcrop) / outcrop);
}

TEST(CompliantBase, AmplifiesAsALayerOnAHalfSpace)
{
    // 1 / |cos kH + i alpha sin kH|, alpha = rho1 V1 / (rho2 V2), without damping in the layer
    constexpr int rows = 20;
    Problem problem = column_on_viscous_base(rows);
    const Moduli soil = moduli(problem);
    const double speed = std::sqrt(soil.shear / soil.density), height = 0.5 * rows;
    const HalfSpace rock{2400.0, 200.0, 400.0};
    problem.boundaries[0].soil = ViscousFace{rock};
    const double alpha = soil.density * speed / (rock.density * rock.shear_wave_speed);
    for (const double kH : {0.8, 0.5 * std::numbers::pi, 2.2, std::numbers::pi}) {
        const double expected = 1.0 / std::abs(std::complex<double>(std::cos(kH), alpha * std::sin(kH)));
        const double measured = amplification(problem, rows, kH * speed / height / (2.0 * std::numbers::pi));
        // measured: 0.05 to 0.97 per mille
        EXPECT_NEAR(measured, expected, 1.5e-3 * expected) << "kH " << kH;
    }
}

} // namespace
} // namespace quicksand
