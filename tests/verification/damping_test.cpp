// Soil with a damping ratio: shaken ground against its transfer function, and sand behind a wall that gives
// way, whose vibrations grow without damping.
#include "solver/measure/particle_quantities.hpp"
#include "solver/run/simulation.hpp"
#include "solver/run/staged_run.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace quicksand {
namespace {

using namespace fixtures;
using Complex = std::complex<double>;

/// 9 m of soil on 1 m of rock, without weight, shaken by a sine; G = 18 MPa, 1,800 kg/m3, damped by 5 %.
struct DampedGround {
    static constexpr double rock = 1.0, surface = 10.0; // heights [m]
    static constexpr double density = 1800.0;           // of both [kg/m3]
    static constexpr double amplitude = 0.2;            // of the base [m/s2]
    double damping_ratio = 0.05;                        // [-]
    double frequency = 2.5;                             // of the base [Hz]
    double rock_modulus = 1e9;                          // G [Pa]

    LinearElastic soil() const { return {18e6, 0.3, damping_ratio, 3.0}; }
};

Problem make_problem(const DampedGround& ground)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 1, 20};
    problem.strain = StrainForm::small;
    problem.gravity = 0.0;
    Material soil = stiff_sand();
    soil.law = ground.soil();
    soil.porosity = 0.0;
    soil.grain_density = DampedGround::density;
    Material rock = soil;
    rock.law = LinearElastic{ground.rock_modulus, 0.3};
    problem.materials = {soil, rock};
    problem.region_names = {"soil", "rock"};
    problem.boundaries = rectangle(0.0, 0.0, 0.5, DampedGround::surface, FixedWall{}, TiedSide{}, FreeFace{});
    problem.tied_sides = TiedSides{"left", "right", 0.0, 0.5};
    problem.base_motion = SineMotion{DampedGround::amplitude, ground.frequency, 1e9, 1.0};
    return problem;
}

State make_state(const Problem& problem)
{
    State state = fill(problem, 2, [](const Vector2&) { return true; });
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        if (state.particles.position.y[p] < DampedGround::rock)
            state.particles.material[p] = state.particles.region[p] = 1;
    begin_shaking(problem, state);
    return state;
}

/// What the elements of maxwell_elements.hpp make of G at a frequency: from its equations, in complex
/// numbers.
Complex modulus_of(const LinearElastic& law, double frequency)
{
    const MaxwellElements elements = make_maxwell_elements(law.damping_ratio, law.damping_frequency);
    Complex factor = elements.relaxed;
    for (std::size_t k = 0; k < maxwell_elements; ++k) {
        const Complex x(0.0, 2.0 * std::numbers::pi * frequency / elements.rate[k]);
        factor += elements.weight[k] * x / (1.0 + x);
    }
    return law.shear_modulus * factor;
}

/// Motion of the surface beside the base over that of the base, of steady shaking.
double exact_response(const DampedGround& ground)
{
    const Complex G = modulus_of(ground.soil(), ground.frequency);
    const double pulsation = 2.0 * std::numbers::pi * ground.frequency;
    const Complex soil =
        pulsation * std::sqrt(DampedGround::density / G) * (DampedGround::surface - DampedGround::rock);
    const double rock =
        pulsation * std::sqrt(DampedGround::density / ground.rock_modulus) * DampedGround::rock;
    const Complex impedances = std::sqrt(G / ground.rock_modulus);
    return std::abs(1.0 / (std::cos(soil) * std::cos(rock) - impedances * std::sin(soil) * std::sin(rock)) -
                    1.0);
}

/// The same of a run, over the last of thirty cycles.
double measured_response(const DampedGround& ground, TimeScheme scheme)
{
    Problem problem = make_problem(ground);
    problem.scheme = scheme;
    State state = make_state(problem);
    std::size_t top = 0;
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        if (state.particles.position.y[p] > state.particles.position.y[top]) top = p;
    const auto identifier = state.particles.identifier[top];
    constexpr int samples = 40;
    const double period = 1.0 / ground.frequency;
    Complex sum = 0.0;
    for (int k = 0; k < samples; ++k) {
        run(problem, (29.0 + static_cast<double>(k) / samples) * period, {}, state);
        const auto& identifiers = state.particles.identifier;
        const auto p = static_cast<std::size_t>(
            std::find(identifiers.begin(), identifiers.end(), identifier) - identifiers.begin());
        sum += displacement(state.particles, p).x() *
               std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(k) / samples);
    }
    const double pulsation = 2.0 * std::numbers::pi * ground.frequency;
    return std::abs(sum) / (0.5 * samples) * pulsation * pulsation / DampedGround::amplitude;
}

TEST(Damping, ShakenGroundFollowsItsTransferFunction)
{
    for (const double frequency : {1.0, 2.5, 7.5}) {
        DampedGround ground;
        ground.frequency = frequency;
        const double exact = exact_response(ground);
        EXPECT_NEAR(measured_response(ground, TimeScheme::explicit_steps), exact, 0.012 * exact)
            << frequency << " Hz";
        EXPECT_NEAR(measured_response(ground, TimeScheme::implicit), exact, 0.012 * exact)
            << frequency << " Hz, implicit";
    }
}

/// Dry sand of 35 degrees, 4 m x 2 m, behind a smooth wall that moves away by 1 cm/s.
Problem sand_behind_wall(double damping_ratio)
{
    Problem problem;
    problem.grid = {{-0.4, 0.0}, 0.2, 22, 11};
    Material sand = stiff_sand();
    MohrCoulomb law{10e6, 0.3, 100.0, 35.0 / 180.0 * std::numbers::pi, 0.0};
    law.damping_ratio = damping_ratio;
    sand.law = law;
    sand.porosity = 0.4;
    sand.volumetric_strain = VolumetricStrain::cell;
    problem.materials = {sand};
    problem.region_names = {"sand"};
    problem.boundaries = rectangle(0.0, 0.0, 4.0, 2.0, FixedWall{}, RollerWall{}, FreeFace{});
    problem.boundaries[3].soil =
        MovingWall{{MotionQuantity::velocity, WallGrip::smooth, {0.0, 0.0}, -0.01, {}}};
    return problem;
}

/// Largest kinetic energy between 4 and 5 s [J/m].
double energy_of_failing_sand(double damping_ratio)
{
    const Problem problem = sand_behind_wall(damping_ratio);
    State state =
        fill(problem, 2, [](const Vector2& x) { return x.x() > 0.0 && x.x() < 4.0 && x.y() < 2.0; });
    set_level_ground_stress(problem, 2.0, 0.5, state);
    begin_shaking(problem, state);
    double largest = 0.0;
    for (int k = 0; k <= 50; ++k) {
        run(problem, 4.0 + 0.02 * k, {}, state);
        const Particles& particles = state.particles;
        double energy = 0.0;
        for (std::size_t p = 0; p < particles.size(); ++p)
            energy += 0.5 * particles.mass_solid[p] * particles.velocity_solid[p].squaredNorm();
        largest = std::max(largest, energy);
    }
    return largest;
}

TEST(Damping, TakesGrowingVibrationsFromFailingSand)
{
    // the wedge that slides with the wall has 0.26 J; 12 J without damping
    EXPECT_LT(energy_of_failing_sand(0.02), 0.4);
    EXPECT_GT(energy_of_failing_sand(0.0), 4.0);
}

} // namespace
} // namespace quicksand
