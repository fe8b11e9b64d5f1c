#include "io/scene/scene_grid.hpp"

#include "io/keys/scene_units.hpp"
#include "io/scene/cell_size.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace quicksand {

namespace {

constexpr double room_above = 0.15;  // of the section's height [-]
constexpr double room_to_flow = 1.0; // beyond a side where slopes can run out, of the section's height [-]
constexpr double least_room = 4.0;   // [cells]
constexpr double most_cells = 2e8;   // far beyond any machine that runs this program [-]

/// What lies along one edge of the section's bounding box.
struct Edge {
    double soil = 0.0, wall = 0.0; // lengths of the outlines and of walls that do not move along it [m]
    bool has_moving_wall = false;
    bool meets_wall = false; // in a point at least, of a wall that does not stand on it
};

/// Of the edge at `coordinate` of an axis.
Edge edge_at(int axis, double coordinate, const Scene& scene, const Section& section)
{
    const double tolerance = 1e-9 * (section.upper - section.lower).maxCoeff();
    const auto on_edge = [&](const Vector2& p) { return std::abs(p[axis] - coordinate) <= tolerance; };
    const auto length_on_edge = [&](const Vector2& a, const Vector2& b) {
        return on_edge(a) && on_edge(b) ? (b - a).norm() : 0.0;
    };
    Edge edge;
    for (const Region& region : section.regions) {
        for (const Polygon& polygon : region.polygons) {
            for (std::size_t k = 0; k < polygon.outer.size(); ++k)
                edge.soil += length_on_edge(polygon.outer[k], polygon.outer[(k + 1) % polygon.outer.size()]);
        }
    }
    for (const NamedCurve& curve : section.curves) {
        const SoilCondition& soil = soil_at(scene, curve);
        for (const Segment& segment : curve.segments) {
            if (std::holds_alternative<FreeFace>(soil)) break;
            const double length = length_on_edge(segment.start, segment.end);
            edge.wall += length;
            edge.has_moving_wall = edge.has_moving_wall || (length > 0.0 && moves(soil));
            const bool upright = std::abs(segment.end[1 - axis] - segment.start[1 - axis]) <= tolerance;
            edge.meets_wall =
                edge.meets_wall || (!upright && (on_edge(segment.start) || on_edge(segment.end)));
        }
    }
    return edge;
}

/// Room beyond one side of the section [cells].
double room_beside(const Edge& edge, double cells_high)
{
    const bool closed = edge.soil > 0.0 && edge.wall >= (1.0 - on_grid_line) * edge.soil;
    if (closed) return edge.has_moving_wall ? least_room : 0.0;
    return std::max(least_room, std::ceil(room_to_flow * cells_high - on_grid_line));
}

struct Room {
    double left = 0.0, right = 0.0, below = 0.0, above = 0.0; // [cells]
};

/// Room for walls that go on beyond the soil, along which it may slide.
void make_room_for_walls(const Scene& scene, const Section& section, double h, Room& room)
{
    const auto reach = [h](double beyond, double& cells) {
        if (beyond > on_grid_line * h) cells = std::max(cells, std::ceil(beyond / h) + least_room);
    };
    for (const NamedCurve& curve : section.curves) {
        if (std::holds_alternative<FreeFace>(soil_at(scene, curve))) continue;
        for (const Segment& segment : curve.segments) {
            const Vector2 lower = segment.start.cwiseMin(segment.end);
            const Vector2 upper = segment.start.cwiseMax(segment.end);
            reach(section.lower.x() - lower.x(), room.left);
            reach(upper.x() - section.upper.x(), room.right);
            reach(section.lower.y() - lower.y(), room.below);
            reach(upper.y() - section.upper.y(), room.above);
        }
    }
}

Room find_room(const Scene& scene, const Section& section, double h)
{
    const double cells_high = (section.upper.y() - section.lower.y()) / h;
    Room room;
    room.left = room_beside(edge_at(0, section.lower.x(), scene, section), cells_high);
    room.right = room_beside(edge_at(0, section.upper.x(), scene, section), cells_high);
    const Edge base = edge_at(1, section.lower.y(), scene, section);
    room.below = !base.meets_wall || base.has_moving_wall ? least_room : 0.0;
    room.above =
        std::max(scene.cell_size > 0.0 ? 2.0 : least_room, std::ceil(room_above * cells_high - on_grid_line));
    make_room_for_walls(scene, section, h, room);
    return room;
}

/// The last grid line counted from `anchor` that lies `room` cells beyond `coordinate` or just farther [m].
double line_before(double coordinate, double anchor, double room, double h)
{
    return anchor - h * (std::ceil((anchor - coordinate) / h - on_grid_line) + room);
}

Vector2 choose_origin(const Scene& scene, const Section& section, const Room& room, double h)
{
    // cells that were counted by hand were counted from the section's corner
    const Room kept = scene.grid_cells ? Room{} : room;
    return {line_before(section.lower.x(), lines_across(0, scene, section).anchor, kept.left, h),
            line_before(section.lower.y(), lines_across(1, scene, section).anchor, kept.below, h)};
}

std::string describe_room(const Room& room)
{
    std::string text;
    const auto add = [&](double cells, const char* where) {
        if (cells > 0.0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", cells, where);
    };
    add(room.above, "cells above the soil");
    add(room.left, "beyond the left side");
    add(room.right, "beyond the right side");
    add(room.below, "below");
    return "room to move: " + text;
}

/// Warn of a drawing that is far larger than any section of soil, as one in millimetres is.
void doubt_size(const Scene& scene, const Section& section, Diagnostics& findings)
{
    constexpr double usual = 5000.0; // of width and height, at most [m]
    const Vector2 size = section.upper - section.lower;
    if (size.maxCoeff() <= usual) return;
    findings.add(warning_at(
        scene.geometry_place, "geometry.file", "plausibility",
        fmt::format("the drawing is {:.6g} m wide and {:.6g} m high", size.x(), size.y()),
        fmt::format("usually at most {:.0f} m", usual),
        "coordinates are in metres; Dilate {{0, 0, 0}, 0.001} {Surface{:};} turns millimetres into them"));
}

/// Material points that a lattice cuts from the section, about; 0 where a mesh does.
double count_points(const Scene& scene, const Section& section, double h)
{
    const auto* lattice = std::get_if<LatticeSampling>(&scene.sampling);
    if (lattice == nullptr) return 0.0;
    double soil = 0.0; // [m2]
    for (const Region& region : section.regions) soil += area(region);
    return soil / (h * h) * lattice->per_cell_x * lattice->per_cell_y;
}

/// Find cells that are larger than the section, and so small that the machine cannot hold the soil: before
/// anything is made of them.
void doubt_cells(const Scene& scene, const Section& section, double h, Diagnostics& findings)
{
    constexpr double rounding = 1.0 + 1e-9, bytes = 700.0; // of a point; solver/PERFORMANCE.md
    const Vector2 size = section.upper - section.lower;
    if (size.maxCoeff() * rounding < h)
        findings.add(
            error_at(scene.grid_place, "range",
                     fmt::format("the section, {:.4g} m wide and {:.4g} m high, is smaller than a cell "
                                 "of {:.4g} m",
                                 size.x(), size.y(), h),
                     "a width or height of a cell at least", "give a smaller grid.cell_size"));
    const double points = count_points(scene, section, h);
    const double memory =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE)); // [B]
    if (points * bytes > memory)
        findings.add(error_at(
            scene.grid_place, "range",
            fmt::format("some {:.2g} material points need {:.2g} GB of memory, and this machine has {:.2g}",
                        points, 1e-9 * points * bytes, 1e-9 * memory),
            "",
            "a larger cell_size or fewer particles_per_cell; are cell_size and the drawing both in metres?"));
}

} // namespace

std::optional<GridChoice> choose_grid(const Scene& scene, const Section& section, Diagnostics& findings)
{
    doubt_size(scene, section, findings);
    GridChoice choice;
    double h = scene.cell_size;
    if (!(h > 0.0)) {
        CellSize cells = choose_cell_size(scene, section);
        h = cells.size;
        if (cells.is_bounded)
            findings.add(warning_at(scene.grid_place, "grid.cell_size", "grid",
                                    fmt::format("cells of {:.4g} m are coarse: {}", h, cells.reasons.front()),
                                    "", "give a smaller grid.cell_size if run time does not matter"));
        choice.reasons = std::move(cells.reasons);
    }
    const Room room = find_room(scene, section, h);
    const Vector2 origin = scene.grid_origin.value_or(choose_origin(scene, section, room, h));
    const Vector2 covered = section.upper - origin;
    double cells_x = std::max(1.0, std::ceil(covered.x() / h - on_grid_line)) + room.right;
    double cells_y = std::max(1.0, std::ceil(covered.y() / h - on_grid_line)) + room.above;
    if (scene.grid_cells) {
        cells_x = scene.grid_cells->first;
        cells_y = scene.grid_cells->second;
    } else {
        choice.reasons.push_back(describe_room(room));
    }
    if (!(cells_x * cells_y <= most_cells)) {
        findings.add(
            error_at(scene.grid_place, "range",
                     "the grid has " + number_text(cells_x) + " x " + number_text(cells_y) + " cells",
                     "at most " + number_text(most_cells) + " cells",
                     "are cell_size and the drawing both in metres?"));
        return std::nullopt;
    }
    doubt_cells(scene, section, h, findings);
    choice.grid = BackgroundGrid{origin, h, static_cast<int>(cells_x), static_cast<int>(cells_y)};
    return choice;
}

} // namespace quicksand
