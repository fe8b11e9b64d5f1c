#include "solver/problem/solid_mixture.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

/// Of the mixture, water and grains together [kg/m3].
double density_of(const Material& material, const Water& water)
{
    return (1.0 - material.porosity) * material.grain_density + material.porosity * water.density;
}

TEST(SolidMixture, HasTheDensityOfTheSolidHeavyOrLight)
{
    const Water water = fixtures::water_to(3.0);
    for (const double density : {100.0, 700.0, 2400.0, 7850.0}) {
        Material solid;
        make_solid(density, water, solid);
        EXPECT_NEAR(density_of(solid, water), density, 1e-12 * density);
        EXPECT_GT(solid.grain_density, 0.0);
        EXPECT_FALSE(is_wet(solid));
    }
}

TEST(SolidMixture, HasItsDensityInADrySceneToo)
{
    Material solid;
    make_solid(2400.0, std::nullopt, solid);
    EXPECT_NEAR((1.0 - solid.porosity) * solid.grain_density, 2400.0, 1e-9);
}

TEST(SolidMixture, IsSoftenedToTheWavesOfTheSoil)
{
    Problem problem;
    problem.materials = {fixtures::stiff_sand(), fixtures::stiff_sand(), fixtures::stiff_sand()};
    problem.materials[0].law = LinearElastic{10e6, 0.3};
    make_solid(2400.0, std::nullopt, problem.materials[1]);
    problem.materials[1].law = MohrCoulomb{12e9, 0.2, 1e6, 0.7};
    make_solid(2400.0, std::nullopt, problem.materials[2]);
    problem.materials[2].law = LinearElastic{1e6, 0.2}; // softer than the soil: stays
    const auto waves = [&] {
        std::vector<WaveSpeeds> speeds;
        for (const Material& material : problem.materials)
            speeds.push_back(wave_speeds(material, std::nullopt, material.porosity));
        return speeds;
    };
    soften_solids(waves(), problem);
    EXPECT_NEAR(waves()[1].skeleton / waves()[0].skeleton, 1.0, 1e-12);
    EXPECT_EQ(std::get<MohrCoulomb>(problem.materials[1].law).cohesion, 1e6);
    EXPECT_EQ(shear_modulus_at(problem.materials[2].law, 0, {}), 1e6);
}

} // namespace
} // namespace quicksand
