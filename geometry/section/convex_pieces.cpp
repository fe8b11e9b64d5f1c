#include "geometry/section/convex_pieces.hpp"

#include "geometry/section/exact_rings.hpp"
#include "solver/base/cross_product.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace quicksand {

namespace {

/// A corner with more than a straight angle of soil.
struct ReflexCorner {
    Vector2 place;
    double turn;      // to the left, negative [rad]
    std::size_t axis; // along which the cut's coordinate is constant: 0 for a cut along y
};

/// How far the vertex k lies from the line through its neighbours; nothing where these are one point.
double distance_from_neighbours(const Ring& ring, std::size_t k)
{
    const Vector2 &before = ring[(k + ring.size() - 1) % ring.size()], &after = ring[(k + 1) % ring.size()];
    const double length = (after - before).norm();
    return length > 0.0 ? std::abs(cross(ring[k] - before, after - before)) / length : 0.0;
}

std::optional<ReflexCorner> reflex_corner(const Ring& ring, std::size_t k)
{
    const Vector2 &vertex = ring[k], into = vertex - ring[(k + ring.size() - 1) % ring.size()],
                  out = ring[(k + 1) % ring.size()] - vertex;
    if (cross(into, out) >= 0.0) return std::nullopt;
    const Vector2 halving = into.normalized() - out.normalized();
    constexpr double rounding = 1e-6;
    const bool along_x = std::abs(halving.x()) > (1.0 + rounding) * std::abs(halving.y());
    return ReflexCorner{vertex, std::atan2(cross(into, out), into.dot(out)), along_x ? 1u : 0u};
}

/// Whether to cut at a corner before another: at the sharper, the lower, the one farther left.
bool comes_before(const ReflexCorner& a, const ReflexCorner& b)
{
    constexpr double rounding = 1e-6;
    if (std::abs(a.turn - b.turn) > rounding) return a.turn < b.turn;
    if (std::abs(a.place.y() - b.place.y()) > rounding) return a.place.y() < b.place.y();
    return a.place.x() < b.place.x();
}

std::optional<ReflexCorner> first_reflex_corner(const std::vector<Ring>& rings)
{
    std::optional<ReflexCorner> first;
    for (const Ring& ring : rings) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const auto corner = reflex_corner(ring, k);
            if (corner && (!first || comes_before(*corner, *first))) first = corner;
        }
    }
    return first;
}

ExactRings exact(const std::vector<Ring>& rings)
{
    ExactRings exact_rings;
    for (const Ring& ring : rings) {
        exact_rings.emplace_back();
        for (const Vector2& vertex : ring) exact_rings.back().push_back({vertex.x(), vertex.y()});
    }
    return exact_rings;
}

std::vector<Ring> rounded(const ExactRings& exact_rings)
{
    std::vector<Ring> rings;
    for (const auto& ring : exact_rings) {
        rings.emplace_back();
        for (const ExactPoint& point : ring)
            rings.back().push_back({CGAL::to_double(point[0].exact()), CGAL::to_double(point[1].exact())});
    }
    return rings;
}

/// The parts of an area on either side of the line through a corner.
std::vector<std::vector<Ring>> cut(const std::vector<Ring>& area, const ReflexCorner& corner)
{
    const ExactRings whole = exact(area);
    const double at = corner.place[static_cast<Eigen::Index>(corner.axis)];
    std::vector<std::vector<Ring>> parts;
    for (const ExactRings& part : {part_above(whole, corner.axis, at), part_below(whole, corner.axis, at)})
        if (!part.empty()) parts.push_back(rounded(part));
    return parts;
}

} // namespace

double signed_area(const Ring& ring)
{
    double twice = 0.0;
    for (std::size_t k = 1; k + 1 < ring.size(); ++k)
        twice += cross(ring[k] - ring[0], ring[k + 1] - ring[0]);
    return 0.5 * twice;
}

Ring without_needless_vertices(Ring ring, double tolerance)
{
    std::size_t kept_in_a_row = 0;
    for (std::size_t k = 0; ring.size() > 2 && kept_in_a_row < ring.size();) {
        k %= ring.size();
        const bool needless = (ring[(k + 1) % ring.size()] - ring[k]).norm() <= tolerance ||
                              distance_from_neighbours(ring, k) <= tolerance;
        if (needless) {
            ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
            kept_in_a_row = 0;
        } else {
            ++k;
            ++kept_in_a_row;
        }
    }
    if (ring.size() < 3) ring.clear();
    return ring;
}

std::vector<Ring> convex_pieces(const std::vector<Ring>& rings, double tolerance, double least_area)
{
    std::vector<Ring> pieces;
    std::vector<std::vector<Ring>> areas = {rings};
    while (!areas.empty()) {
        std::vector<Ring> area;
        bool has_holes = false;
        for (const Ring& ring : areas.back()) {
            Ring needed = without_needless_vertices(ring, tolerance);
            const double size = signed_area(needed);
            if (std::abs(size) < least_area) continue;
            has_holes = has_holes || size < 0.0;
            area.push_back(std::move(needed));
        }
        areas.pop_back();
        if (!has_holes && area.size() > 1) {
            for (Ring& ring : area) areas.push_back({std::move(ring)});
            continue;
        }
        const auto corner = first_reflex_corner(area);
        const std::vector<std::vector<Ring>> parts =
            corner ? cut(area, *corner) : std::vector<std::vector<Ring>>();
        // a cut beside all of the area is one at a corner that only rounding makes reflex
        if (parts.size() < 2) {
            for (Ring& ring : area) pieces.push_back(std::move(ring));
            continue;
        }
        areas.insert(areas.end(), parts.begin(), parts.end());
    }
    return pieces;
}

} // namespace quicksand
