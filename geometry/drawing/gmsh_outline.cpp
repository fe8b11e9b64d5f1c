// Outlines of surfaces and lines drawn with one of gmsh's geometry kernels.
#include "geometry/drawing/gmsh_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace quicksand {

namespace {

constexpr int first_pieces = 8;     // of a curved line, before the tolerance is looked at
constexpr int deepest_halving = 12; // at most 8 * 4096 chords a curve

double distance(const Point3& a, const Point3& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Point3 point_on_curve(int curve, double parameter)
{
    std::vector<double> at;
    gmsh::model::getValue(1, curve, {parameter}, at);
    return {at.at(0), at.at(1), at.at(2)};
}

Point3 position_of_point(int point)
{
    std::vector<double> at;
    gmsh::model::getValue(0, point, {}, at);
    return {at.at(0), at.at(1), at.at(2)};
}

/// Distance of a point from the chord a-b [m].
double distance_to_chord(const Point3& point, const Point3& a, const Point3& b)
{
    const double length = distance(a, b);
    if (length == 0.0) return distance(point, a);
    double along = 0.0;
    for (std::size_t k = 0; k < 3; ++k) along += (point[k] - a[k]) * (b[k] - a[k]);
    const double fraction = std::clamp(along / (length * length), 0.0, 1.0);
    Point3 foot;
    for (std::size_t k = 0; k < 3; ++k) foot[k] = a[k] + fraction * (b[k] - a[k]);
    return distance(point, foot);
}

/// Append the points after `start` up to and with `end`, halving until the chord error is below the
/// tolerance.
void append_chords(int curve, double begin, double end, double tolerance, int halvings, Polyline& line)
{
    const Point3 start = line.back(), stop = point_on_curve(curve, end);
    double error = 0.0;
    for (const double fraction : {0.25, 0.5, 0.75}) {
        error = std::max(
            error, distance_to_chord(point_on_curve(curve, begin + fraction * (end - begin)), start, stop));
    }
    if (error <= tolerance || halvings == deepest_halving) {
        line.push_back(stop);
        return;
    }
    const double middle = 0.5 * (begin + end);
    append_chords(curve, begin, middle, tolerance, halvings + 1, line);
    append_chords(curve, middle, end, tolerance, halvings + 1, line);
}

/// Put the curve's own points at the ends, so that the next curve starts at exactly the same place.
void pin_ends(int curve, Polyline& line)
{
    gmsh::vectorpair ends;
    gmsh::model::getBoundary({{1, curve}}, ends, false, false);
    for (const auto& [dimension, point] : ends) {
        const Point3 at = position_of_point(point);
        const double near =
            1e-6 * (distance(line.front(), line.at(1)) + distance(line.back(), line.at(line.size() - 2)));
        if (distance(line.front(), at) <= near) line.front() = at;
        if (distance(line.back(), at) <= near) line.back() = at;
    }
}

Polyline draw_curve(int curve, double tolerance)
{
    std::vector<double> lowest, highest;
    gmsh::model::getParametrizationBounds(1, curve, lowest, highest);
    const double begin = lowest.at(0), end = highest.at(0);
    std::string type;
    gmsh::model::getType(1, curve, type);

    Polyline line = {point_on_curve(curve, begin)};
    if (type == "Line") {
        line.push_back(point_on_curve(curve, end));
    } else {
        for (int piece = 0; piece < first_pieces; ++piece) {
            const double from = begin + (end - begin) * piece / first_pieces;
            const double to = begin + (end - begin) * (piece + 1) / first_pieces;
            append_chords(curve, from, to, tolerance, 0, line);
        }
    }
    pin_ends(curve, line);
    return line;
}

/// Take the piece nearest to `end` out of `pieces`, turned so that it starts there.
Polyline take_nearest_piece(std::vector<Polyline>& pieces, const Point3& end, double& gap)
{
    std::size_t nearest = 0;
    bool turned = false;
    gap = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const double to_start = distance(pieces[k].front(), end), to_end = distance(pieces[k].back(), end);
        // the given direction wins ties: two curves between the same points
        if (std::min(to_start, to_end) >= gap) continue;
        gap = std::min(to_start, to_end);
        nearest = k;
        turned = to_end < to_start;
    }
    Polyline piece = std::move(pieces[nearest]);
    pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(nearest));
    if (turned) std::reverse(piece.begin(), piece.end());
    return piece;
}

/// Chain the pieces into closed rings.
std::vector<Polyline> chain_rings(std::vector<Polyline> pieces, int surface)
{
    double size = 0.0;
    for (const Polyline& piece : pieces) {
        for (const Point3& point : piece) size = std::max(size, distance(point, pieces.front().front()));
    }
    std::vector<Polyline> rings;
    while (!pieces.empty()) {
        Polyline ring = std::move(pieces.front());
        pieces.erase(pieces.begin());
        while (distance(ring.back(), ring.front()) > 1e-7 * size || ring.size() < 3) {
            double gap = std::numeric_limits<double>::infinity();
            const Polyline next = pieces.empty() ? Polyline{} : take_nearest_piece(pieces, ring.back(), gap);
            if (gap > 1e-7 * size) {
                throw "the outline of surface " + std::to_string(surface) +
                    " is not closed: nothing goes on from (" + std::to_string(ring.back()[0]) + ", " +
                    std::to_string(ring.back()[1]) + ")";
            }
            ring.insert(ring.end(), next.begin() + 1, next.end());
        }
        ring.pop_back();
        rings.push_back(std::move(ring));
    }
    return rings;
}

} // namespace

const Polyline& CurveDrawings::draw(int curve)
{
    const auto found = drawn_.find(curve);
    if (found != drawn_.end()) return found->second;
    return drawn_.emplace(curve, draw_curve(curve, tolerance_)).first->second;
}

double twice_signed_area(const Polyline& ring)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point3 &a = ring[k], &b = ring[(k + 1) % ring.size()], &origin = ring.front();
        sum += (a[0] - origin[0]) * (b[1] - origin[1]) - (b[0] - origin[0]) * (a[1] - origin[1]);
    }
    return sum;
}

std::vector<Polyline> outline_surface(int surface, CurveDrawings& curves)
{
    gmsh::vectorpair boundary;
    gmsh::model::getBoundary({{2, surface}}, boundary, false, true);
    std::vector<Polyline> pieces;
    for (const auto& [dimension, curve] : boundary) {
        Polyline piece = curves.draw(std::abs(curve));
        if (curve < 0) std::reverse(piece.begin(), piece.end());
        pieces.push_back(std::move(piece));
    }
    std::vector<Polyline> rings = chain_rings(std::move(pieces), surface);
    if (rings.empty()) throw "surface " + std::to_string(surface) + " has no outline";

    const auto larger = [](const Polyline& a, const Polyline& b) {
        return std::abs(twice_signed_area(a)) < std::abs(twice_signed_area(b));
    };
    std::iter_swap(rings.begin(), std::max_element(rings.begin(), rings.end(), larger));
    for (std::size_t k = 0; k < rings.size(); ++k) {
        const double sense = k == 0 ? 1.0 : -1.0;
        if (sense * twice_signed_area(rings[k]) < 0.0) std::reverse(rings[k].begin(), rings[k].end());
    }
    return rings;
}

} // namespace quicksand
