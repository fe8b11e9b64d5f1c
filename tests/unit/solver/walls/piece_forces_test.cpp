#include "solver/walls/piece_forces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

/// Ten pieces of one length along ten cells, each at the middle of its own.
std::vector<PieceWeights> pieces_along_a_line()
{
    std::vector<PieceWeights> pieces;
    for (std::size_t k = 0; k < 10; ++k) pieces.push_back({0.5, true, {{k, 0.5}, {k + 1, 0.5}}});
    return pieces;
}

double largest_of(const Scalars& values)
{
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

TEST(PieceForces, HaveTheSumsThatPiecesCanCarry)
{
    const std::vector<PieceWeights> pieces = pieces_along_a_line();
    const std::vector<std::uint8_t> all(11, 1);
    Scalars uniform(11, 1e4);
    uniform.front() = uniform.back() = 0.5e4;
    for (const double force : spread_on_pieces(pieces, all, uniform)) EXPECT_NEAR(force, 1e4, 1e-4);
    const Scalars sums = sums_at_nodes(pieces, all, spread_on_pieces(pieces, all, uniform));
    for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_NEAR(sums[i], uniform[i], 1e-4);
}

// A corner of a domain that reaches a node by a millionth: to load that node the piece would have to bear a
// million times as much, and the next one the opposite.
TEST(PieceForces, AreNoneThatCancelEachOther)
{
    const std::vector<PieceWeights> pieces = {{0.5, false, {{0, 1.0}}},
                                              {0.5, false, {{0, 1.0 - 1e-6}, {1, 1e-6}}}};
    const std::vector<std::uint8_t> all(2, 1);
    const Scalars forces = spread_on_pieces(pieces, all, {1e4, 1e4});
    EXPECT_NEAR(forces[0], 5e3, 1e3);
    EXPECT_NEAR(forces[1], 5e3, 1e3);
}

TEST(PieceForces, AreNoneWhereNoPieceReachesTheNodes)
{
    const std::vector<std::uint8_t> chosen = {0, 0, 1};
    const Scalars forces = spread_on_pieces({{0.5, true, {{0, 1.0}}}}, chosen, {0.0, 0.0, 1e4});
    EXPECT_EQ(largest_of(forces), 0.0);
}

TEST(PieceForces, OfAFollowerCountAtTheNodesThatItFollows)
{
    VelocityRows rows;
    rows.clear(4);
    rows.begin_followers();
    rows.begin_row(0.0);
    rows.add(3, NodeVelocities::Unit(1));
    rows.add(2, -1.5 * NodeVelocities::Unit(1));
    rows.add(1, 0.5 * NodeVelocities::Unit(1));
    const FollowingNodes along_x(rows, 0), along_y(rows, 1);
    EXPECT_FALSE(along_x.contains(3));
    ASSERT_TRUE(along_y.contains(3));

    Scalars forces = {1.0, 2.0, 3.0, 4.0};
    along_y.pass_on(forces);
    EXPECT_EQ(forces, (Scalars{1.0, 0.0, 9.0, 0.0}));

    const std::vector<PieceWeights> passed = along_y.passed_on({{1.0, false, {{0, 0.5}, {3, 0.5}}}});
    const std::vector<std::uint8_t> all(4, 1);
    EXPECT_EQ(sums_at_nodes(passed, all, {4.0}), (Scalars{2.0, -1.0, 3.0, 0.0}));
}

} // namespace
} // namespace quicksand
