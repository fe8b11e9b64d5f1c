// The element laboratory with laws whose answers have closed forms.
#include "solver/base/failure.hpp"
#include "solver/element/element_loading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace quicksand {
namespace {

constexpr double G = 10e6, nu = 0.3;

const LinearElastic elastic = {G, nu};
const NeoHookean rubber = {G, nu};

MohrCoulomb frictional(double friction_deg, double dilation_deg, double cohesion)
{
    MohrCoulomb law{.shear_modulus = G, .poisson_ratio = nu, .cohesion = cohesion};
    law.friction_angle = friction_deg * std::numbers::pi / 180.0;
    law.dilation_angle = dilation_deg * std::numbers::pi / 180.0;
    return law;
}

TEST(ElementLaws, ElasticSoilInUndrainedShearHasItsModulusAndNoPorePressure)
{
    for (const double k0 : {0.4, 1.0, 2.0}) {
        for (const ElementPoint& point :
             shear_monotonically(elastic, {100e3, k0, 5e3}, Drainage::undrained, 0.01)) {
            EXPECT_NEAR(point.tau, 5e3 + G * point.gamma, 1e-9 * G * 0.01);
            EXPECT_EQ(point.ru, 0.0);
            EXPECT_EQ(point.sigma_x, k0 * 100e3);
        }
    }
}

TEST(ElementLaws, ElasticSoilDoesNotCareForDrainageInShear)
{
    for (const ElementPoint& point : shear_monotonically(elastic, {}, Drainage::drained, 0.01)) {
        EXPECT_NEAR(point.tau, G * point.gamma, 1e-9 * G * 0.01);
        EXPECT_EQ(point.strain_y, 0.0);
    }
}

TEST(ElementLaws, ElasticSoilInDrainedBiaxialCompressionHasThePlaneStrainModulus)
{
    // d sigma_y / d eps_y = E / (1 - nu^2) = 2 G / (1 - nu), d eps_x = -nu / (1 - nu) d eps_y
    for (const ElementPoint& point : compress_biaxially(elastic, {}, Drainage::drained, 0.01)) {
        EXPECT_NEAR(point.sigma_y, 100e3 + 2.0 * G / (1.0 - nu) * point.strain_y, 1.0);
        EXPECT_NEAR(point.strain_x, -nu / (1.0 - nu) * point.strain_y, 1e-9);
        EXPECT_NEAR(point.sigma_z, 50e3 + nu * (point.sigma_y - 100e3), 1.0);
    }
}

TEST(ElementLaws, ElasticSoilInUndrainedBiaxialCompressionHasHalfTheLoadAsPressure)
{
    for (const ElementPoint& point : compress_biaxially(elastic, {}, Drainage::undrained, 0.01)) {
        const double load = point.sigma_y - 100e3 - (point.sigma_x - 50e3); // 4 G eps_y
        EXPECT_NEAR(load, 4.0 * G * point.strain_y, 1e-3);
        EXPECT_NEAR(point.ru * 100e3, 0.5 * load, 1e-3);
    }
}

TEST(ElementLaws, ElasticSoilInTheOedometerHasItsConstrainedModulusUpAndDown)
{
    const double M = constrained_modulus(elastic);
    const ElementPath path = compress_in_oedometer(elastic, {}, {500e3, 200e3});
    for (const ElementPoint& point : path) {
        EXPECT_NEAR(point.sigma_y, 100e3 + M * point.strain_y, 1.0);
        EXPECT_NEAR(point.sigma_x, 50e3 + nu / (1.0 - nu) * (point.sigma_y - 100e3), 1.0);
    }
    EXPECT_NEAR(path.back().sigma_y, 200e3, 1.0);
    for (const ElementPoint& point : compress_isotropically(elastic, {100e3, 1.0}, {300e3}))
        EXPECT_NEAR(0.5 * (point.sigma_x + point.sigma_y), 100e3 + (M - G) * point.volumetric_strain(), 1.0);
}

TEST(ElementLaws, ElasticCyclesDissipateNothingAndDoNotLiquefy)
{
    const CyclicTest stress = shear_cyclically(elastic, {}, StressCycles{0.3, 20.0});
    EXPECT_FALSE(stress.cycles_to_ru_95 || stress.cycles_to_3_percent);
    for (const ElementPoint& point : stress.path) EXPECT_EQ(point.ru, 0.0);
    for (const CycleSummary& cycle :
         summarize_cycles(shear_cyclically(elastic, {}, StrainCycles{1e-3, 3.0}).path)) {
        EXPECT_NEAR(cycle.secant_modulus, G, 1e-6 * G);
        EXPECT_NEAR(cycle.damping_ratio, 0.0, 1e-9);
    }
    EXPECT_FALSE(cyclic_strength(elastic, {}));
}

TEST(ElementLaws, NeoHookeanSoilIsStrainedToItsStressesAndShearsByItsStretches)
{
    // F = [1 gamma; 0 1] diag(a, b): tau = mu gamma b / a, and sigma_y stays
    const Specimen start = consolidate(rubber, {300e3, 0.5, 0.0});
    EXPECT_NEAR(start.sigma_y(), 300e3, 1e-3);
    EXPECT_NEAR(start.sigma_x(), 150e3, 1e-3);
    EXPECT_EQ(start.strain_y, 0.0);
    const double a = 2.0 * start.point.half_edge_1.x[0], b = 2.0 * start.point.half_edge_2.y[0];
    EXPECT_LT(b, 1.0);
    for (const ElementPoint& point :
         shear_monotonically(rubber, {300e3, 0.5, 0.0}, Drainage::undrained, 0.5)) {
        EXPECT_NEAR(point.tau, G * point.gamma * b / a, 1e-6 * G);
        EXPECT_NEAR(point.ru, 0.0, 1e-7);
    }
}

TEST(ElementLaws, NeoHookeanSoilInTheOedometerFollowsItsLogarithms)
{
    // F = diag(a, b), J = a b: sigma_yy J = lambda ln J + mu (b^2 - 1)
    const double lambda = lame_modulus(rubber);
    const Specimen start = consolidate(rubber, {100e3, 0.5, 0.0});
    const double a = 2.0 * start.point.half_edge_1.x[0], b0 = 2.0 * start.point.half_edge_2.y[0];
    for (const ElementPoint& point : compress_in_oedometer(rubber, {}, {3e6})) {
        const double b = b0 * std::exp(-point.strain_y), J = a * b; // strains are sums of small ones
        const double exact = -(lambda * std::log(J) + G * (b * b - 1.0)) / J;
        EXPECT_NEAR(point.sigma_y, exact, 1e-3 * point.sigma_y);
    }
}

TEST(ElementLaws, MohrCoulombSoilInDrainedBiaxialCompressionFailsAtThePassiveStress)
{
    // sigma_1 = N sigma_3 + 2 c sqrt(N), N = (1 + sin phi) / (1 - sin phi); volume: sin psi of the shear
    // strain
    for (const double dilation : {0.0, 10.0}) {
        const MohrCoulomb law = frictional(35.0, dilation, 4e3);
        const double sine = std::sin(law.friction_angle), N = (1.0 + sine) / (1.0 - sine);
        const ElementPath path = compress_biaxially(law, {100e3, 0.5}, Drainage::drained, 0.05);
        const ElementPoint &last = path.back(), &before = path[path.size() - 50];
        EXPECT_NEAR(last.sigma_y, N * 50e3 + 2.0 * 4e3 * std::sqrt(N), 1.0) << dilation;
        const double volume = last.volumetric_strain() - before.volumetric_strain();
        const double shear = last.strain_y - last.strain_x - before.strain_y + before.strain_x;
        EXPECT_NEAR(volume / shear, -std::sin(law.dilation_angle), 1e-6) << dilation;
    }
}

TEST(ElementLaws, MohrCoulombSoilInDrainedSimpleShearEndsAtTheStressOfDavis)
{
    // strain without extension of the horizontal: tau = (sigma_v + c cot phi) sin phi cos psi /
    // (1 - sin phi sin psi) (Davis 1968)
    for (const double dilation : {0.0, 10.0, 30.0}) {
        for (const double cohesion : {0.0, 5e3}) {
            const MohrCoulomb law = frictional(30.0, dilation, cohesion);
            const double sine = std::sin(law.friction_angle), psi = law.dilation_angle;
            const ElementPath path = shear_monotonically(law, {100e3, 0.5}, Drainage::drained, 0.2);
            const double exact = (100e3 + cohesion / std::tan(law.friction_angle)) * sine * std::cos(psi) /
                                 (1.0 - sine * std::sin(psi));
            EXPECT_NEAR(path.back().tau, exact, 1e-3 * exact) << dilation << " " << cohesion;
            EXPECT_NEAR(path.back().sigma_y, 100e3, 1.0);
        }
    }
}

TEST(ElementLaws, MohrCoulombSoilOfConstantVolumeHasItsUndrainedStrength)
{
    // s stays, t = s sin phi, and the stress turns until sigma_x = sigma_y = s
    const MohrCoulomb law = frictional(30.0, 0.0, 0.0);
    const ElementPoint last = shear_monotonically(law, {100e3, 0.5}, Drainage::undrained, 0.1).back();
    EXPECT_NEAR(last.tau, 75e3 * 0.5, 10.0);
    EXPECT_NEAR(last.sigma_y, 75e3, 10.0);
    EXPECT_NEAR(last.ru, 0.25, 1e-4);
}

std::string objection(const SkeletonLaw& law, const Consolidation& start)
{
    EXPECT_FALSE(can_consolidate(law, start));
    try {
        consolidate(law, start);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ElementLaws, MohrCoulombSoilIsNotConsolidatedBeyondItsStrength)
{
    const MohrCoulomb law = frictional(30.0, 0.0, 0.0);
    EXPECT_TRUE(can_consolidate(law, {90e3, 0.3334}));
    EXPECT_EQ(objection(law, {90e3, 0.2}), "the specimen fails in consolidation: its largest principal "
                                           "stress is 90000 Pa, and beside the least of "
                                           "18000 Pa the soil bears 54000 Pa");
    EXPECT_EQ(objection(frictional(30.0, 0.0, 1e3), {100e3, 1.0, 110e3}),
              "the specimen fails in consolidation: its tension of 10000 Pa is more than the soil bears");
}

TEST(ElementLaws, SoilThatIsTooSoftForItsStressesIsRefused)
{
    EXPECT_THROW(consolidate(NeoHookean{1.0, 0.3}, {1e9, 0.5, 1e10}), InputError);
}

} // namespace
} // namespace quicksand
