#include "geometry/section/section_check.hpp"

#include "geometry/section/region_locator.hpp"
#include "geometry/section/region_overlay.hpp"
#include "solver/base/cross_product.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace quicksand {

namespace {

constexpr double relative_tolerance = 1e-8; // of the section's larger side: what counts as touching [-]
constexpr double slit_in_cells = 0.05; // an opening narrower than this between two outlines is a slip [-]
constexpr double corner_sine = 0.35;   // a turn of 20 degrees and more makes a corner [-]

double section_size(const Section& section)
{
    return (section.upper - section.lower).maxCoeff();
}

std::string place(const Vector2& point)
{
    return fmt::format("({:.6g}, {:.6g})", point.x(), point.y());
}

std::string describe(const OutlineFault& fault, const Section& section)
{
    const std::string name = section.regions[fault.region].name, other = section.regions[fault.other].name;
    const std::string box = fmt::format("between {} and {}", place(fault.lower), place(fault.upper));
    switch (fault.kind) {
    case OutlineFault::Kind::too_few_vertices:
        return fmt::format("region \"{}\" has an outline without area at {}.", name, place(fault.lower));
    case OutlineFault::Kind::self_intersection:
        return fmt::format(
            "region \"{}\": its outline meets itself at {}; check the order and the signs of the curves "
            "in its Curve Loop.",
            name, place(fault.lower));
    case OutlineFault::Kind::wrong_hole:
        return fmt::format("region \"{}\": the hole {} leaves the region's outline or meets another hole.",
                           name, box);
    case OutlineFault::Kind::overlap:
        return name == other
                   ? fmt::format("two surfaces of region \"{}\" overlap by {:.4g} m2 {}.", name, fault.area,
                                 box)
                   : fmt::format("regions \"{}\" and \"{}\" overlap by {:.4g} m2 {}; let them share their "
                                 "common curve.",
                                 name, other, fault.area, box);
    case OutlineFault::Kind::gap:
        return fmt::format(
            "between regions \"{}\" and \"{}\" is a gap of {:.4g} m2 {}; let them share their common "
            "curve, or draw a void as a hole of one surface or as a region with soil = \"absent\".",
            name, other, fault.area, box);
    }
    return {};
}

/// Visit every edge of a polygon, holes included.
template <class Visit>
void for_each_edge(const Polygon& polygon, const Visit& visit)
{
    const auto visit_ring = [&](const Ring& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k) visit(ring[k], ring[(k + 1) % ring.size()]);
    };
    visit_ring(polygon.outer);
    for (const Ring& hole : polygon.holes) visit_ring(hole);
}

template <class Named>
void find_duplicate_names(const std::vector<Named>& named, const char* kind,
                          std::vector<std::string>& findings)
{
    std::map<std::string, int> uses;
    for (const Named& one : named) ++uses[one.name];
    for (const auto& [name, count] : uses) {
        if (count > 1)
            findings.push_back(
                fmt::format("{} {}s are called \"{}\"; give each its own name.", count, kind, name));
    }
}

/// The part of a segment, as fractions of its length, that runs along an edge.
struct Stretch {
    double from = 0.0, to = 0.0; // [-]
};

/// Where an edge runs along the segment within the tolerance; empty (from >= to) where it does not.
Stretch common_stretch(const Segment& segment, const Vector2& a, const Vector2& b, double tolerance)
{
    const Vector2 along = segment.end - segment.start;
    const double length = along.norm();
    const Vector2 direction = along / length;
    if (std::abs(cross(direction, a - segment.start)) > tolerance) return {};
    if (std::abs(cross(direction, b - segment.start)) > tolerance) return {};
    const double at_a = direction.dot(a - segment.start) / length,
                 at_b = direction.dot(b - segment.start) / length;
    return {std::min(at_a, at_b), std::max(at_a, at_b)};
}

/// Whether edges of the regions cover the whole segment.
bool lies_on_a_rim(const Section& section, const Segment& segment)
{
    const double length = (segment.end - segment.start).norm();
    const double tolerance = relative_tolerance * section_size(section);
    if (length <= tolerance) return true;
    std::vector<Stretch> stretches;
    for (const Region& region : section.regions) {
        for (const Polygon& polygon : region.polygons) {
            for_each_edge(polygon, [&](const Vector2& a, const Vector2& b) {
                const Stretch stretch = common_stretch(segment, a, b, tolerance);
                if (stretch.from < stretch.to) stretches.push_back(stretch);
            });
        }
    }
    std::sort(stretches.begin(), stretches.end(),
              [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
    double covered = 0.0;
    for (const Stretch& stretch : stretches) {
        if (stretch.from <= covered + tolerance / length) covered = std::max(covered, stretch.to);
    }
    return covered >= 1.0 - tolerance / length;
}

/// Whether a segment goes on in a straight line from one of the same curve that lies on a rim: a wall or a
/// floor drawn farther than the soil, on which it may run out.
bool goes_on_straight(const Section& section, const NamedCurve& curve, const Segment& segment)
{
    const double tolerance = relative_tolerance * section_size(section);
    for (const Segment& other : curve.segments) {
        const Vector2 along = other.end - other.start;
        if (along.norm() <= tolerance || !lies_on_a_rim(section, other)) continue;
        const Vector2 direction = along.normalized();
        if (std::abs(cross(direction, segment.start - other.start)) <= tolerance &&
            std::abs(cross(direction, segment.end - other.start)) <= tolerance)
            return true;
    }
    return false;
}

void find_stray_curves(const Section& section, std::vector<std::string>& findings)
{
    for (const NamedCurve& curve : section.curves) {
        for (const Segment& segment : curve.segments) {
            if (lies_on_a_rim(section, segment) || goes_on_straight(section, curve, segment)) continue;
            findings.push_back(
                fmt::format("curve \"{}\" does not lie on the outline of any region from {} to {}.",
                            curve.name, place(segment.start), place(segment.end)));
            break; // one finding a curve
        }
    }
}

Vector2 nearest_on_edge(const Vector2& point, const Vector2& a, const Vector2& b)
{
    const Vector2 along = b - a;
    const double squared = along.squaredNorm();
    const double fraction = squared > 0.0 ? std::clamp(along.dot(point - a) / squared, 0.0, 1.0) : 0.0;
    return a + fraction * along;
}

Vector2 nearest_on_polygon(const Vector2& point, const Polygon& polygon)
{
    Vector2 nearest = polygon.outer.front();
    for_each_edge(polygon, [&](const Vector2& a, const Vector2& b) {
        const Vector2 candidate = nearest_on_edge(point, a, b);
        if ((candidate - point).norm() < (nearest - point).norm()) nearest = candidate;
    });
    return nearest;
}

/// The vertices where an outline turns sharply. A slope that leaves a neighbour tangentially has none near
/// it.
std::vector<Vector2> corners_of(const Polygon& polygon)
{
    std::vector<Vector2> corners;
    const Ring& ring = polygon.outer;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vector2& vertex = ring[k];
        const Vector2 into = vertex - ring[(k + ring.size() - 1) % ring.size()],
                      out = ring[(k + 1) % ring.size()] - vertex;
        const bool turns =
            std::abs(cross(into, out)) > corner_sine * into.norm() * out.norm() || into.dot(out) < 0.0;
        if (turns) corners.push_back(vertex);
    }
    return corners;
}

/// Whether soil lies between two points, beside the middle of their connection too: at the rim of a section
/// a thin layer may end there.
bool is_soil_between(const Section& section, const Vector2& a, const Vector2& b)
{
    constexpr double beside = 0.1; // of the distance
    const RegionLocator locator(section);
    const Vector2 middle = 0.5 * (a + b), across(a.y() - b.y(), b.x() - a.x());
    for (const double offset : {0.0, beside, -beside})
        if (locator.locate(middle + offset * across).has_value()) return true;
    return false;
}

/// A corner of `polygon` that misses `other` by less than `width` [m]; a sentence's middle part, or empty.
std::string near_miss(const Section& section, const Polygon& polygon, const Polygon& other, double width)
{
    const double touching = relative_tolerance * section_size(section);
    for (const Vector2& corner : corners_of(polygon)) {
        const Vector2 nearest = nearest_on_polygon(corner, other);
        const double distance = (nearest - corner).norm();
        if (distance <= touching || distance >= width || is_soil_between(section, corner, nearest)) continue;
        return fmt::format("{} misses {} by {:.3g} m", place(corner), place(nearest), distance);
    }
    return {};
}

/// Slits that are open to the outside, which the overlay of the regions cannot know for mistakes.
void find_open_slits(const Section& section, double width, std::vector<std::string>& findings)
{
    struct Owned {
        const Region* region;
        const Polygon* polygon;
    };
    std::vector<Owned> all;
    for (const Region& region : section.regions) {
        for (const Polygon& polygon : region.polygons) all.push_back({&region, &polygon});
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            std::string miss = near_miss(section, *all[i].polygon, *all[j].polygon, width);
            if (miss.empty()) miss = near_miss(section, *all[j].polygon, *all[i].polygon, width);
            if (miss.empty()) continue;
            findings.push_back(
                fmt::format("regions \"{}\" and \"{}\" are a slit apart, far narrower than a cell: {}; let "
                            "them share their common curve.",
                            all[i].region->name, all[j].region->name, miss));
        }
    }
}

void check_grid(const Section& section, const BackgroundGrid& grid, std::vector<std::string>& findings)
{
    const double slack = relative_tolerance * section_size(section);
    const Vector2 lower = grid.origin, upper = grid.upper_corner();
    for (const Region& region : section.regions) {
        Section alone;
        alone.regions = {region};
        bound_section(alone);
        const bool inside = (alone.lower.array() >= lower.array() - slack).all() &&
                            (alone.upper.array() <= upper.array() + slack).all();
        if (inside) continue;
        // a section of whole cells needs no further one for its rounding
        const Vector2 cells = ((section.upper - section.lower) / grid.cell_size).array() - relative_tolerance;
        findings.push_back(fmt::format(
            "the grid from {} to {} does not cover region \"{}\", which reaches from {} to {}; the "
            "whole section needs {:.0f} x {:.0f} cells of {:g} m from {}.",
            place(lower), place(upper), region.name, place(alone.lower), place(alone.upper), cells.x(),
            cells.y(), grid.cell_size, place(section.lower)));
        return;
    }
}

} // namespace

std::vector<std::string> check_outlines(const Section& section)
{
    std::vector<std::string> findings;
    for (const OutlineFault& fault : find_outline_faults(section))
        findings.push_back(describe(fault, section));
    return findings;
}

std::vector<std::string> check_section(const Section& section, const BackgroundGrid& grid)
{
    std::vector<std::string> findings;
    find_duplicate_names(section.regions, "region", findings);
    find_duplicate_names(section.curves, "curve", findings);
    find_duplicate_names(section.points, "point", findings);
    const std::vector<std::string> outlines = check_outlines(section);
    findings.insert(findings.end(), outlines.begin(), outlines.end());
    if (outlines.empty()) find_open_slits(section, slit_in_cells * grid.cell_size, findings);
    find_stray_curves(section, findings);
    check_grid(section, grid, findings);
    return findings;
}

} // namespace quicksand
