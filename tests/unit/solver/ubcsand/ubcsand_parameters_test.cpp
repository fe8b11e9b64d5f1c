#include "solver/base/failure.hpp"
#include "solver/ubcsand/ubcsand_parameters.hpp"
#include "solver/ubcsand/ubcsand_power.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace quicksand {
namespace {

TEST(UbcSandParameters, BlowCountGivesTheGenericSet)
{
    struct Row {
        double n1_60, shear, bulk, plastic, peak_deg, failure_ratio;
    };
    // Beaty and Byrne 2011, evaluated by hand; rounded to the digits given
    const Row rows[] = {{5.0, 742.1, 519.5, 155.7, 33.5, 0.864},
                        {10.0, 935.0, 654.5, 380.5, 34.0, 0.779},
                        {15.0, 1070.3, 749.2, 822.4, 34.5, 0.733},
                        {20.0, 1178.1, 824.6, 1513.7, 36.0, 0.702}};
    for (const Row& row : rows) {
        const UbcSandParameters m = ubcsand_from_blow_count(row.n1_60);
        EXPECT_NEAR(m.elastic_shear_number, row.shear, 0.1);
        EXPECT_NEAR(m.elastic_bulk_number, row.bulk, 0.1);
        EXPECT_NEAR(m.plastic_shear_number, row.plastic, 0.1);
        EXPECT_NEAR(m.peak_friction_deg, row.peak_deg, 1e-12);
        EXPECT_NEAR(m.failure_ratio, row.failure_ratio, 6e-4);
        EXPECT_EQ(m.constant_volume_friction_deg, 33.0);
    }
    EXPECT_EQ(ubcsand_from_blow_count(1.0).failure_ratio, 0.99);
}

TEST(UbcSandParameters, NevadaSandAt55PercentHasABlowCountOf13Point915)
{
    EXPECT_NEAR(blow_count(0.55), 13.915, 1e-12);
    const UbcSandParameters m = nevada_sand_55();
    EXPECT_NEAR(m.elastic_shear_number, 1043.9, 0.1);
    EXPECT_NEAR(m.plastic_shear_number, 706.4, 0.1);
    EXPECT_NEAR(m.peak_friction_deg, 34.3915, 1e-10);
    EXPECT_NEAR(m.failure_ratio, 0.7411, 1e-4);
}

TEST(UbcSandParameters, TheDefaultsAreTheGenericSetFor13Point9)
{
    const UbcSandParameters m, generic = ubcsand_from_blow_count(13.9);
    EXPECT_NEAR(m.elastic_shear_number, generic.elastic_shear_number, 0.5);
    EXPECT_NEAR(m.elastic_bulk_number, generic.elastic_bulk_number, 0.5);
    EXPECT_NEAR(m.plastic_shear_number, generic.plastic_shear_number, 0.5);
    EXPECT_NEAR(m.failure_ratio, generic.failure_ratio, 1e-4);
    EXPECT_NEAR(m.peak_friction_deg, generic.peak_friction_deg, 1e-12);
}

std::string complaint(const UbcSandParameters& parameters)
{
    try {
        check(parameters);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(UbcSandParameters, WhatMakesNoSoilIsNamed)
{
    EXPECT_EQ(complaint({}), "");
    UbcSandParameters m;
    m.failure_ratio = 1.0;
    EXPECT_EQ(complaint(m), "UBCSAND: failure_ratio = 1, but it must be from 0 to below 1");
    m = {};
    m.stress_floor = 0.0;
    EXPECT_EQ(complaint(m), "UBCSAND: stress_floor = 0, but it must be positive");
    m = {};
    m.elastic_bulk_number = 20.0 * m.elastic_shear_number; // pore water put into the skeleton
    EXPECT_NE(complaint(m).find("elastic_bulk_number"), std::string::npos);
    m = {};
    m.plastic_shear_number = std::nan("");
    EXPECT_NE(complaint(m).find("plastic_shear_number"), std::string::npos);
    EXPECT_THROW(ubcsand_from_blow_count(0.0), InputError);
    EXPECT_THROW(ubcsand_from_relative_density(55.0), InputError);
}

TEST(UbcSandParameters, EachOutOfItsRangeIsToldWhatItMustBe)
{
    struct Row {
        double UbcSandParameters::*number;
        double value;
        const char* complaint; // after "UBCSAND: "
    };
    using M = UbcSandParameters;
    const Row rows[] = {
        {&M::elastic_bulk_exponent, 1.5, "an exponent of the stress = 1.5, but it must be from 0 to 1"},
        {&M::constant_volume_friction_deg, 60.0,
         "constant_volume_friction_deg = 60, but it must be above 0 and below 60"},
        {&M::peak_friction_deg, -1.0, "peak_friction_deg = -1, but it must be above 0 and below 60"},
        {&M::cohesion, -1.0, "cohesion = -1, but it must be zero or positive"},
        {&M::static_poisson_ratio, 0.5, "static_poisson_ratio = 0.5, but it must be from 0 to below 0.5"},
        {&M::smallest_specific_volume, -1.0,
         "smallest_specific_volume = -1, but it must be not negative, below the largest"}};
    for (const Row& row : rows) {
        UbcSandParameters m;
        m.*row.number = row.value;
        EXPECT_EQ(complaint(m), std::string("UBCSAND: ") + row.complaint);
    }
}

TEST(UbcSandPower, AgreesWithTheLibraryToRounding)
{
    for (double x = 1e-6; x < 1e5; x *= 1.00237) {
        EXPECT_NEAR(ubcsand::logarithm_2(x), std::log2(x), 2e-15 * (1.0 + std::abs(std::log2(x))));
        for (const double exponent : {0.0, 0.4, 0.5, 1.0}) {
            const double exact = std::pow(x, exponent);
            EXPECT_NEAR(ubcsand::power(x, exponent), exact, 1e-14 * exact);
        }
    }
    for (double x = -1000.0; x < 1000.0; x += 0.377) {
        EXPECT_NEAR(ubcsand::exponential_2(x), std::exp2(x), 4e-16 * std::exp2(x));
    }
    EXPECT_EQ(ubcsand::power(1.0, 0.4), 1.0);
}

} // namespace
} // namespace quicksand
