#include "io/assembly/thin_gaps.hpp"

#include "io/keys/scene_schema.hpp"
#include "io/tables/scene_boundaries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

constexpr double safe_gap = 2.0;        // no node has soil on both sides [cells]
constexpr double least_length = 2.0;    // of a gap that counts [cells]
constexpr double nearly_opposite = 0.7; // of outward normals: faces that meet at less than 45 degrees
constexpr double rounding = 1e-6;       // [cells]

/// The outward normal of an edge with soil on its left.
Vector2 outward(const Segment& segment)
{
    const Vector2 along = (segment.end - segment.start).normalized();
    return {along.y(), -along.x()};
}

/// Distance from a point along a unit vector to where soil begins again [m]; infinite where it does not.
double distance_to_soil(const Vector2& from, const Vector2& direction, const std::vector<Segment>& rim)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const Segment& edge : rim) {
        if (outward(edge).dot(direction) > -nearly_opposite) continue;
        const Vector2 along = edge.end - edge.start, apart = edge.start - from;
        const auto cross = [](const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); };
        const double determinant = cross(direction, along); // not zero: the edge faces the ray
        const double distance = cross(apart, along) / determinant;
        const double place = cross(apart, direction) / determinant; // of the edge's length
        if (place >= 0.0 && place <= 1.0 && distance > 0.0) nearest = std::min(nearest, distance);
    }
    return nearest;
}

/// Whether a whole cell lies in a gap along an axis.
bool holds_a_cell(double a, double b, double origin, double cell_size)
{
    const double lower = (std::min(a, b) - origin) / cell_size, upper = (std::max(a, b) - origin) / cell_size;
    return std::floor(upper + rounding) - std::ceil(lower - rounding) >= 1.0;
}

struct Gap {
    double width = std::numeric_limits<double>::infinity(); // the least [m]
    Vector2 place = Vector2::Zero();                        // in its middle [m]
    double length = 0.0;                                    // along the curve [m]
};

/// The part of a curve beyond which soil lies too near.
Gap gap_of(const Boundary& boundary, const std::vector<Segment>& rim, const BackgroundGrid& grid)
{
    const double h = grid.cell_size;
    Gap gap;
    for (const Segment& segment : boundary.segments) {
        const double length = (segment.end - segment.start).norm();
        const Vector2 normal = outward(segment);
        const int points = std::max(1, static_cast<int>(std::ceil(2.0 * length / h)));
        for (int k = 0; k < points; ++k) {
            const Vector2 from = segment.start + (k + 0.5) / points * (segment.end - segment.start);
            const double width = distance_to_soil(from, normal, rim);
            if (width > (safe_gap - rounding) * h) continue;
            const Vector2 to = from + width * normal;
            const int axis = std::abs(normal.x()) > std::abs(normal.y()) ? 0 : 1;
            if (std::abs(normal[axis]) > 1.0 - rounding &&
                holds_a_cell(from[axis], to[axis], grid.origin[axis], h))
                continue;
            gap.length += length / points;
            if (width < gap.width) gap.width = width, gap.place = 0.5 * (from + to);
        }
    }
    return gap;
}

SourcePlace place_of(const Scene& scene, const std::string& curve)
{
    const SceneBoundary* written = find_boundary(scene, curve);
    return written == nullptr ? scene.geometry_place : written->place;
}

} // namespace

void check_gaps(const Scene& scene, const Problem& problem, Diagnostics& findings)
{
    const double h = problem.grid.cell_size;
    for (const Boundary& boundary : problem.boundaries) {
        const Gap gap = gap_of(boundary, problem.rim, problem.grid);
        if (gap.length < least_length * h) continue;
        findings.add(warning_at(
            place_of(scene, boundary.name), join_path({"boundaries", boundary.name}), "thin-gap",
            fmt::format("soil lies {:.3g} m beyond the curve \"{}\", near {} m, less than two "
                        "cells of {:.3g} m: both sides have nodes in common, move together and let water "
                        "pass",
                        gap.width, boundary.name, place_text(gap.place), h),
            fmt::format("a gap of at least {:.3g} m", safe_gap * h),
            "choose smaller cells, or draw what fills the gap as a region of its own"));
    }
}

} // namespace quicksand
