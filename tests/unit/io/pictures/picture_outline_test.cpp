#include "io/pictures/picture_outline.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

constexpr double pixel_width = 0.01; // [m]

DomainCorners box(double x, double y, double width, double height)
{
    return {Vector2(x, y), Vector2(x + width, y), Vector2(x + width, y + height), Vector2(x, y + height)};
}

double length_of(const std::vector<std::vector<Vector2>>& lines)
{
    double length = 0.0;
    for (const auto& line : lines)
        for (std::size_t k = 1; k < line.size(); ++k) length += (line[k] - line[k - 1]).norm();
    return length;
}

} // namespace

TEST(Outline, OfManyBoxesIsOneClosedLineRoundThemAll)
{
    std::vector<DomainCorners> domains;
    for (int row = 0; row < 20; ++row)
        for (int column = 0; column < 30; ++column) domains.push_back(box(0.1 * column, 0.1 * row, 0.1, 0.1));
    const auto lines = outline_of(domains, pixel_width);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR((lines[0].front() - lines[0].back()).norm(), 0.0, 1e-12);
    EXPECT_NEAR(length_of(lines), 10.0, 1e-9);
}

TEST(Outline, KnowsNeighboursThatShareAPartOfAnEdge)
{
    const std::vector<DomainCorners> domains{box(0.0, 0.0, 1.0, 1.0), box(0.0, 1.0, 0.4, 0.5),
                                             box(0.4, 1.0, 0.2, 0.5)};
    EXPECT_NEAR(length_of(outline_of(domains, pixel_width)), 5.0, 3.0 * pixel_width);
}

TEST(Outline, RunsAroundHolesToo)
{
    std::vector<DomainCorners> domains;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            if (row != 1 || column != 1) domains.push_back(box(column, row, 1.0, 1.0));
    const auto lines = outline_of(domains, pixel_width);
    EXPECT_EQ(lines.size(), 2u);
    EXPECT_NEAR(length_of(lines), 16.0, 1e-9);
}

TEST(Outline, PassesOverGapsAndThinPieces)
{
    // A gap of half a pixel beside the first, and a sliver a fifth of a pixel thin below the second.
    const auto lines =
        outline_of({box(0.0, 0.0, 1.0, 1.0), box(1.005, 0.0, 0.995, 1.0), box(1.005, -0.002, 0.995, 0.002)},
                   pixel_width);
    EXPECT_NEAR(length_of(lines), 6.0, 0.02);
}

TEST(Outline, OfNothingIsNothing)
{
    EXPECT_TRUE(outline_of({}, pixel_width).empty());
}

} // namespace quicksand
