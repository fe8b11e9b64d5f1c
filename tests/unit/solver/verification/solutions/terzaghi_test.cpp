#include "solver/verification/solutions/terzaghi.hpp"
#include "tests/fixtures/closed_forms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

/// The sines to an order at which any time factor of the tests has converged.
double long_series(double Z, double T)
{
    double sum = 0.0;
    for (int m = 1; m < 4000; m += 2) {
        const double lambda = 0.5 * m * std::numbers::pi;
        sum += 2.0 / lambda * std::sin(lambda * Z) * std::exp(-lambda * lambda * T);
    }
    return sum;
}

TEST(Terzaghi, DegreeOfConsolidationIsTheTabledOne)
{
    const double table[][2] = {
        {0.05, 0.25231}, {0.1, 0.35682}, {0.2, 0.50409}, {0.5, 0.76395}, {1.0, 0.93126}};
    for (const auto& [T, U] : table) EXPECT_NEAR(terzaghi_settlement_degree(0.0, T), U, 5e-6) << T;
}

TEST(Terzaghi, BothSeriesAgreeWithManySines)
{
    for (const double T : {1e-4, 0.01, 0.1, 0.1999, 0.2, 0.5, 2.0})
        for (const double Z : {0.0, 0.01, 0.3, 0.75, 1.0})
            EXPECT_NEAR(terzaghi_pressure_ratio(Z, T), long_series(Z, T), 1e-13) << Z << " " << T;
}

TEST(Terzaghi, PressureDiffusesAndSettlementIsItsIntegral)
{
    constexpr double d = 1e-4;
    for (const double T : {0.02, 0.15, 0.6}) {
        for (const double Z : {0.1, 0.5, 0.9}) {
            const double rate =
                (terzaghi_pressure_ratio(Z, T + d) - terzaghi_pressure_ratio(Z, T - d)) / (2.0 * d);
            const double curvature =
                (terzaghi_pressure_ratio(Z + d, T) - 2.0 * terzaghi_pressure_ratio(Z, T) +
                 terzaghi_pressure_ratio(Z - d, T)) /
                (d * d);
            EXPECT_NEAR(rate, curvature, 3e-4);
            const double strain =
                (terzaghi_settlement_degree(Z - d, T) - terzaghi_settlement_degree(Z + d, T)) / (2.0 * d);
            EXPECT_NEAR(strain, 1.0 - terzaghi_pressure_ratio(Z, T), 1e-7);
        }
    }
}

TEST(Terzaghi, StartsUniformAndEndsDrained)
{
    EXPECT_EQ(terzaghi_pressure_ratio(0.5, 0.0), 1.0);
    EXPECT_EQ(terzaghi_pressure_ratio(0.0, 0.0), 0.0);
    EXPECT_EQ(terzaghi_settlement_degree(0.0, 0.0), 0.0);
    EXPECT_NEAR(terzaghi_pressure_ratio(1.0, 20.0), 0.0, 1e-15);
    EXPECT_NEAR(terzaghi_settlement_degree(0.25, 20.0), 0.75, 1e-15);
    EXPECT_EQ(terzaghi_settlement_degree(1.0, 0.1), 0.0);
    // early: 2 sqrt(T / pi)
    EXPECT_NEAR(terzaghi_settlement_degree(0.0, 1e-3), 2.0 * std::sqrt(1e-3 / std::numbers::pi), 1e-15);
}

TEST(SaturatedSoil, PublishedConsolidationColumns)
{
    SaturatedSoil soil = fixtures::elastic_soil(10e6, 0.0);
    soil.porosity = 0.3;
    soil.hydraulic_conductivity = 1e-3;
    EXPECT_NEAR(soil.consolidation_coefficient(), 1.0180, 5e-5);
    EXPECT_NEAR(fixtures::undrained_pressure_ratio(soil), 0.99864, 5e-6);
    soil.porosity = 0.4;
    soil.water_bulk_modulus = 2.15e9; // the plane column of the peer comparison
    EXPECT_NEAR(soil.consolidation_coefficient(), 1.0175, 5e-5);
    EXPECT_NEAR(time_factor(soil, 1.0, 0.98), 0.9971, 5e-5);
    EXPECT_NEAR(terzaghi_settlement_degree(0.0, time_factor(soil, 1.0, 0.098)), 0.356, 5e-4);
}

TEST(SaturatedSoil, PhasesStrainedAlikeAreUndrained)
{
    const SaturatedSoil soil;
    EXPECT_NEAR(soil.longitudinal_stiffness().sum(), soil.undrained_modulus(), 1e-6);
}

} // namespace
} // namespace quicksand
