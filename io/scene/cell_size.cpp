#include "io/scene/cell_size.hpp"

#include "io/keys/scene_schema.hpp"
#include "io/tables/scene_boundaries.hpp"
#include "solver/problem/motion_measures.hpp"
#include "solver/step_length/time_step_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

constexpr double cells_through_body = 16.0, cells_per_wave = 10.0;
constexpr double most_particles = 1e5;
constexpr double largest_change = 1.15, smallest_change = 0.8; // of the size, to meet lines [-]
constexpr double flat = 1e-9; // of the section's size: how little a straight line along the grid rises

double extent(const Section& section)
{
    return (section.upper - section.lower).maxCoeff();
}

/// The smaller of a body's mean thicknesses along y and along x [m].
double thickness(double area, const Vector2& lower, const Vector2& upper)
{
    return std::min(area / (upper.x() - lower.x()), area / (upper.y() - lower.y()));
}

double thickness(const Polygon& polygon)
{
    Section alone;
    alone.regions = {{"", {polygon}}};
    bound_section(alone);
    return thickness(area(alone.regions[0]), alone.lower, alone.upper);
}

/// Of the thickest of its parts [m].
double thickness(const Region& region)
{
    double most = 0.0;
    for (const Polygon& polygon : region.polygons) most = std::max(most, thickness(polygon));
    return most;
}

/// A length that the cells should resolve, in so many of them.
struct Demand {
    double length = 0.0; // [m]
    double cells = 1.0;
    std::string what;
    double size() const { return length / cells; }
};

std::vector<Demand> demands(const Scene& scene, const Section& section)
{
    std::vector<Demand> list;
    double whole = 0.0;
    for (const Region& region : section.regions) {
        whole += area(region);
        const double through = thickness(region);
        list.push_back({through, cells_through_layer,
                        fmt::format("through the region \"{}\", {:.3g} m thick", region.name, through)});
    }
    const double body = thickness(whole, section.lower, section.upper);
    list.push_back({body, cells_through_body, fmt::format("through all of the soil, {:.3g} m", body)});
    const double frequency = highest_frequency(scene.base_motion);
    for (const SceneMaterial& soil : scene.materials) {
        if (frequency <= 0.0) break;
        const double speed = wave_speeds(soil.material, scene.water, soil.material.porosity).shear;
        list.push_back({speed / frequency, cells_per_wave,
                        fmt::format("along a shear wave of {:.3g} Hz in \"{}\", {:.3g} m/s", frequency,
                                    soil.material.name, speed)});
    }
    return list;
}

double particles_per_cell(const Scene& scene)
{
    const auto* lattice = std::get_if<LatticeSampling>(&scene.sampling);
    return lattice != nullptr ? static_cast<double>(lattice->per_cell_x * lattice->per_cell_y) : 9.0;
}

bool meets_line(double coordinate, double anchor, double h)
{
    const double cells = (coordinate - anchor) / h;
    return std::abs(cells - std::round(cells)) <= on_grid_line * std::max(1.0, std::abs(cells));
}

/// Sum of the weights of the places on grid lines.
double score(const std::vector<LineUp>& lines, double h)
{
    double sum = 0.0;
    for (const LineUp& axis : lines) {
        for (const LineUp::Place& place : axis.places)
            sum += meets_line(place.coordinate, axis.anchor, h) ? place.weight : 0.0;
    }
    return sum;
}

/// The size near `wanted` and not below `least` with most on lines, the nearest to `wanted` of these.
double size_on_lines(const std::vector<LineUp>& lines, double wanted, double least)
{
    constexpr double rounding = 1e-9;
    double best = wanted, best_score = score(lines, wanted), best_change = 0.0;
    for (const LineUp& axis : lines) {
        for (const LineUp::Place& place : axis.places) {
            const double distance = std::abs(place.coordinate - axis.anchor);
            const double fewest = std::ceil(distance / (largest_change * wanted) - rounding),
                         most = std::floor(distance / std::max(least, smallest_change * wanted) + rounding);
            for (double cells = std::max(1.0, fewest); cells <= most; cells += 1.0) {
                const double h = distance / cells, change = std::abs(std::log(h / wanted));
                const double reached = score(lines, h);
                const bool better = reached > best_score + rounding ||
                                    (reached > best_score - rounding && change < best_change - rounding);
                if (!better) continue;
                best = h;
                best_score = reached;
                best_change = change;
            }
        }
    }
    return best;
}

/// Runs along the axis, 0 for a vertical line.
bool is_along(const Segment& segment, int axis, const Section& section)
{
    const Vector2 along = (segment.end - segment.start).cwiseAbs();
    return along[axis] <= flat * extent(section) && along[1 - axis] > flat * extent(section);
}

constexpr double weight_of_edge = 1.0;

/// Weights that put walls first, and among them those that must lie on lines.
double weight_of(const SoilCondition& wall)
{
    return lies_in_soil(wall) || lets_go(wall) ? 1e4 : 1e2;
}

/// Keep the heavier of two places at one coordinate.
void add_place(double coordinate, double weight, double tolerance, LineUp& lines)
{
    for (LineUp::Place& place : lines.places) {
        if (std::abs(place.coordinate - coordinate) > tolerance) continue;
        place.weight = std::max(place.weight, weight);
        return;
    }
    lines.places.push_back({coordinate, weight});
}

void add_flat_edges(int axis, const Section& section, LineUp& lines)
{
    const auto add_ring = [&](const Ring& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Segment edge{ring[k], ring[(k + 1) % ring.size()]};
            if (is_along(edge, axis, section))
                add_place(edge.start[axis], weight_of_edge, flat * extent(section), lines);
        }
    };
    for (const Region& region : section.regions) {
        for (const Polygon& polygon : region.polygons) {
            add_ring(polygon.outer);
            for (const Ring& hole : polygon.holes) add_ring(hole);
        }
    }
}

} // namespace

const SoilCondition& soil_at(const Scene& scene, const NamedCurve& curve)
{
    static const SoilCondition free = FreeFace{};
    const SceneBoundary* found = find_boundary(scene, curve.name);
    return found == nullptr ? free : found->boundary.soil;
}

LineUp lines_across(int axis, const Scene& scene, const Section& section)
{
    LineUp lines;
    double first_wall = std::numeric_limits<double>::infinity();
    for (const NamedCurve& curve : section.curves) {
        const SoilCondition& soil = soil_at(scene, curve);
        if (std::holds_alternative<FreeFace>(soil)) continue;
        for (const Segment& segment : curve.segments) {
            if (!is_along(segment, axis, section)) continue;
            first_wall = std::min(first_wall, segment.start[axis]);
            add_place(segment.start[axis], weight_of(soil), flat * extent(section), lines);
        }
    }
    add_flat_edges(axis, section, lines);
    lines.anchor = std::isfinite(first_wall) ? first_wall : section.lower[axis];
    return lines;
}

CellSize choose_cell_size(const Scene& scene, const Section& section)
{
    const std::vector<Demand> all = demands(scene, section);
    const Demand& finest = *std::min_element(
        all.begin(), all.end(), [](const Demand& a, const Demand& b) { return a.size() < b.size(); });
    double whole = 0.0;
    for (const Region& region : section.regions) whole += area(region);
    const double least = std::sqrt(whole * particles_per_cell(scene) / most_particles);
    CellSize chosen;
    chosen.is_bounded = finest.size() < least;
    const double wanted = std::max(finest.size(), least);
    const std::vector<LineUp> lines = {lines_across(0, scene, section), lines_across(1, scene, section)};
    chosen.size = size_on_lines(lines, wanted, smallest_change * least);
    chosen.reasons.push_back(fmt::format("{:.3g} cells {}", finest.length / chosen.size, finest.what) +
                             (chosen.is_bounded
                                  ? fmt::format(", where {:.3g} would do: not more than {:.0f} particles",
                                                finest.cells, most_particles)
                                  : ""));
    if (chosen.size != wanted)
        chosen.reasons.push_back(fmt::format(
            "{:.4g} m instead of {:.4g}, for walls or edges to lie on grid lines", chosen.size, wanted));
    return chosen;
}

} // namespace quicksand
