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

/// Where a neighbour's vertices divide the edge between two points: fractions of its length, from 0 to 1.
std::vector<double> divisions_by_vertices(const Section& section, const Vector2& start, const Vector2& end)
{
    constexpr double on_edge = 1e-9; // distance from the edge over its length [-]
    const Vector2 along = end - start;
    std::vector<double> fractions = {0.0, 1.0};
    for_each_region_edge(section, [&](const Vector2& vertex, const Vector2&) {
        const double fraction = (vertex - start).dot(along) / along.squaredNorm();
        const bool inside = fraction > on_edge && fraction < 1.0 - on_edge;
        if (inside && (start + fraction * along - vertex).norm() < on_edge * along.norm())
            fractions.push_back(fraction);
    });
    std::sort(fractions.begin(), fractions.end());
    fractions.erase(std::unique(fractions.begin(), fractions.end()), fractions.end());
    return fractions;
}

} // namespace

std::vector<Segment> divided_edges(const Section& section)
{
    std::vector<Segment> edges;
    for_each_region_edge(section, [&](const Vector2& start, const Vector2& end) {
        if (start == end) return;
        const std::vector<double> fractions = divisions_by_vertices(section, start, end);
        for (std::size_t k = 0; k + 1 < fractions.size(); ++k)
            edges.push_back({start + fractions[k] * (end - start), start + fractions[k + 1] * (end - start)});
    });
    return edges;
}

std::vector<Segment> rim_of(const Section& section)
{
    const RegionLocator locator(section);
    std::vector<Segment> rim;
    for (const Segment& edge : divided_edges(section)) {
        const Vector2 &a = edge.start, &b = edge.end;
        const Vector2 to_right = 1e-6 * Vector2(b.y() - a.y(), a.x() - b.x());
        if (!locator.locate(0.5 * (a + b) + to_right)) rim.push_back(edge);
    }
    return rim;
}

} // namespace quicksand
