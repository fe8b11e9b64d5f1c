#include "solver/verification/bodies/inertial_consolidation.hpp"
#include "solver/verification/solutions/terzaghi.hpp"
#include "tests/fixtures/closed_forms.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

SaturatedSoil layer_soil(double conductivity)
{
    SaturatedSoil soil = fixtures::elastic_soil(10e6, 0.0);
    soil.porosity = 0.3;
    soil.hydraulic_conductivity = conductivity;
    return soil;
}

double time_of(const SaturatedSoil& soil, double T)
{
    return T / soil.consolidation_coefficient();
}

TEST(InertialConsolidation, IsTerzaghisWhereInertiaIsSmall)
{
    const SaturatedSoil soil = layer_soil(1e-5);
    for (const double T : {0.1, 0.5, 1.0}) {
        const InertialConsolidation layer(soil, 1.0, time_of(soil, T));
        for (const double Z : {0.1, 0.5, 1.0}) {
            EXPECT_NEAR(layer.pressure_ratio(Z), terzaghi_pressure_ratio(Z, T), 2e-5);
            EXPECT_NEAR(layer.settlement_degree(Z), terzaghi_settlement_degree(Z, T), 2e-5);
        }
    }
}

// The delay k/g of the water, over a time of consolidation that is itself proportional to 1/k.
TEST(InertialConsolidation, DiffersFromTerzaghiAsTheSquareOfTheConductivity)
{
    const auto apart = [](double conductivity) {
        const SaturatedSoil soil = layer_soil(conductivity);
        return InertialConsolidation(soil, 1.0, time_of(soil, 0.2)).pressure_ratio(1.0) -
               terzaghi_pressure_ratio(1.0, 0.2);
    };
    EXPECT_NEAR(apart(2e-4) / apart(1e-4), 4.0, 0.01);
}

// The slope of the pressure drives the flux, and what flows out settles the layer: the integral of both
// momentum balances and of the storage of water, by differences in time.
TEST(InertialConsolidation, KeepsTheVolumeOfItsWater)
{
    const SaturatedSoil soil = layer_soil(1e-3);
    const double time = time_of(soil, 0.1), step = 1e-7;
    const auto rate = [&](double Z) { // of what sinks out of the part below Z, over p_0 H / M
        return (InertialConsolidation(soil, 1.0, time + step).settlement_degree(Z) -
                InertialConsolidation(soil, 1.0, time - step).settlement_degree(Z)) /
               (2.0 * step);
    };
    constexpr double d = 1e-3;
    const InertialConsolidation layer(soil, 1.0, time);
    const double slope = (layer.pressure_ratio(0.5 + d) - layer.pressure_ratio(0.5 - d)) / (2.0 * d);
    // Darcy's flux through the middle, which inertia changes by a part of k / (g t) only
    const double darcy = soil.hydraulic_conductivity / (soil.water_density * soil.conductivity_gravity) *
                         soil.constrained_modulus * slope;
    EXPECT_NEAR(rate(0.5) / darcy, 1.0, 3e-3);
}

TEST(InertialConsolidation, StartsUniformAndAtRest)
{
    const SaturatedSoil soil = layer_soil(1e-4);
    const InertialConsolidation layer(soil, 1.0, 2e-5); // waves have gone 3 cm
    EXPECT_NEAR(layer.pressure_ratio(0.5), 1.0, 1e-3);
    EXPECT_NEAR(layer.settlement_degree(0.5), 0.0, 1e-6);
}

} // namespace
} // namespace quicksand
