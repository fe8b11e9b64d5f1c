#include "solver/run/simulation.hpp"
#include "solver/ubcsand/settling_sand.hpp"
#include "solver/ubcsand/ubcsand_particles.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

Particles point_at(double vertical, double k0)
{
    Particles particles;
    resize(particles, 1, std::nullopt);
    particles.volume[0] = 1.0;
    particles.stress.yy[0] = -vertical;
    particles.stress.xx[0] = particles.stress.zz[0] = -k0 * vertical;
    return particles;
}

double ratio(const Particles& particles)
{
    const SymmetricTensors& stress = particles.stress;
    return std::hypot(0.5 * (stress.xx[0] - stress.yy[0]), stress.xy[0]) /
           (-0.5 * (stress.xx[0] + stress.yy[0]));
}

const UbcSand nevada = make_ubcsand(nevada_sand_55());

TEST(SettlingSand, OneDimensionalStrainGivesTheHorizontalStressOfItsPoissonRatio)
{
    // nu = 1/3: d sigma_h = nu/(1 - nu) d sigma_v = 0.5 d sigma_v, at any stress
    Particles particles = point_at(50e3, 0.5);
    particles.velocity_gradient_solid.yy[0] = -1.0;
    for (int k = 0; k < 1000; ++k) update_stress(SettlingSand{nevada}, 1e-6, 0, 1, particles);
    EXPECT_LT(particles.stress.yy[0], -200e3);
    EXPECT_NEAR(particles.stress.xx[0] / particles.stress.yy[0], 0.5, 1e-12);
    EXPECT_NEAR(particles.stress.zz[0] / particles.stress.yy[0], 0.5, 1e-12);
}

TEST(SettlingSand, ShearFlowsAtTheFailureLimitAtConstantMeanStress)
{
    Particles particles = point_at(100e3, 0.5);
    particles.velocity_gradient_solid.xy[0] = 1.0;
    for (int k = 0; k < 1000; ++k) update_stress(SettlingSand{nevada}, 1e-5, 0, 1, particles);
    EXPECT_NEAR(ratio(particles), nevada.eta_f, 1e-12);
    EXPECT_NEAR(-0.5 * (particles.stress.xx[0] + particles.stress.yy[0]), 75e3, 1e-6);
}

TEST(SettlingSand, PullingApartEndsAtTheFloor)
{
    Particles particles = point_at(100e3, 0.5);
    particles.velocity_gradient_solid.yy[0] = 1.0;
    for (int k = 0; k < 1000; ++k) update_stress(SettlingSand{nevada}, 1e-5, 0, 1, particles);
    EXPECT_NEAR(-0.5 * (particles.stress.xx[0] + particles.stress.yy[0]), nevada.s_min, 1e-9);
    EXPECT_LE(ratio(particles), nevada.eta_f * (1.0 + 1e-12));
}

TEST(SettlingSand, ReductionDividesTheTangentOfItsFriction)
{
    const double half = std::tan(std::asin(reduced(SettlingSand{nevada}, 2.0).sand.eta_f));
    EXPECT_NEAR(half, 0.5 * std::tan(std::asin(nevada.eta_f)), 1e-15);
}

TEST(SettlingSand, ItsModuliFollowTheStress)
{
    const Particles particles = point_at(100e3, 1.0);
    // M = 2 G (1 - nu)/(1 - 2 nu) = 4 G
    EXPECT_NEAR(particle_moduli(SettlingSand{nevada}, 0, 1, particles).stiffest, 4.0 * nevada.G_atm, 1.0);
    EXPECT_NEAR(particle_moduli(SettlingSand{nevada}, 0, 1, point_at(25e3, 1.0)).mean, 2.0 * nevada.G_atm,
                1.0);
}

TEST(StartOfShaking, BringsAStressThatSandCannotBearToItsLimit)
{
    Particles particles = point_at(100e3, 0.1); // t/s = 0.82
    add_memory(particles, memory_of(nevada).size());
    EXPECT_EQ(start_memory(nevada, 0, 1, particles), 1U);
    EXPECT_NEAR(ratio(particles), nevada.eta_f, 1e-12);
    EXPECT_NEAR(-0.5 * (particles.stress.xx[0] + particles.stress.yy[0]), 55e3, 1e-9);
    EXPECT_NEAR(particles.memory[column_of(memory_of(nevada), "eta_max")][0], nevada.eta_f, 1e-12);
    EXPECT_EQ(start_memory(nevada, 0, 1, particles), 0U);

    particles = point_at(10.0, 0.5);
    add_memory(particles, memory_of(nevada).size());
    EXPECT_EQ(start_memory(nevada, 0, 1, particles), 1U);
    EXPECT_NEAR(-0.5 * (particles.stress.xx[0] + particles.stress.yy[0]), nevada.s_min, 1e-9);
}

TEST(StartOfShaking, OnlyUbcsandHasAMemory)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 2, 2};
    problem.materials = {fixtures::stiff_sand()};
    State state = fixtures::fill(problem, 2, [](const Vector2&) { return true; });
    EXPECT_EQ(begin_shaking(problem, state), 0U);
    EXPECT_TRUE(state.particles.memory.empty());
    const std::size_t without = memory_bytes(state.particles);
    problem.materials[0].law = nevada;
    EXPECT_EQ(begin_shaking(problem, state), state.particles.size()); // free of stress: raised to the floor
    EXPECT_EQ(state.particles.memory.size(), memory_of(nevada).size());
    EXPECT_EQ(memory_bytes(state.particles) - without, 15 * 8 * state.particles.size());
    EXPECT_TRUE(std::holds_alternative<SettlingSand>(settling_problem(problem).materials[0].law));
}

/// A slope of 1 : 1.7 under K0 stress, which settles.
TEST(Relaxation, ASlopeOfSandSettlesWithinItsStrength)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 14, 9};
    problem.materials = {fixtures::stiff_sand()};
    problem.materials[0].law = nevada;
    problem.boundaries = fixtures::rectangle(0.0, 0.0, 7.0, 4.0, FixedWall{}, RollerWall{}, FreeFace{});
    const auto surface = [](double x) { return std::min(4.0, std::max(1.0, 4.0 - (x - 1.5) / 1.7)); };
    State state = fixtures::fill(problem, 2, [&](const Vector2& x) { return x.y() < surface(x.x()); });
    const double unit_weight = 0.57 * 2650.0 * standard_gravity;
    SymmetricTensors& stress = state.particles.stress;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Vector2 x = state.particles.position[p];
        stress.yy[p] = -unit_weight * (surface(x.x()) - x.y());
        stress.xx[p] = stress.zz[p] = 0.5 * stress.yy[p];
    }
    RelaxationControls controls;
    controls.tolerance = 1e-4;
    const RelaxationReport report = relax(problem, controls, state);
    EXPECT_TRUE(report.settled);
    // with the strength of the shaking alone the corners of its stairs creep
    EXPECT_LE(report.unbalanced.of_weight, 2e-3); // measured 8e-4
    EXPECT_LT(report.max_displacement, 0.02);
    for (const double eta : state.particles.memory[column_of(memory_of(nevada), "eta_max")])
        EXPECT_LE(eta, nevada.eta_f * (1.0 + 1e-12));
}

} // namespace
} // namespace quicksand
