// Ripples on the strain path of UBCSAND, as the waves of a grid make them: they must neither be counted as
// half cycles nor keep the sand from liquefying.
#include "solver/element/cyclic_laboratory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace quicksand {
namespace {

constexpr int steps_per_leg = 400;

/// Shear strain of symmetric cycles in steps, from zero to gamma_a first.
std::vector<double> cycles_of_strain(double amplitude, int half_cycles)
{
    std::vector<double> path;
    for (int k = 0; k <= steps_per_leg * half_cycles; ++k) {
        const double phase = static_cast<double>(k) / steps_per_leg; // half cycles so far
        const double saw = std::abs(std::remainder(phase - 0.5, 2.0));
        path.push_back(amplitude * (1.0 - 2.0 * saw));
    }
    return path;
}

/// The same path with every twentieth step taken back by a fraction of itself.
std::vector<double> with_back_steps(const std::vector<double>& path, double fraction)
{
    std::vector<double> rippled;
    for (std::size_t k = 0; k < path.size(); ++k) {
        rippled.push_back(path[k]);
        if (k % 20 == 19) rippled.push_back(path[k] - fraction * (path[k] - path[k - 1]));
    }
    return rippled;
}

/// The same path with a sine of 21 times its frequency on it.
std::vector<double> with_sine(const std::vector<double>& path, double amplitude)
{
    std::vector<double> rippled = path;
    for (std::size_t k = 0; k < path.size(); ++k) {
        rippled[k] += amplitude * std::sin(21.0 * 3.141592653589793 * static_cast<double>(k) / steps_per_leg);
    }
    return rippled;
}

struct Outcome {
    double half_cycles, ru;
};

/// Undrained simple shear of Nevada sand at 100 kPa, K0 = 0.5; ru is its largest.
Outcome shear_along(const std::vector<double>& path)
{
    const UbcSand law = make_ubcsand(with(UbcSandRunSettings(), nevada_sand_55()));
    Specimen specimen = consolidate(law, {});
    Outcome outcome{};
    for (std::size_t k = 1; k < path.size(); ++k) {
        strain(0.0, 0.0, path[k] - path[k - 1], specimen);
        outcome.ru = std::max(outcome.ru, record(specimen, 0.0).ru);
    }
    outcome.half_cycles = specimen.point.memory[column_of(memory_of(law), "half_cycles")][0];
    return outcome;
}

TEST(UbcSandNoise, BackStepsAreNoHalfCycles)
{
    for (const double amplitude : {3e-4, 5e-4, 2e-3}) {
        const std::vector<double> path = cycles_of_strain(amplitude, 60);
        const Outcome clean = shear_along(path);
        EXPECT_NEAR(clean.half_cycles, 60.0, 1.0) << amplitude;
        for (const double fraction : {0.1, 0.5}) {
            const Outcome noisy = shear_along(with_back_steps(path, fraction));
            EXPECT_NEAR(noisy.half_cycles, 60.0, 6.0) << amplitude << " " << fraction;
            EXPECT_NEAR(noisy.ru, clean.ru, 0.01) << amplitude << " " << fraction;
        }
    }
}

TEST(UbcSandNoise, ASineOfTwoAndOfFivePercentIsNoHalfCycle)
{
    const std::vector<double> path = cycles_of_strain(5e-4, 20);
    const Outcome clean = shear_along(path);
    for (const double fraction : {0.02, 0.05}) {
        const Outcome noisy = shear_along(with_sine(path, fraction * 5e-4));
        RecordProperty("half_cycles_" + std::to_string(fraction), std::to_string(noisy.half_cycles));
        RecordProperty("ru_" + std::to_string(fraction), std::to_string(noisy.ru));
        EXPECT_NEAR(noisy.half_cycles, clean.half_cycles, 2.0) << fraction;
        EXPECT_NEAR(noisy.ru, clean.ru, 0.02) << fraction;
    }
}

/// Mean stress in the plane [Pa] that sand which has liquefied gains by 2 % of shear in 8 s, with ripples of
/// 50 Hz.
double dilation_of_liquefied_sand(double ripple)
{
    const UbcSand law = make_ubcsand(with(UbcSandRunSettings(), nevada_sand_55()));
    Specimen specimen = consolidate(law, {});
    const std::vector<double> cycles = cycles_of_strain(3e-3, 40);
    for (std::size_t k = 1; k < cycles.size(); ++k) strain(0.0, 0.0, cycles[k] - cycles[k - 1], specimen);
    double before = 0.0;
    constexpr int steps = 20000;
    for (int k = 1; k <= steps; ++k) {
        const double time = 8.0 * k / steps;
        const double gamma = 0.02 * k / steps + ripple * std::sin(100.0 * 3.141592653589793 * time);
        strain(0.0, 0.0, gamma - before, specimen);
        before = gamma;
    }
    return 0.5 * (specimen.sigma_x() + specimen.sigma_y());
}

TEST(UbcSandNoise, RipplesDoNotKeepLiquefiedSandFromDilating)
{
    const double gained = dilation_of_liquefied_sand(0.0);
    EXPECT_GT(gained, 5e3);
    for (const double ripple : {1e-6, 1e-5, 3e-5})
        EXPECT_NEAR(dilation_of_liquefied_sand(ripple), gained, 0.02 * gained) << ripple;
}

} // namespace
} // namespace quicksand
