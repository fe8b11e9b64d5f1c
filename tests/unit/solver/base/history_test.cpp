// The factor of loads and motions, and its integral against quadrature.
#include "solver/base/history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

std::vector<History> all_shapes()
{
    return {{ConstantHistory{}, 0.0},
            {ConstantHistory{}, 0.4},
            {SineHistory{1.7}, 0.0},
            {SineHistory{1.7}, 0.4},
            {SampledHistory{{0.1, 0.3, 0.9, 1.0}, {2.0, -1.0, 0.5, 0.25}}, 0.0}};
}

TEST(History, IsAFactorOnTheValue)
{
    EXPECT_EQ(history_value({ConstantHistory{}, 0.0}, 0.0), 1.0);
    EXPECT_EQ(history_value({ConstantHistory{}, 2.0}, 0.5), 0.25);
    EXPECT_EQ(history_value({ConstantHistory{}, 2.0}, 3.0), 1.0);
    EXPECT_NEAR(history_value({SineHistory{2.0}, 0.0}, 0.125), 1.0, 1e-15);
    EXPECT_NEAR(history_value({SineHistory{2.0}, 0.25}, 0.125), 0.5, 1e-15);
}

TEST(History, OfATableIsLinearWithinAndConstantOutside)
{
    const History table{SampledHistory{{1.0, 2.0, 4.0}, {3.0, 5.0, -1.0}}, 0.0};
    EXPECT_EQ(history_value(table, 0.0), 3.0);
    EXPECT_EQ(history_value(table, 1.0), 3.0);
    EXPECT_EQ(history_value(table, 1.5), 4.0);
    EXPECT_EQ(history_value(table, 3.0), 2.0);
    EXPECT_EQ(history_value(table, 9.0), -1.0);
}

TEST(History, BeforeItsStartIsThatOfTheStart)
{
    for (const History& history : all_shapes()) {
        EXPECT_EQ(history_value(history, -1.0), history_value(history, 0.0));
        EXPECT_EQ(history_integral(history, -1.0), -history_value(history, 0.0));
    }
}

TEST(History, HasTheIntegralOfItsFactor)
{
    for (const History& history : all_shapes()) {
        constexpr int steps = 13'000; // of the midpoint rule; kinks lie between steps
        constexpr double end = 1.3, step = end / steps;
        double sum = 0.0;
        for (int k = 0; k < steps; ++k) sum += step * history_value(history, (k + 0.5) * step);
        EXPECT_NEAR(history_integral(history, end), sum, 1e-7);
    }
}

TEST(History, KnowsItsPeak)
{
    EXPECT_EQ(peak_value({SineHistory{3.0}, 1.0}), 1.0);
    EXPECT_EQ(peak_value({SampledHistory{{0.0, 1.0}, {0.5, -2.0}}, 0.0}), 2.0);
}

TEST(History, VariesUnlessItIsConstantFromTheStart)
{
    EXPECT_FALSE(varies({}));
    EXPECT_TRUE(varies({ConstantHistory{}, 2.0}));
    EXPECT_TRUE(varies({SineHistory{2.0}, 0.0}));
    EXPECT_TRUE(varies({SampledHistory{{0.0, 1.0}, {0.5, 1.0}}, 0.0}));
    EXPECT_FALSE(varies({SampledHistory{{-1.0, 0.0}, {0.5, 1.0}}, 0.0}));
}

TEST(History, TurnsWhereItIsLargestOrSmallest)
{
    std::vector<History> shapes = all_shapes();
    shapes.push_back({SineHistory{1.0}, 3.2, 0.0});
    shapes.push_back({SineHistory{1.0}, 3.2, 0.7});
    for (const History& history : shapes)
        for (const double end : {0.1, 0.4, 0.6, 0.9, 1.3, 1.9, 2.6, 3.0, 3.7}) { // also within ramps
            const auto times = turning_times(history, end);
            EXPECT_EQ(times.back(), end);
            double low = history_value(history, 0.0), high = low, lowest = low, highest = low;
            for (const double time : times)
                low = std::min(low, history_value(history, time)),
                high = std::max(high, history_value(history, time));
            for (int k = 0; 1e-4 * k <= end; ++k)
                lowest = std::min(lowest, history_value(history, 1e-4 * k)),
                highest = std::max(highest, history_value(history, 1e-4 * k));
            EXPECT_NEAR(low, lowest, 1e-6) << end;
            EXPECT_NEAR(high, highest, 1e-6) << end;
        }
}

TEST(History, SeenFromLaterGoesOn)
{
    for (const History& history : all_shapes()) {
        for (const double later : {0.0, 0.05, 0.2, 0.35, 0.95, 7.0}) {
            const History rest = history_from(history, later);
            for (const double t : {-0.02, 0.0, 0.07, 0.31, 0.6, 3.0}) {
                if (later + t < 0.0) continue;
                EXPECT_NEAR(history_value(rest, t), history_value(history, later + t), 1e-14)
                    << later << ' ' << t;
                const double integral =
                    history_integral(history, later + t) - history_integral(history, later);
                EXPECT_NEAR(history_integral(rest, t), integral, 1e-14) << later << ' ' << t;
            }
        }
    }
}

} // namespace
} // namespace quicksand
