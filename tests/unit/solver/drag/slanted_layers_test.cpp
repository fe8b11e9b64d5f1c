#include "solver/drag/slanted_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

constexpr double open = 1.0, tight = 1e6; // resistivities [N s/m4]

/// Parts of the soil about a node in domains of 1/count of a cell, by resistivity(place).
template <class Resistivity>
std::vector<SoilPart> parts_of(int count, Resistivity&& resistivity)
{
    std::vector<SoilPart> parts;
    const double size = 1.0 / count;
    for (int j = -count; j < count; ++j)
        for (int i = -count; i < count; ++i) {
            const Vector2 place((i + 0.5) * size, (j + 0.5) * size);
            const double phi = (1.0 - std::abs(place.x())) * (1.0 - std::abs(place.y()));
            parts.push_back({phi * size * size, size * size, resistivity(place), place,
                             Vector2(0.5 * size, 0.0), Vector2(0.0, 0.5 * size)});
        }
    return parts;
}

double volume_of(const std::vector<SoilPart>& parts, double resistivity)
{
    double volume = 0.0;
    for (const SoilPart& part : parts) volume += part.resistivity == resistivity ? part.volume : 0.0;
    return volume;
}

Vector2 normal_at(double degrees)
{
    const double angle = degrees * std::numbers::pi / 180.0;
    return {-std::sin(angle), std::cos(angle)};
}

/// Angle between two lines [degrees].
double angle_between(const Vector2& a, const Vector2& b)
{
    return std::asin(std::min(1.0, std::abs(a.x() * b.y() - a.y() * b.x()))) * 180.0 / std::numbers::pi;
}

TEST(SlantedDrag, LeadsAlongAFaceAsMuchAsTheOpenSoilAndHardlyAcrossIt)
{
    for (const double degrees : {12.0, 30.0, 45.0, 63.0, 110.0, 160.0}) {
        for (const double distance : {-0.4, 0.0, 0.3}) { // of the face from the node [cells]
            const Vector2 n = normal_at(degrees);
            const auto parts =
                parts_of(16, [&](const Vector2& x) { return n.dot(x) > distance ? tight : open; });
            const double in_open = volume_of(parts, open), in_tight = volume_of(parts, tight),
                         whole = in_open + in_tight;
            const std::optional<SlantedDrag> drag = slanted_drag(parts);
            ASSERT_TRUE(drag);
            EXPECT_LT(angle_between(drag->layer, {n.y(), -n.x()}), 2.5) << degrees << ' ' << distance;
            // W^2/(W_open/r_open): conductivities are added; a strip and the steps of domains are lost
            const double exact = whole * whole * open / in_open;
            EXPECT_GT(drag->along, 0.999 * exact) << degrees << ' ' << distance;
            EXPECT_LT(drag->along, 1.35 * exact) << degrees << ' ' << distance;
            EXPECT_GT(drag->across, 100.0 * drag->along) << degrees << ' ' << distance;
        }
    }
}

TEST(SlantedDrag, FindsASeamWhoseCentreIsThatOfTheSoilAboutIt)
{
    for (const double degrees : {20.0, 45.0, 75.0, 130.0}) {
        const Vector2 n = normal_at(degrees);
        const auto parts =
            parts_of(12, [&](const Vector2& x) { return std::abs(n.dot(x)) < 0.2 ? tight : open; });
        const std::optional<SlantedDrag> drag = slanted_drag(parts);
        ASSERT_TRUE(drag);
        EXPECT_LT(angle_between(drag->layer, {n.y(), -n.x()}), 3.0) << degrees;
        EXPECT_NEAR(drag->across, volume_of(parts, tight) * tight, 1e-4 * drag->across) << degrees;
        EXPECT_LT(drag->along, 5.0 * open) << degrees;
    }
}

TEST(SlantedDrag, IsTurnedAndMirroredWithItsSoil)
{
    const Vector2 n = normal_at(25.0);
    const auto soil = [&](const Vector2& x) { return n.dot(x) > 0.1 ? tight : open; };
    const std::optional<SlantedDrag> drag = slanted_drag(parts_of(2, soil)),
                                     turned = slanted_drag(parts_of(2,
                                                                    [&](const Vector2&x) {
                                                                        return soil({x.y(), -x.x()});
                                                                    })),
                                     mirrored = slanted_drag(parts_of(2, [&](const Vector2&x) {
                                         return soil({-x.x(), x.y()});
                                     }));
    ASSERT_TRUE(drag && turned && mirrored);
    for (const auto& other : {turned, mirrored}) {
        EXPECT_NEAR(other->along, drag->along, 0.02 * drag->along);
        EXPECT_NEAR(other->across, drag->across, 0.02 * drag->across);
    }
    EXPECT_LT(angle_between(turned->layer, {-drag->layer.y(), drag->layer.x()}), 0.5);
    EXPECT_LT(angle_between(mirrored->layer, {-drag->layer.x(), drag->layer.y()}), 0.5);
}

TEST(SlantedDrag, IsNoneInOneSoilAndAlongTheGrid)
{
    for (const double degrees : {0.0, 90.0, 180.0}) {
        const Vector2 n = normal_at(degrees);
        EXPECT_FALSE(
            slanted_drag(parts_of(2, [&](const Vector2& x) { return n.dot(x) > 0.2 ? tight : open; })));
    }
    EXPECT_FALSE(slanted_drag({}));
    EXPECT_FALSE(slanted_drag(parts_of(2, [](const Vector2&) { return open; })));
}

} // namespace
} // namespace quicksand
