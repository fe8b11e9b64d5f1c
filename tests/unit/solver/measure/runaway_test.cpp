// When a body in motion is said to run away: in free motion, and never on the way to rest.
#include "solver/measure/runaway.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace quicksand {
namespace {

constexpr int looks = 400;

/// Look at which it is said first; 0: never. `displacement` is by the share of all looks; the unbalanced
/// force falls by exp(-fall) in all.
int first_certain(const std::function<double(double)>& displacement, double fall = 10.0)
{
    Runaway runaway(1.0);
    for (int look = 1; look <= looks; ++look) {
        const double time = static_cast<double>(look) / looks;
        runaway.note(displacement(time), std::exp(-fall * time));
        if (runaway.is_certain()) return look;
    }
    return 0;
}

TEST(Runaway, IsToldInFreeMotionBeyondTheElasticDisplacement)
{
    const int look = first_certain([](double t) { return 25.0 * t * t; });
    EXPECT_EQ(look, looks / 5);
}

TEST(Runaway, IsToldWhereASlideBeginsLate)
{
    const auto late = [](double t) { return 0.5 + (t > 0.25 ? 25.0 * std::pow(t - 0.25, 2) : 0.0); };
    const int look = first_certain(late, 30.0);
    EXPECT_GT(look, looks / 4);
    EXPECT_LT(look, looks / 2);
}

TEST(Runaway, IsNoElasticBodyThatSwings)
{
    for (const double decay : {0.0, 1.0, 10.0}) {
        const auto swing = [&](double t) { return 0.5 - 0.5 * std::cos(20.0 * t) * std::exp(-decay * t); };
        EXPECT_EQ(first_certain(swing), 0) << decay;
    }
}

TEST(Runaway, IsNoBodyOnItsWayToRestBeyondTheElasticDisplacement)
{
    EXPECT_EQ(first_certain([](double t) { return 3.0 * (0.5 - 0.5 * std::cos(10.0 * t)); }), 0);
    EXPECT_EQ(first_certain([](double t) { return 1.9 * (1.0 - std::exp(-5.0 * t)); }), 0);
    EXPECT_EQ(first_certain([](double t) { return 1.9 * t; }), 0) << "it creeps, and may stop";
    EXPECT_EQ(first_certain([](double t) { return 1.9 * std::sqrt(t); }), 0);
    EXPECT_EQ(first_certain([](double t) { return 30.0 * (1.0 - std::exp(-5.0 * t)); }, 100.0), 0);
}

// A slide flattens the slope and slows down soon, but its forces fall slowly.
TEST(Runaway, IsABodyThatHasGoneFar)
{
    EXPECT_EQ(first_certain([](double t) { return 30.0 * (1.0 - std::exp(-5.0 * t)); }), 8);
    EXPECT_EQ(first_certain([](double t) { return 30.0 * t; }), 27) << "twice as far as slides at least";
    EXPECT_EQ(first_certain([](double t) { return 30.0 * std::sqrt(t); }), 8);
}

TEST(Runaway, IsABodyThatCreepsWhileItsForcesStay)
{
    const auto creep = [](double t) { return 3.0 * t; };
    EXPECT_NEAR(first_certain(creep, 0.0), looks / 3, 1);
    EXPECT_NEAR(first_certain(creep, 1.0), looks / 3, 1);
    EXPECT_EQ(first_certain(creep, 10.0), 0);
    EXPECT_EQ(first_certain([](double t) { return 2.0 * (1.0 - std::exp(-90.0 * t)); }, 0.0), 0);
}

} // namespace
} // namespace quicksand
