// The step that soil in failure bears, in closed form.
#include "solver/inertia/inertia_solve.hpp"
#include "solver/step_length/flowing_soil.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double shear_modulus_of_soil = 20e6; // [Pa]

/// A block in simple shear at a rate that moves with a velocity and has borne a vertical stress at first.
struct Block {
    Block(const SkeletonLaw& law, double shear_rate, double vertical, double velocity = 0.0)
    {
        problem.grid = {{0.0, 0.0}, 1.0, 2, 2};
        problem.materials = {stiff_sand()};
        problem.materials.front().law = law;
        state = fill(problem, 2, [](const Vector2&) { return true; });
        Particles& particles = state.particles;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            particles.affine_velocity_solid.xy[p] = shear_rate;
            particles.initial_vertical_effective_stress[p] = vertical;
            particles.velocity_solid.x[p] = velocity;
        }
    }
    double density() const
    {
        const Material& sand = problem.materials.front();
        return (1.0 - sand.porosity) * sand.grain_density;
    }

    Problem problem;
    State state;
};

double step_of_block(const SkeletonLaw& law, double shear_rate, double vertical)
{
    const Block block(law, shear_rate, vertical);
    return step_of_flow(block.problem, block.state.particles);
}

MohrCoulomb sand_with(double cohesion)
{
    MohrCoulomb sand;
    sand.shear_modulus = shear_modulus_of_soil;
    sand.poisson_ratio = 0.3;
    sand.cohesion = cohesion;
    return sand;
}

// D : D = gamma^2 / 2, so e s |D| / (2 G D : D) = e s / (2^(1/2) G gamma)
TEST(StepOfFlow, LetsElasticStressChangeByATwentieth)
{
    for (const double rate : {1e-3, 2.0})
        for (const double cohesion : {0.0, 5e3}) {
            const double expected =
                0.05 * (40e3 + cohesion) / (std::sqrt(2.0) * shear_modulus_of_soil * rate);
            EXPECT_NEAR(step_of_block(sand_with(cohesion), rate, 40e3) / expected, 1.0, 1e-12);
        }
}

TEST(StepOfFlow, IsInfiniteAtRestAndWhereSoilIsElastic)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(step_of_block(sand_with(0.0), 0.0, 40e3), infinite);
    EXPECT_EQ(step_of_block(LinearElastic{shear_modulus_of_soil, 0.3}, 1.0, 40e3), infinite);
}

// beta dt^2 G gamma^2 = r rho v^2 with r = 0.02
TEST(StepOfShakenFlow, LetsStiffnessAddAFiftiethToTheInertia)
{
    const Block block(sand_with(0.0), 2.0, 40e3, 3.0);
    const double expected =
        std::sqrt(0.02 * block.density() * 9.0 / (inertia_fraction * shear_modulus_of_soil * 4.0));
    EXPECT_NEAR(step_of_shaken_flow(block.problem, block.state.particles) / expected, 1.0, 1e-12);
}

TEST(StepOfShakenFlow, IsNoShorterThanThatOfFlow)
{
    const Block block(sand_with(0.0), 1e-3, 40e3); // soil that hardly moves
    EXPECT_EQ(step_of_shaken_flow(block.problem, block.state.particles),
              step_of_flow(block.problem, block.state.particles));
    const Block elastic(LinearElastic{shear_modulus_of_soil, 0.3}, 1.0, 40e3, 3.0);
    EXPECT_EQ(step_of_shaken_flow(elastic.problem, elastic.state.particles),
              std::numeric_limits<double>::infinity());
}

} // namespace
} // namespace quicksand
