#include "solver/verification/solutions/large_strain_consolidation.hpp"
#include "solver/verification/solutions/terzaghi.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace quicksand {
namespace {

TEST(LargeStrainConsolidation, SettlementIsPublished)
{
    EXPECT_NEAR(settlement_ratio({1.0, 0.5}, 0.0, 0.1), 0.140399, 5e-7);
    EXPECT_NEAR(settlement_ratio({1.0, 0.5}, 0.0, 0.5), 0.300591, 5e-7);
    EXPECT_NEAR(settlement_ratio({1.0, 1.0}, 0.0, 0.1), 0.225555, 5e-7);
    EXPECT_NEAR(settlement_ratio({1.0, 1.0}, 0.0, 0.5), 0.482909, 5e-7);
}

TEST(LargeStrainConsolidation, SmallLoadsFollowTerzaghi)
{
    const LargeStrainConsolidation layer{10e6, 10.0};
    EXPECT_NEAR(pore_pressure(layer, 0.4, 0.2) / 10.0, terzaghi_pressure_ratio(0.4, 0.2), 1e-6);
    EXPECT_NEAR(settlement_ratio(layer, 0.4, 0.2) / 1e-6, terzaghi_settlement_degree(0.4, 0.2), 1e-6);
}

TEST(LargeStrainConsolidation, EndsAtTheLoadAndItsCompression)
{
    const LargeStrainConsolidation layer{2.0, 2.0};
    EXPECT_NEAR(pore_pressure(layer, 0.5, 0.0), 2.0, 1e-14);
    EXPECT_NEAR(volume_ratio(layer, 0.5, 0.0), 1.0, 1e-14);
    EXPECT_NEAR(pore_pressure(layer, 0.5, 20.0), 0.0, 1e-14);
    EXPECT_NEAR(volume_ratio(layer, 0.5, 20.0), std::exp(-1.0), 1e-14);
    EXPECT_NEAR(settlement_ratio(layer, 0.25, 20.0), 0.75 * (1.0 - std::exp(-1.0)), 1e-14);
}

/// The nonlinear equations by finite volumes, explicit in time, in units M = gamma_w = k_0 = H = 1: Darcy's
/// flux relative to the grains is -(k/J) du/dZ with k = J^2, and J changes by what flows in.
struct Layer {
    std::vector<double> pressure; // by cell, from the top
    double settlement;
};

Layer integrate_layer(double load, double until, int cells)
{
    const double h = 1.0 / cells, dt = 0.2 * h * h;
    const auto steps = static_cast<int>(std::lround(until / dt));
    std::vector<double> J(static_cast<std::size_t>(cells), 1.0), u(J.size()), flux(J.size() + 1, 0.0);
    for (int step = 0; step < steps; ++step) {
        for (std::size_t i = 0; i < J.size(); ++i) u[i] = load + std::log(J[i]);
        flux[0] = -std::exp(-load) * u[0] / (0.5 * h); // the drained top is compressed at once
        for (std::size_t i = 1; i < J.size(); ++i) flux[i] = -0.5 * (J[i] + J[i - 1]) * (u[i] - u[i - 1]) / h;
        for (std::size_t i = 0; i < J.size(); ++i) J[i] += until / steps * (flux[i] - flux[i + 1]) / h;
    }
    Layer layer{u, 0.0};
    for (const double ratio : J) layer.settlement += h * (1.0 - ratio);
    return layer;
}

TEST(LargeStrainConsolidation, AgreesWithFiniteVolumes)
{
    constexpr int cells = 100;
    const LargeStrainConsolidation exact{1.0, 0.5};
    const Layer layer = integrate_layer(0.5, 0.1, cells);
    EXPECT_NEAR(layer.settlement, settlement_ratio(exact, 0.0, 0.1), 1e-3);
    for (const int cell : {10, 40, 90}) {
        const double Z = (cell + 0.5) / cells;
        EXPECT_NEAR(layer.pressure[static_cast<std::size_t>(cell)], pore_pressure(exact, Z, 0.1), 1e-3);
    }
}

} // namespace
} // namespace quicksand
