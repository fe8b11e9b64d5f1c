#include "geometry/section/section_rim.hpp"

#include "geometry/section/region_locator.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// Call visit(start, end) for the edges of all rings, which have their region on the left.
template <class Visit>
void for_each_region_edge(const Section& section, Visit&& visit)
{
    const auto visit_ring = [&](const Ring& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k) visit(ring[k], ring[(k + 1) % ring.size()]);
    };
    for (const Region& region : section.regions) {
        for (const Polygon& polygon : region.polygons) {
            visit_ring(polygon.outer);
            for (const Ring& hole : polygon.holes) visit_ring(hole);
        }
    }
}

/// Where a neighbour's vertices divide the edge between two points: shares of its length, from 0 to 1.
std::vector<double> divisions(const Section& section, const Vector2& start, const Vector2& end)
{
    constexpr double on_edge = 1e-9; // distance from the edge over its length [-]
    const Vector2 along = end - start;
    std::vector<double> shares = {0.0, 1.0};
    for_each_region_edge(section, [&](const Vector2& vertex, const Vector2&) {
        const double share = (vertex - start).dot(along) / along.squaredNorm();
        const bool inside = share > on_edge && share < 1.0 - on_edge;
        if (inside && (start + share * along - vertex).norm() < on_edge * along.norm())
            shares.push_back(share);
    });
    std::sort(shares.begin(), shares.end());
    shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
    return shares;
}

} // namespace

std::vector<Segment> rim_of(const Section& section)
{
    const RegionLocator locator(section);
    std::vector<Segment> rim;
    for_each_region_edge(section, [&](const Vector2& start, const Vector2& end) {
        if (start == end) return;
        const std::vector<double> shares = divisions(section, start, end);
        for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
            const Vector2 a = start + shares[k] * (end - start), b = start + shares[k + 1] * (end - start);
            const Vector2 to_right = 1e-6 * Vector2(b.y() - a.y(), a.x() - b.x());
            if (!locator.locate(0.5 * (a + b) + to_right)) rim.push_back({a, b});
        }
    });
    return rim;
}

} // namespace quicksand
