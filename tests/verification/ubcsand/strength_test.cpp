// The cyclic strength of UBCSAND: against reference cycles to liquefaction, and against the triggering curve
// to which the factor of secondary loading was calibrated. Constant-volume simple shear at K_0 = 0.5.
#include "solver/element/cyclic_laboratory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace quicksand {
namespace {

double cycles_to_liquefaction(double n1_60, double csr)
{
    const UbcSand law = make_ubcsand(ubcsand_from_blow_count(n1_60));
    return shear_cyclically(law, {}, StressCycles{csr, 105.0, 0.5, 0.0}).cycles_to_ru_95.value_or(1e9);
}

TEST(UbcSandStrength, LiquefiesAfterTheReferenceNumberOfCycles)
{
    constexpr double csr[] = {0.080, 0.100, 0.125, 0.150, 0.175, 0.200, 0.250, 0.300};
    constexpr double beyond = 1e9; // more than 100 cycles
    struct Row {
        double n1_60, cycles[8];
    };
    const Row rows[] = {{5.0, {15.0, 7.5, 4.5, 2.5, 2.0, 1.5, 0.5, 0.5}},
                        {10.0, {48.5, 20.5, 10.0, 6.0, 4.0, 2.5, 1.5, 1.0}},
                        {15.0, {beyond, beyond, 35.5, 17.5, 10.5, 7.0, 3.5, 2.0}},
                        {20.0, {beyond, beyond, beyond, 77.0, 36.5, 20.5, 9.0, 5.0}}};
    for (const Row& row : rows) {
        for (std::size_t k = 0; k < 8; ++k) {
            const double reference = row.cycles[k];
            const double cycles = cycles_to_liquefaction(row.n1_60, csr[k]);
            const std::string where =
                "(N1)60 = " + std::to_string(row.n1_60) + ", CSR = " + std::to_string(csr[k]);
            if (reference == beyond) {
                EXPECT_GT(cycles, 100.0) << where;
            } else {
                EXPECT_NEAR(cycles, reference, std::max(0.5, 0.03 * reference)) << where;
            }
        }
    }
}

/// CRR of Idriss and Boulanger for 15 cycles at one atmosphere, C_0 = 2.8.
double triggering_curve(double N)
{
    return std::exp(N / 14.1 + std::pow(N / 126.0, 2) - std::pow(N / 23.6, 3) + std::pow(N / 25.4, 4) - 2.8);
}

TEST(UbcSandStrength, MeetsTheTriggeringCurveWithTheSlopeOfSand)
{
    for (const double n1_60 : {5.0, 10.0, 15.0, 20.0}) {
        const UbcSand law = make_ubcsand(ubcsand_from_blow_count(n1_60));
        const double csr_15 = csr_to_ru_95(law, {}, 15.0).value();
        EXPECT_NEAR(csr_15 / triggering_curve(n1_60), 1.0, 0.08) << "(N1)60 = " << n1_60;
        // CSR ~ N^-b from 10 to 30 cycles
        const double b = std::log(csr_to_ru_95(law, {}, 10.0).value() / csr_to_ru_95(law, {}, 30.0).value()) /
                         std::log(3.0);
        EXPECT_GT(b, 0.25) << "(N1)60 = " << n1_60;
        EXPECT_LT(b, 0.36) << "(N1)60 = " << n1_60;
    }
}

TEST(UbcSandStrength, FallsWithDepthAsTheExponentsOfTheStressSay)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    struct Row {
        double stress, csr_10, csr_15, csr_30;
    };
    const Row rows[] = {{50e3, 0.173, 0.152, 0.126},
                        {100e3, 0.166, 0.146, 0.121},
                        {241.8e3, 0.158, 0.139, 0.115},
                        {360.8e3, 0.154, 0.136, 0.112}};
    for (const Row& row : rows) {
        EXPECT_NEAR(csr_to_ru_95(law, {row.stress}, 10.0).value(), row.csr_10, 0.015 * row.csr_10);
        EXPECT_NEAR(csr_to_ru_95(law, {row.stress}, 15.0).value(), row.csr_15, 0.015 * row.csr_15);
        EXPECT_NEAR(csr_to_ru_95(law, {row.stress}, 30.0).value(), row.csr_30, 0.015 * row.csr_30);
    }
}

TEST(UbcSandStrength, PorePressureRisesPeakByPeakAsTheReference)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    const CyclicTest test = shear_cyclically(law, {}, StressCycles{0.1464, 15.0, 0.1});
    const double reference[] = {0.049, 0.130, 0.217, 0.306, 0.381, 0.437, 0.482,
                                0.522, 0.559, 0.598, 0.643, 0.684, 0.717, 0.740};
    std::size_t peak = 0;
    for (std::size_t k = 1; k < test.path.size() && peak < std::size(reference); ++k) {
        const double middle = 0.25 + static_cast<double>(peak);
        if (test.path[k - 1].cycle < middle && test.path[k].cycle >= middle - 1e-9) {
            EXPECT_NEAR(test.path[k].ru, reference[peak], 0.01) << "peak " << peak;
            ++peak;
        }
    }
    EXPECT_EQ(peak, std::size(reference));
    EXPECT_NEAR(test.cycles_to_ru_95.value_or(0.0), 15.0, 0.5);
}

/// Largest and smallest shear strain of a cycle, and its largest ru.
struct CycleRange {
    double most = -1e9, least = 1e9, ru = 0.0;
};

CycleRange range_of_cycle(const ElementPath& path, double from)
{
    CycleRange range;
    for (const ElementPoint& point : path) {
        if (point.cycle < from || point.cycle >= from + 1.0) continue;
        range.most = std::max(range.most, point.gamma);
        range.least = std::min(range.least, point.gamma);
        range.ru = std::max(range.ru, point.ru);
    }
    return range;
}

TEST(UbcSandStrength, StaticBiasWithoutReversalRatchetsButDoesNotLiquefy)
{
    const UbcSand law = make_ubcsand(ubcsand_from_blow_count(13.9));
    const CyclicTest test = shear_cyclically(law, {100e3, 0.5, 20e3}, StressCycles{0.1, 40.0, 0.5});
    EXPECT_FALSE(test.cycles_to_ru_95);
    const CycleRange tenth = range_of_cycle(test.path, 10.0), last = range_of_cycle(test.path, 39.0);
    EXPECT_NEAR(last.ru, 0.48, 0.02);
    EXPECT_NEAR(tenth.ru, 0.48, 0.03);
    const double ratchet = (range_of_cycle(test.path, 20.0).most - tenth.most) / 10.0;
    EXPECT_GT(ratchet, 0.001);
    EXPECT_LT(ratchet, 0.003);
}

TEST(UbcSandStrength, StaticBiasWithSlightReversalLiquefiesAndDriftsDownslope)
{
    const UbcSand law = make_ubcsand(ubcsand_from_blow_count(13.9));
    const CyclicTest test = shear_cyclically(law, {100e3, 0.5, 10e3}, StressCycles{0.12, 18.0, 1.0});
    EXPECT_NEAR(test.cycles_to_ru_95.value_or(0.0), 12.0, 0.5);
    const double drift = range_of_cycle(test.path, 16.0).most - range_of_cycle(test.path, 15.0).most;
    EXPECT_GT(drift, 0.02);
    EXPECT_LT(drift, 0.04);
}

TEST(UbcSandStrength, ALiquefiedSpecimenSwingsInAButterflyOfBoundedStrain)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    const CyclicTest test = shear_cyclically(law, {}, StressCycles{0.15, 25.0, 0.5});
    const CycleRange early = range_of_cycle(test.path, 17.0), late = range_of_cycle(test.path, 23.0);
    EXPECT_NEAR(late.most - late.least, 0.046, 0.004); // 4.3 to 4.9 % in the reference
    EXPECT_NEAR(late.most - late.least, early.most - early.least, 0.002);
    EXPECT_GT(late.ru, 0.98);
}

} // namespace
} // namespace quicksand
