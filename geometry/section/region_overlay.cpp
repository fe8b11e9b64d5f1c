#include "geometry/section/region_overlay.hpp"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <cmath>
#include <optional>

namespace quicksand {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using ExactRing = CGAL::Polygon_2<Kernel>;
using ExactPolygon = CGAL::Polygon_with_holes_2<Kernel>;

constexpr double lattice_step = 1e-9; // of the section's larger side [-]
constexpr double thin_steps = 4.0;    // a sliver not wider than this is rounding [lattice steps]

/// The lattice that coordinates are rounded to; within this file rings are counted in its steps.
struct RoundingLattice {
    Vector2 origin; // [m]
    double step;    // [m]

    Point round(const Vector2& point) const
    {
        const Vector2 steps = (point - origin) / step;
        return {std::round(steps.x()), std::round(steps.y())};
    }
    Vector2 back(double x, double y) const { return origin + step * Vector2(x, y); }
};

struct Piece {
    std::size_t region = 0;
    ExactPolygon polygon;
};

ExactRing round_ring(const Ring& ring, const RoundingLattice& lattice)
{
    ExactRing rounded;
    for (const Vector2& vertex : ring) {
        const Point point = lattice.round(vertex);
        if (rounded.is_empty() || point != rounded[rounded.size() - 1]) rounded.push_back(point);
    }
    while (rounded.size() > 1 && rounded[0] == rounded[rounded.size() - 1])
        rounded.erase(rounded.vertices_end() - 1);
    return rounded;
}

double perimeter(const ExactRing& ring)
{
    double sum = 0.0;
    for (auto edge = ring.edges_begin(); edge != ring.edges_end(); ++edge) {
        sum += std::sqrt(CGAL::to_double(edge->squared_length()));
    }
    return sum;
}

double area_of(const ExactPolygon& polygon)
{
    double sum = std::abs(CGAL::to_double(polygon.outer_boundary().area()));
    for (const ExactRing& hole : polygon.holes()) sum -= std::abs(CGAL::to_double(hole.area()));
    return sum;
}

/// Whether a common part or void is nothing but rounding.
bool is_thin(const ExactPolygon& polygon)
{
    return area_of(polygon) <= 0.5 * thin_steps * perimeter(polygon.outer_boundary());
}

bool any_thick(const std::vector<ExactPolygon>& polygons)
{
    return std::any_of(polygons.begin(), polygons.end(),
                       [](const ExactPolygon& polygon) { return !is_thin(polygon); });
}

OutlineFault fault_with_box(OutlineFault::Kind kind, const ExactRing& ring, double area,
                            const RoundingLattice& lattice)
{
    const CGAL::Bbox_2 box = ring.bbox();
    OutlineFault fault;
    fault.kind = kind;
    fault.lower = lattice.back(box.xmin(), box.ymin());
    fault.upper = lattice.back(box.xmax(), box.ymax());
    fault.area = area * lattice.step * lattice.step;
    return fault;
}

/// A point that two edges share though the ring gives them no common end.
std::optional<Point> common_point(const ExactRing& ring, std::size_t i, std::size_t j)
{
    const auto edge_i = ring.edge(i), edge_j = ring.edge(j);
    const auto common = CGAL::intersection(edge_i, edge_j);
    if (!common) return std::nullopt;
    if (const Kernel::Segment_2* stretch = boost::get<Kernel::Segment_2>(&*common)) return stretch->source();
    const Point point = boost::get<Point>(*common);
    const bool neighbours = j == i + 1 || (i == 0 && j == ring.size() - 1);
    return neighbours ? std::nullopt : std::optional<Point>(point);
}

/// Where a ring that is not simple meets itself.
Point find_self_intersection(const ExactRing& ring)
{
    for (std::size_t i = 0; i < ring.size(); ++i) {
        for (std::size_t j = i + 1; j < ring.size(); ++j) {
            if (!CGAL::do_overlap(ring.edge(i).bbox(), ring.edge(j).bbox())) continue;
            if (const std::optional<Point> point = common_point(ring, i, j)) return *point;
        }
    }
    return ring[0];
}

/// What is wrong with a ring by itself.
std::optional<OutlineFault> check_ring(const ExactRing& ring, const RoundingLattice& lattice)
{
    OutlineFault fault;
    if (ring.size() < 3) {
        fault.kind = OutlineFault::Kind::too_few_vertices;
        if (!ring.is_empty())
            fault.lower = lattice.back(CGAL::to_double(ring[0].x()), CGAL::to_double(ring[0].y()));
        fault.upper = fault.lower;
        return fault;
    }
    if (ring.is_simple()) return std::nullopt;
    const Point point = find_self_intersection(ring);
    fault.kind = OutlineFault::Kind::self_intersection;
    fault.lower = fault.upper = lattice.back(CGAL::to_double(point.x()), CGAL::to_double(point.y()));
    return fault;
}

void turn(ExactRing& ring, CGAL::Orientation orientation)
{
    if (ring.orientation() != orientation) ring.reverse_orientation();
}

/// Holes that leave the outer ring or meet a hole before them; both given counter-clockwise.
std::optional<OutlineFault> check_holes(const ExactRing& outer, const std::vector<ExactRing>& holes,
                                        const RoundingLattice& lattice)
{
    for (std::size_t k = 0; k < holes.size(); ++k) {
        std::vector<ExactPolygon> wrong;
        CGAL::difference(holes[k], outer, std::back_inserter(wrong));
        for (std::size_t before = 0; before < k; ++before) {
            CGAL::intersection(holes[k], holes[before], std::back_inserter(wrong));
        }
        if (any_thick(wrong)) {
            return fault_with_box(OutlineFault::Kind::wrong_hole, holes[k], 0.0, lattice);
        }
    }
    return std::nullopt;
}

/// The polygon on the lattice, or the fault that keeps it from being one.
std::optional<OutlineFault> round_polygon(const Polygon& polygon, const RoundingLattice& lattice,
                                          ExactPolygon& rounded)
{
    ExactRing outer = round_ring(polygon.outer, lattice);
    if (auto fault = check_ring(outer, lattice)) return fault;
    turn(outer, CGAL::COUNTERCLOCKWISE);
    std::vector<ExactRing> holes;
    for (const Ring& ring : polygon.holes) {
        ExactRing hole = round_ring(ring, lattice);
        if (auto fault = check_ring(hole, lattice)) return fault;
        turn(hole, CGAL::COUNTERCLOCKWISE);
        holes.push_back(std::move(hole));
    }
    if (auto fault = check_holes(outer, holes, lattice)) return fault;
    for (ExactRing& hole : holes) hole.reverse_orientation();
    rounded = ExactPolygon(outer, holes.begin(), holes.end());
    return std::nullopt;
}

void find_overlaps(const std::vector<Piece>& pieces, const RoundingLattice& lattice,
                   std::vector<OutlineFault>& faults)
{
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t j = i + 1; j < pieces.size(); ++j) {
            if (!CGAL::do_overlap(pieces[i].polygon.bbox(), pieces[j].polygon.bbox())) continue;
            std::vector<ExactPolygon> common;
            CGAL::intersection(pieces[i].polygon, pieces[j].polygon, std::back_inserter(common));
            for (const ExactPolygon& part : common) {
                if (is_thin(part)) continue;
                OutlineFault fault = fault_with_box(OutlineFault::Kind::overlap, part.outer_boundary(),
                                                    area_of(part), lattice);
                fault.region = pieces[i].region;
                fault.other = pieces[j].region;
                faults.push_back(fault);
            }
        }
    }
}

/// Whether one polygon has this void as a hole of its own, drawn on purpose.
bool is_declared_hole(const ExactRing& empty, const std::vector<Piece>& pieces)
{
    for (const Piece& piece : pieces) {
        for (ExactRing hole : piece.polygon.holes()) {
            if (!CGAL::do_overlap(hole.bbox(), empty.bbox())) continue;
            hole.reverse_orientation();
            std::vector<ExactPolygon> rest;
            CGAL::symmetric_difference(hole, empty, std::back_inserter(rest));
            if (!any_thick(rest)) return true;
        }
    }
    return false;
}

bool has_edge_at(const ExactRing& ring, const Point& point)
{
    return std::any_of(ring.edges_begin(), ring.edges_end(), [&](const Kernel::Segment_2& edge) {
        return CGAL::to_double(CGAL::squared_distance(edge, point)) <= thin_steps * thin_steps;
    });
}

/// The regions around a void, by the middles of its edges, lowest index first.
std::vector<std::size_t> regions_around(const ExactRing& empty, const std::vector<Piece>& pieces)
{
    std::vector<std::size_t> around;
    for (const Piece& piece : pieces) {
        if (!around.empty() && around.back() == piece.region) continue;
        for (auto edge = empty.edges_begin(); edge != empty.edges_end(); ++edge) {
            const Point middle = CGAL::midpoint(edge->source(), edge->target());
            const bool beside = has_edge_at(piece.polygon.outer_boundary(), middle) ||
                                std::any_of(piece.polygon.holes_begin(), piece.polygon.holes_end(),
                                            [&](const ExactRing& hole) { return has_edge_at(hole, middle); });
            if (!beside) continue;
            around.push_back(piece.region);
            break;
        }
    }
    return around;
}

void find_gaps(const std::vector<Piece>& pieces, const RoundingLattice& lattice,
               std::vector<OutlineFault>& faults)
{
    std::vector<ExactPolygon> polygons, soil;
    for (const Piece& piece : pieces) polygons.push_back(piece.polygon);
    CGAL::join(polygons.begin(), polygons.end(), std::back_inserter(soil));
    for (const ExactPolygon& body : soil) {
        for (ExactRing empty : body.holes()) {
            empty.reverse_orientation();
            if (is_thin(ExactPolygon(empty)) || is_declared_hole(empty, pieces)) continue;
            const std::vector<std::size_t> around = regions_around(empty, pieces);
            const double size = CGAL::to_double(empty.area());
            OutlineFault fault = fault_with_box(OutlineFault::Kind::gap, empty, size, lattice);
            if (!around.empty()) {
                fault.region = around.front();
                fault.other = around.back();
            }
            faults.push_back(fault);
        }
    }
}

} // namespace

std::vector<OutlineFault> find_outline_faults(const Section& section)
{
    std::vector<OutlineFault> faults;
    const double size = (section.upper - section.lower).maxCoeff();
    if (!(size > 0.0)) return faults;
    const RoundingLattice lattice{section.lower, lattice_step * size};

    std::vector<Piece> pieces;
    for (std::size_t region = 0; region < section.regions.size(); ++region) {
        for (const Polygon& polygon : section.regions[region].polygons) {
            Piece piece{region, {}};
            if (auto fault = round_polygon(polygon, lattice, piece.polygon)) {
                fault->region = fault->other = region;
                faults.push_back(*fault);
            } else {
                pieces.push_back(std::move(piece));
            }
        }
    }
    find_overlaps(pieces, lattice, faults);
    // a void beside an outline at fault, or under an overlap, would be reported twice
    if (faults.empty()) find_gaps(pieces, lattice, faults);
    return faults;
}

} // namespace quicksand
