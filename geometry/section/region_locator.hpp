// Which polygon holds a point, decided without rounding.
#pragma once

#include "geometry/section/section.hpp"

#include <optional>

namespace quicksand {

/// Whether the polygon holds the point. Of polygons that share an edge exactly one holds a point on it: the
/// one to its right or, where the edge is level, above it.
bool contains(const Polygon& polygon, const Vector2& point);

/// Answers for many points which region holds each.
class RegionLocator {
public:
    explicit RegionLocator(const Section& section);

    /// Index of the region that holds the point; none outside the soil.
    std::optional<std::size_t> locate(const Vector2& point) const;

private:
    struct Place {
        const Polygon* polygon;
        std::size_t region;
        Vector2 lower, upper; // bounding box of the polygon [m]
    };
    std::vector<Place> places_;
};

/// The regions to the left and to the right of the middle of a segment; none outside the soil.
struct RegionsBeside {
    std::optional<std::size_t> left, right;
};

RegionsBeside regions_beside(const RegionLocator& locator, const Segment& segment);

} // namespace quicksand
