#include "solver/problem/slip_strength.hpp"
#include "solver/ubcsand/ubcsand_parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

constexpr double degrees = std::numbers::pi / 180.0;

MohrCoulomb soil(double friction, double dilation, double cohesion)
{
    return {10e6, 0.3, cohesion, friction * degrees, dilation * degrees};
}

// Davis (1968): soil that does not dilate bears sin(phi) along a plane, soil that dilates by phi tan(phi).
TEST(SlipStrength, OfSoilAlongAPlaneHangsOnItsDilation)
{
    const SlipStrength still = *slip_strength(soil(30.0, 0.0, 1000.0));
    EXPECT_NEAR(still.friction, std::sin(30.0 * degrees), 1e-12);
    EXPECT_NEAR(still.cohesion, 1000.0 * std::cos(30.0 * degrees), 1e-9);
    const SlipStrength dilating = *slip_strength(soil(30.0, 30.0, 1000.0));
    EXPECT_NEAR(dilating.friction, std::tan(30.0 * degrees), 1e-12);
    EXPECT_NEAR(dilating.cohesion, 1000.0, 1e-9);
}

// More dilation than friction is none of a soil: the strength fell with it, to no number in the end.
TEST(SlipStrength, OfSandIsAtMostThatOfItsFriction)
{
    UbcSand sand = make_ubcsand(nevada_sand_55());
    sand.dilation = 1e3;
    EXPECT_NEAR(slip_strength(sand)->friction, std::tan(std::asin(sand.eta_f)), 1e-12);
}

TEST(SlipStrength, OfALayerIsThatOfTheInterface)
{
    const SlipStrength face{std::tan(20.0 * degrees), 500.0};
    const SkeletonLaw layer = slipping(soil(35.0, 10.0, 2000.0), face);
    const SlipStrength of_layer = *slip_strength(layer);
    EXPECT_NEAR(of_layer.friction, face.friction, 1e-12);
    EXPECT_NEAR(of_layer.cohesion, face.cohesion, 1e-9);
    EXPECT_EQ(std::get<MohrCoulomb>(layer).dilation_angle, 0.0);
    EXPECT_EQ(std::get<MohrCoulomb>(layer).shear_modulus, 10e6);
}

TEST(SlipStrength, OfALayerIsNeverAboveThatOfTheSoil)
{
    const SkeletonLaw layer = slipping(soil(30.0, 0.0, 100.0), {std::tan(29.0 * degrees), 1e6});
    EXPECT_NEAR(std::get<MohrCoulomb>(layer).friction_angle, 30.0 * degrees, 1e-12);
    EXPECT_EQ(std::get<MohrCoulomb>(layer).cohesion, 100.0);
}

TEST(SlipStrength, OfSandsIsTheirFrictionWithoutDilation)
{
    const SlipStrength face{std::tan(18.0 * degrees), 0.0};
    const SkeletonLaw sands[] = {make_ubcsand(nevada_sand_55()), complete(Pm4Sand{.relative_density = 0.6})};
    for (const SkeletonLaw& sand : sands) {
        EXPECT_GT(coulomb_strength(sand)->friction, std::tan(32.0 * degrees)) << name_of(sand);
        EXPECT_NEAR(slip_strength(slipping(sand, face))->friction, face.friction, 1e-12) << name_of(sand);
    }
    const auto layer = std::get<UbcSand>(slipping(sands[0], face));
    EXPECT_EQ(layer.sin_cv, layer.eta_f); // no dilation at failure
    EXPECT_EQ(layer.G_atm, std::get<UbcSand>(sands[0]).G_atm);
}

TEST(SlipStrength, ElasticSoilHasNone)
{
    EXPECT_FALSE(coulomb_strength(LinearElastic{1e6, 0.3}));
    EXPECT_FALSE(slip_strength(LinearElastic{1e6, 0.3}));
}

} // namespace
} // namespace quicksand
