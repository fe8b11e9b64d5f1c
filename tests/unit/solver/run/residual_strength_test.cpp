// Liquefied sand in the search for the factor of safety.
#include "solver/run/residual_strength.hpp"
#include "solver/run/strength_reduction.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <variant>
#include <vector>

namespace quicksand {
namespace {

using namespace fixtures;

/// Level ground whose pores carry all of the weight.
struct LiquefiedGround {
    Problem problem = tied_ground();
    State state;

    LiquefiedGround()
    {
        for (Material& material : problem.materials) material.law = MohrCoulomb{10e6, 0.3, 0.0, 0.6, 0.0};
        state = level_state(problem);
        Particles& particles = state.particles;
        for (std::size_t p = 0; p < particles.size(); ++p)
            particles.pore_pressure[p] = particles.initial_vertical_effective_stress[p];
        for (Scalars* stress : {&particles.stress.xx, &particles.stress.yy, &particles.stress.zz})
            std::fill(stress->begin(), stress->end(), 0.0);
    }
};

TEST(ResidualStrength, IsThatOfTheStressBeforeTheShaking)
{
    LiquefiedGround ground;
    State& state = ground.state;
    const std::vector<std::int32_t> before = state.particles.material;
    EXPECT_EQ(give_residual_strength({0.1, 0.8}, ground.problem, state), state.particles.size());
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Material& material =
            ground.problem.materials.at(static_cast<std::size_t>(state.particles.material[p]));
        const auto& law = std::get<MohrCoulomb>(material.law);
        const double strength = 0.1 * state.particles.initial_vertical_effective_stress[p];
        EXPECT_NEAR(law.cohesion, strength, 0.026 * strength);
        EXPECT_EQ(law.friction_angle, 0.0);
    }
}

TEST(ResidualStrength, IsForLiquefiedSandAlone)
{
    LiquefiedGround ground;
    State& state = ground.state;
    for (double& pressure : state.particles.pore_pressure) pressure *= 0.79;
    const std::vector<std::int32_t> before = state.particles.material;
    EXPECT_EQ(give_residual_strength({0.1, 0.8}, ground.problem, state), 0U);
    EXPECT_EQ(state.particles.material, before);
    EXPECT_EQ(give_residual_strength({0.1, 0.7}, ground.problem, state), state.particles.size());
}

TEST(ResidualStrength, QuickGroundStandsAtNoStrength)
{
    LiquefiedGround ground;
    for (double& pressure : ground.state.particles.pore_pressure) pressure *= 1.2;
    const SafetyFactor safety = safety_factor(ground.problem, {}, ground.state);
    EXPECT_EQ(safety.factor, 0.0);
    EXPECT_EQ(safety.stands, 0.0);
    EXPECT_LT(safety.fails, 0.05);
}

/// Under k_h the shear stress is k_h times the weight of grains and water above, the strength S_r / sigma'_v0
/// times the buoyant weight: F = (S_r / sigma'_v0) (gamma' / gamma) / k_h at every depth.
TEST(ResidualStrength, GivesTheFactorOfSafetyOfLevelGroundUnderAHorizontalForce)
{
    const double ratio = 0.2, k_h = 0.08;
    LiquefiedGround ground;
    give_residual_strength({ratio, 0.8}, ground.problem, ground.state);
    StrengthReductionControls controls;
    controls.seismic_coefficient = k_h;
    const Material& sand = ground.problem.materials[0];
    const double water = ground.problem.water->density;
    const double grains = (1.0 - sand.porosity) * sand.grain_density, whole = grains + sand.porosity * water;
    const double factor = safety_factor(ground.problem, controls, ground.state).factor;
    EXPECT_NEAR(factor, ratio * (whole - water) / whole / k_h, 0.03 * factor); // half a step of strength
}

} // namespace
} // namespace quicksand
