// The step that soil in failure bears, in closed form.
#include "solver/step/flowing_soil.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double shear_modulus_of_soil = 20e6; // [Pa]

/// That of a block in simple shear at a rate, which has borne a vertical stress at first.
double step_of_block(const SkeletonLaw& law, double shear_rate, double vertical)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0, 2, 2};
    problem.materials = {stiff_sand()};
    problem.materials.front().law = law;
    State state = fill(problem, 2, [](const Vector2&) { return true; });
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        particles.affine_velocity_solid.xy[p] = shear_rate;
        particles.initial_vertical_effective_stress[p] = vertical;
    }
    return step_of_flow(problem, particles);
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

} // namespace
} // namespace quicksand
