#include "geometry/section/section.hpp"

#include <algorithm>
#include <limits>

namespace quicksand {

namespace {

/// Which side of a vertical line counts where the line meets a vertex or runs along an edge.
enum class Side { left, right };

double signed_area(const Ring& ring)
{
    double twice = 0.0;
    const Vector2& origin = ring.front(); // differences keep far-away coordinates from costing digits
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vector2 a = ring[k] - origin, b = ring[(k + 1) % ring.size()] - origin;
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return 0.5 * twice;
}

/// Add the heights at which the ring crosses the vertical line just beside x.
void collect_crossings(const Ring& ring, double x, Side side, std::vector<double>& heights)
{
    const auto beyond = [&](const Vector2& vertex) {
        return side == Side::right ? vertex.x() > x : vertex.x() >= x;
    };
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vector2 &a = ring[k], &b = ring[(k + 1) % ring.size()];
        if (beyond(a) == beyond(b)) continue;
        // from the left end, so that neighbours' common edge gives the same bits both ways
        const Vector2 &left = a.x() < b.x() ? a : b, &right = a.x() < b.x() ? b : a;
        const double fraction = (x - left.x()) / (right.x() - left.x());
        heights.push_back((1.0 - fraction) * left.y() + fraction * right.y());
    }
}

/// Heights where the vertical line enters and leaves the region, lowest first.
std::vector<double> crossings(const Region& region, double x, Side side)
{
    std::vector<double> heights;
    for (const Polygon& polygon : region.polygons) {
        collect_crossings(polygon.outer, x, side, heights);
        for (const Ring& hole : polygon.holes) collect_crossings(hole, x, side, heights);
    }
    std::sort(heights.begin(), heights.end());
    return heights;
}

/// The crossings of every region; at the section's right end those from its left side.
std::vector<std::vector<double>> crossings_of_regions(const Section& section, double x)
{
    std::vector<std::vector<double>> all;
    bool any = false;
    for (const Side side : {Side::right, Side::left}) {
        all.clear();
        for (const Region& region : section.regions) {
            all.push_back(crossings(region, x, side));
            any = any || !all.back().empty();
        }
        if (any) break;
    }
    return all;
}

} // namespace

void bound_section(Section& section)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    section.lower = Vector2::Constant(infinity);
    section.upper = Vector2::Constant(-infinity);
    for (const Region& region : section.regions) {
        for (const Polygon& polygon : region.polygons) {
            for (const Vector2& vertex : polygon.outer) {
                section.lower = section.lower.cwiseMin(vertex);
                section.upper = section.upper.cwiseMax(vertex);
            }
        }
    }
}

double area(const Region& region)
{
    double sum = 0.0;
    for (const Polygon& polygon : region.polygons) {
        sum += signed_area(polygon.outer);
        for (const Ring& hole : polygon.holes) sum += signed_area(hole);
    }
    return sum;
}

std::vector<double> thickness_above(const Section& section, const Vector2& point)
{
    std::vector<double> thickness;
    for (const std::vector<double>& heights : crossings_of_regions(section, point.x())) {
        double sum = 0.0;
        for (std::size_t k = 0; k + 1 < heights.size(); k += 2) {
            sum += std::max(0.0, heights[k + 1] - std::max(heights[k], point.y()));
        }
        thickness.push_back(sum);
    }
    return thickness;
}

} // namespace quicksand
