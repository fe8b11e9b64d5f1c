#include "geometry/sampling/water_cutting.hpp"

#include "geometry/section/convex_pieces.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace quicksand {

namespace {

/// Points with normal . x <= distance.
struct HalfPlane {
    Vector2 normal;
    double distance;

    double beyond(const Vector2& point) const { return normal.dot(point) - distance; }
};

/// The part of a convex ring in a half plane; vertices as near to its rim as rounding lie on it.
Ring part_in(const HalfPlane& half, const Ring& ring)
{
    Ring part;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vector2 &a = ring[k], &b = ring[(k + 1) % ring.size()];
        const double of_a = half.beyond(a), of_b = half.beyond(b);
        if (of_a <= lattice_rounding) part.push_back(a);
        if (std::min(of_a, of_b) < -lattice_rounding && std::max(of_a, of_b) > lattice_rounding)
            part.push_back(a + (b - a) * (of_a / (of_a - of_b)));
    }
    return without_needless_vertices(std::move(part), lattice_rounding);
}

/// Both sides of a piece; the piece alone where hardly anything lies on one of them.
std::vector<Ring> part_at(const HalfPlane& half, const Ring& ring)
{
    std::array<Ring, 2> parts{part_in(half, ring), part_in({-half.normal, -half.distance}, ring)};
    const auto counts = [](const Ring& part) {
        return !part.empty() && signed_area(part) >= smallest_fraction;
    };
    if (!counts(parts[0]) || !counts(parts[1])) return {ring};
    return {std::move(parts[0]), std::move(parts[1])};
}

std::vector<Ring> part_all_at(const HalfPlane& half, const std::vector<Ring>& rings)
{
    std::vector<Ring> all;
    for (const Ring& ring : rings)
        for (Ring& part : part_at(half, ring)) all.push_back(std::move(part));
    return all;
}

double middle_of(const Ring& ring)
{
    const auto [left, right] = std::minmax_element(
        ring.begin(), ring.end(), [](const Vector2& a, const Vector2& b) { return a.x() < b.x(); });
    return 0.5 * (left->x() + right->x());
}

/// Below the straight part of the line at x.
HalfPlane below_line(const std::vector<Vector2>& knees, double x)
{
    const auto right =
        std::find_if(knees.begin(), knees.end(), [&](const Vector2& knee) { return knee.x() >= x; });
    const bool is_level = right == knees.begin() || right == knees.end();
    const Vector2 along = is_level ? Vector2(1.0, 0.0) : (*right - *(right - 1)).normalized();
    const Vector2 normal(-along.y(), along.x());
    return {normal, normal.dot(Vector2(x, elevation(knees, x)))};
}

} // namespace

LineInBoxes::LineInBoxes(const Lattice& lattice, const WaterLine& line)
{
    for (const Vector2& knee : line.points) {
        const Vector2 place = (knee - lattice.origin).cwiseQuotient(lattice.size);
        knees_.emplace_back(on_lattice(place.x()), on_lattice(place.y()));
    }
}

bool LineInBoxes::crosses(int i, int j) const
{
    const double left = elevation(knees_, i), right = elevation(knees_, i + 1);
    double low = std::min(left, right), high = std::max(left, right);
    for (const Vector2& knee : knees_) {
        if (knee.x() <= i || knee.x() >= i + 1) continue;
        low = std::min(low, knee.y());
        high = std::max(high, knee.y());
    }
    return low < j + 1 - lattice_rounding && high > j + lattice_rounding;
}

std::vector<BoxPiece> LineInBoxes::part(int i, int j, const std::vector<BoxPiece>& pieces) const
{
    const Vector2 corner(i, j);
    std::vector<BoxPiece> all;
    for (const BoxPiece& piece : pieces) {
        std::vector<Ring> rings{piece.corners};
        for (const Vector2& knee : knees_) rings = part_all_at({Vector2(1.0, 0.0), knee.x() - i}, rings);
        for (const Ring& ring : rings) { // the line has no knee above or below it
            HalfPlane below = below_line(knees_, i + middle_of(ring));
            below.distance -= below.normal.dot(corner);
            for (Ring& part : part_at(below, ring)) all.push_back({piece.region, std::move(part)});
        }
    }
    return all;
}

} // namespace quicksand
