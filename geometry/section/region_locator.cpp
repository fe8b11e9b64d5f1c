#include "geometry/section/region_locator.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace quicksand {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 to_point(const Vector2& point)
{
    return {point.x(), point.y()};
}

/// How many edges of the ring a level ray to the right crosses, from a point moved ever so little to the
/// right and still less upwards. CGAL's exact orientation makes the answer the same for both owners of an
/// edge.
int count_crossings(const Ring& ring, const Vector2& point)
{
    int crossings = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vector2 &a = ring[k], &b = ring[(k + 1) % ring.size()];
        if ((a.y() > point.y()) == (b.y() > point.y())) continue;
        const Vector2 &low = a.y() < b.y() ? a : b, &high = a.y() < b.y() ? b : a;
        if (CGAL::orientation(to_point(low), to_point(high), to_point(point)) == CGAL::LEFT_TURN) ++crossings;
    }
    return crossings;
}

} // namespace

bool contains(const Polygon& polygon, const Vector2& point)
{
    int crossings = count_crossings(polygon.outer, point);
    for (const Ring& hole : polygon.holes) crossings += count_crossings(hole, point);
    return crossings % 2 == 1;
}

RegionLocator::RegionLocator(const Section& section)
{
    for (std::size_t region = 0; region < section.regions.size(); ++region) {
        for (const Polygon& polygon : section.regions[region].polygons) {
            Place place{&polygon, region, polygon.outer.front(), polygon.outer.front()};
            for (const Vector2& vertex : polygon.outer) {
                place.lower = place.lower.cwiseMin(vertex);
                place.upper = place.upper.cwiseMax(vertex);
            }
            places_.push_back(place);
        }
    }
}

std::optional<std::size_t> RegionLocator::locate(const Vector2& point) const
{
    for (const Place& place : places_) {
        const bool near =
            (point.array() >= place.lower.array()).all() && (point.array() <= place.upper.array()).all();
        if (near && contains(*place.polygon, point)) return place.region;
    }
    return std::nullopt;
}

RegionsBeside regions_beside(const RegionLocator& locator, const Segment& segment)
{
    constexpr double aside = 1e-6; // of the segment's length [-]
    const Vector2 along = segment.end - segment.start, middle = 0.5 * (segment.start + segment.end);
    const Vector2 to_left = aside * Vector2(-along.y(), along.x());
    return {locator.locate(middle + to_left), locator.locate(middle - to_left)};
}

} // namespace quicksand
