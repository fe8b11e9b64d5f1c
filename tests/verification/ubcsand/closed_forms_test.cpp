// UBCSAND against its own equations integrated by hand: first loading and the first half cycles.
#include "solver/element/cyclic_laboratory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace quicksand {
namespace {

/// I(eta) = integral of (sin phi_cv - eta)/(1 - R eta)^2 over eta from 0, R = R_f/eta_f.
double contraction_integral(const UbcSand& law, double eta)
{
    const double R = law.R, u = 1.0 - R * eta;
    return ((law.sin_cv - 1.0 / R) * (1.0 / u - 1.0) + std::log(1.0 / u) / R) / R;
}

/// s of first undrained loading from s_0 at eta = 0, for F = 1 and ne = me: (s/P_a)^-m grows by m A I(eta),
/// A = (K_B + K_G/3)/K_Gp, m = ne - np.
double undrained_mean_stress(const UbcSand& law, double s_0, double eta)
{
    const double m = law.ne - law.np, A = (law.B_atm + law.G_atm / 3.0) / law.Gp_atm;
    const double start = std::pow(s_0 / 100e3, -m);
    return 100e3 * std::pow(start + m * A * contraction_integral(law, eta), -1.0 / m);
}

TEST(UbcSandFirstLoading, FollowsTheClosedFormUndrained)
{
    for (const double n1_60 : {5.0, 10.0, 15.0, 20.0}) {
        const UbcSand law = make_ubcsand(ubcsand_from_blow_count(n1_60));
        const ElementPath path = shear_monotonically(law, {100e3, 1.0}, Drainage::undrained, 0.01);
        double worst = 0.0, largest_eta = 0.0;
        for (const ElementPoint& point : path) {
            const double s = 0.5 * (point.sigma_x + point.sigma_y);
            const double eta = std::hypot(0.5 * (point.sigma_x - point.sigma_y), point.tau) / s;
            if (eta > law.sin_cv) break;
            const double exact = undrained_mean_stress(law, 100e3, eta);
            worst = std::max(worst, std::abs(s - exact) / exact);
            largest_eta = eta;
        }
        EXPECT_GT(largest_eta, 0.54);
        EXPECT_LT(worst, 1e-4) << "(N1)60 = " << n1_60;
        RecordProperty("worst_" + std::to_string(static_cast<int>(n1_60)), std::to_string(worst));
    }
}

TEST(UbcSandFirstLoading, HasTheTabulatedStressesForABlowCountOf15)
{
    const UbcSand law = make_ubcsand(ubcsand_from_blow_count(15.0));
    const double table[][2] = {{0.1, 92.704e3}, {0.2, 85.514e3}, {0.3, 78.569e3},
                               {0.4, 72.208e3}, {0.5, 67.454e3}, {0.5446, 66.675e3}};
    for (const auto& row : table) EXPECT_NEAR(undrained_mean_stress(law, 100e3, row[0]), row[1], 1.0);
}

/// Shear at constant s: the volume change makes up for the plastic contraction, found by iteration.
void shear_at_constant_mean_stress(double gamma, double s, Specimen& specimen)
{
    const Specimen before = specimen;
    double volumetric = 0.0;
    for (int iteration = 0; iteration < 40; ++iteration) {
        specimen = before;
        strain(0.5 * volumetric, 0.5 * volumetric, gamma, specimen);
        const double error = s - 0.5 * (specimen.sigma_x() + specimen.sigma_y());
        volumetric += error / (constrained_modulus(specimen) - shear_modulus(specimen));
    }
}

TEST(UbcSandFirstLoading, FollowsTheClosedFormAtConstantMeanStress)
{
    // gamma_p = (s/G_i) eta/(1 - R eta), eps_v_p = (s/G_i) I(eta), G_i = K_Gp P_a at s = P_a
    const UbcSand law = make_ubcsand(ubcsand_from_blow_count(15.0));
    Specimen specimen = consolidate(law, {100e3, 1.0});
    double worst_shear = 0.0, worst_volume = 0.0;
    for (double eta = 0.0; eta < 0.54;) {
        shear_at_constant_mean_stress(2e-6, 100e3, specimen);
        eta = specimen.tau() / 100e3;
        if (eta < 0.05) continue;
        const double plastic = specimen.gamma - specimen.tau() / law.G_atm;
        const double shear_exact = 100e3 / law.Gp_atm * eta / (1.0 - law.R * eta);
        const double volume_exact = 100e3 / law.Gp_atm * contraction_integral(law, eta);
        const double volume = specimen.strain_x + specimen.strain_y;
        worst_shear = std::max(worst_shear, std::abs(plastic / shear_exact - 1.0));
        worst_volume = std::max(worst_volume, std::abs(volume / volume_exact - 1.0));
    }
    // explicit steps of 0.0013 to 0.0001 in eta: first order, 0.3 % where the first steps weigh most
    EXPECT_LT(worst_shear, 5e-3);
    EXPECT_LT(worst_volume, 5e-3);
}

TEST(UbcSandHalfCycles, HaveTheMeanStressesOfTheMapAtTheirPeaks)
{
    const UbcSand law = make_ubcsand(ubcsand_from_blow_count(15.0));
    const CyclicTest test = shear_cyclically(law, {100e3, 1.0}, StressCycles{0.2, 4.0, 0.1});
    const std::vector<double> map = {82.532e3, 75.484e3, 68.989e3, 62.931e3,
                                     57.228e3, 51.835e3, 46.769e3, 42.175e3};
    std::vector<double> peaks;
    for (std::size_t k = 1; k + 1 < test.path.size(); ++k) {
        const double before = std::abs(test.path[k - 1].tau), now = std::abs(test.path[k].tau);
        if (now > before && now > std::abs(test.path[k + 1].tau)) {
            peaks.push_back(0.5 * (test.path[k].sigma_x + test.path[k].sigma_y));
        }
    }
    ASSERT_GE(peaks.size(), map.size());
    for (std::size_t k = 0; k < map.size(); ++k) EXPECT_NEAR(peaks[k], map[k], 100.0) << "peak " << k;
}

} // namespace
} // namespace quicksand
