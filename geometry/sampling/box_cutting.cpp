#include "geometry/sampling/box_cutting.hpp"

#include "geometry/section/convex_pieces.hpp"
#include "geometry/section/exact_rings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace quicksand {

namespace {

/// The ring counted in boxes, counter-clockwise or, as a hole, clockwise.
Ring in_boxes(const Lattice& lattice, const Ring& ring, bool is_hole)
{
    Ring boxes;
    for (const Vector2& vertex : ring) {
        const Vector2 place = (vertex - lattice.origin).cwiseQuotient(lattice.size);
        boxes.emplace_back(on_lattice(place.x()), on_lattice(place.y()));
    }
    if ((signed_area(boxes) < 0.0) != is_hole) std::reverse(boxes.begin(), boxes.end());
    return boxes;
}

/// A polygon of a region, counted in boxes.
struct CountedPolygon {
    std::size_t region;
    std::vector<Ring> rings;
};

std::vector<CountedPolygon> count_polygons(const Section& section, const Lattice& lattice)
{
    std::vector<CountedPolygon> polygons;
    for (std::size_t region = 0; region < section.regions.size(); ++region) {
        for (const Polygon& polygon : section.regions[region].polygons) {
            CountedPolygon counted{region, {in_boxes(lattice, polygon.outer, false)}};
            for (const Ring& hole : polygon.holes) counted.rings.push_back(in_boxes(lattice, hole, true));
            polygons.push_back(std::move(counted));
        }
    }
    return polygons;
}

/// Boxes [i_begin, i_end) x [j_begin, j_end) of a lattice.
struct Span {
    int i_begin, i_end, j_begin, j_end;

    bool is_box() const { return i_end - i_begin == 1 && j_end - j_begin == 1; }
};

/// Which boxes an outline runs through, and how many of a span.
class MarkedBoxes {
public:
    MarkedBoxes(const Lattice& lattice, const std::vector<CountedPolygon>& polygons)
        : columns_(lattice.columns), rows_(lattice.rows), sums_(place(lattice.columns, lattice.rows) + 1, 0)
    {
        for (const CountedPolygon& polygon : polygons) {
            for (const Ring& ring : polygon.rings) {
                for (std::size_t k = 0; k < ring.size(); ++k) mark_edge(ring[k], ring[(k + 1) % ring.size()]);
            }
        }
        for (int j = 1; j <= rows_; ++j) {
            for (int i = 1; i <= columns_; ++i)
                sums_[place(i, j)] +=
                    sums_[place(i - 1, j)] + sums_[place(i, j - 1)] - sums_[place(i - 1, j - 1)];
        }
    }

    std::int64_t count(const Span& span) const
    {
        return sums_[place(span.i_end, span.j_end)] - sums_[place(span.i_begin, span.j_end)] -
               sums_[place(span.i_end, span.j_begin)] + sums_[place(span.i_begin, span.j_begin)];
    }

private:
    std::size_t place(int i, int j) const
    {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_ + 1) +
               static_cast<std::size_t>(i);
    }

    /// The range of boxes between two coordinates, those that they only touch left out.
    static std::pair<int, int> range(double from, double to, int boxes)
    {
        const auto limited = [&](double value) {
            return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(boxes)));
        };
        return {limited(std::floor(from + lattice_rounding)), limited(std::ceil(to - lattice_rounding))};
    }

    void mark_edge(const Vector2& start, const Vector2& end)
    {
        const Vector2 &low = start.y() < end.y() ? start : end, &high = start.y() < end.y() ? end : start;
        const auto [first_row, last_row] = range(low.y(), high.y(), rows_);
        const Vector2 along = high - low;
        for (int j = first_row; j < last_row; ++j) {
            const double enters = std::max(low.y(), static_cast<double>(j)),
                         leaves = std::min(high.y(), static_cast<double>(j + 1));
            const bool is_level = along.y() == 0.0;
            const double a = low.x() + along.x() * (is_level ? 0.0 : (enters - low.y()) / along.y()),
                         b = low.x() + along.x() * (is_level ? 1.0 : (leaves - low.y()) / along.y());
            const auto [first, last] = range(std::min(a, b), std::max(a, b), columns_);
            for (int i = first; i < last; ++i) sums_[place(i + 1, j + 1)] = 1;
        }
    }

    int columns_, rows_;
    std::vector<std::int64_t> sums_; // of the marked boxes below and to the left of a corner
};

/// What the regions leave in a box: rings from its lower left corner, polygon by polygon.
using BoxRings = std::map<std::size_t, std::vector<CountedPolygon>>;

class Cutter {
public:
    Cutter(const Lattice& lattice, const MarkedBoxes& marked, BoxRings& boxes)
        : lattice_(lattice), marked_(marked), boxes_(boxes)
    {
    }

    void cut(const CountedPolygon& polygon)
    {
        region_ = polygon.region;
        ExactRings rings;
        for (const Ring& ring : polygon.rings) {
            rings.emplace_back();
            for (const Vector2& vertex : ring) rings.back().push_back({vertex.x(), vertex.y()});
        }
        for (const std::size_t axis : {0u, 1u}) { // nothing beyond the lattice
            rings = part_above(rings, axis, 0);
            rings = part_below(rings, axis, axis == 0 ? lattice_.columns : lattice_.rows);
        }
        divide(rings, {0, lattice_.columns, 0, lattice_.rows});
    }

private:
    void divide(const ExactRings& rings, const Span& span)
    {
        if (rings.empty() || marked_.count(span) == 0) return;
        if (span.is_box()) {
            keep(rings, span);
            return;
        }
        Span below = span, above = span;
        const bool across_x = span.i_end - span.i_begin >= span.j_end - span.j_begin;
        const int middle = across_x ? (span.i_begin + span.i_end) / 2 : (span.j_begin + span.j_end) / 2;
        (across_x ? below.i_end : below.j_end) = middle;
        (across_x ? above.i_begin : above.j_begin) = middle;
        const std::size_t axis = across_x ? 0 : 1;
        divide(part_below(rings, axis, middle), below);
        divide(part_above(rings, axis, middle), above);
    }

    void keep(const ExactRings& rings, const Span& box)
    {
        CountedPolygon rest{region_, {}};
        for (const auto& ring : rings) {
            Ring local;
            for (const ExactPoint& point : ring) {
                const ExactNumber x = point[0] - box.i_begin, y = point[1] - box.j_begin;
                local.emplace_back(on_lattice(CGAL::to_double(x.exact())),
                                   on_lattice(CGAL::to_double(y.exact())));
            }
            local = without_needless_vertices(std::move(local), lattice_rounding);
            if (!local.empty()) rest.rings.push_back(std::move(local));
        }
        if (!rest.rings.empty()) boxes_[lattice_.index(box.i_begin, box.j_begin)].push_back(std::move(rest));
    }

    const Lattice& lattice_;
    const MarkedBoxes& marked_;
    BoxRings& boxes_;
    std::size_t region_ = 0;
};

CutBox content_of(std::size_t index, const std::vector<CountedPolygon>& polygons)
{
    CutBox box;
    box.index = index;
    std::map<std::size_t, double> area_of_region;
    for (const CountedPolygon& polygon : polygons) {
        double& area = area_of_region[polygon.region];
        for (const Ring& ring : polygon.rings) area += signed_area(ring);
        if (area >= 1.0 - smallest_fraction) box.filled_by = polygon.region;
    }
    if (box.filled_by) return box;
    for (const CountedPolygon& polygon : polygons) {
        for (Ring& piece : convex_pieces(polygon.rings, lattice_rounding, smallest_fraction))
            box.pieces.push_back({polygon.region, std::move(piece)});
    }
    return box;
}

} // namespace

double on_lattice(double coordinate)
{
    const double line = std::round(coordinate);
    return std::abs(coordinate - line) < lattice_rounding ? line : coordinate;
}

std::vector<CutBox> cut_boxes(const Section& section, const Lattice& lattice)
{
    const std::vector<CountedPolygon> polygons = count_polygons(section, lattice);
    const MarkedBoxes marked(lattice, polygons);
    BoxRings rings;
    Cutter cutter(lattice, marked, rings);
    for (const CountedPolygon& polygon : polygons) cutter.cut(polygon);

    std::vector<CutBox> boxes;
    for (int j = 0; j < lattice.rows; ++j) {
        for (int i = 0; i < lattice.columns; ++i) {
            if (marked.count({i, i + 1, j, j + 1}) == 0) continue;
            boxes.push_back(content_of(lattice.index(i, j), rings[lattice.index(i, j)]));
        }
    }
    return boxes;
}

} // namespace quicksand
