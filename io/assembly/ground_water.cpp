#include "io/assembly/ground_water.hpp"

#include "io/keys/scene_schema.hpp"
#include "io/keys/scene_units.hpp"
#include "io/tables/scene_boundaries.hpp"
#include "solver/base/failure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quicksand {

namespace {

/// The soil above the line: grains and the water they hold move as one, so their density is that of both.
Material unsaturated(const Material& material, const Water& water, double saturation)
{
    Material above = material;
    above.name += " above the water";
    above.saturated = false;
    above.grain_density += saturation * material.porosity * water.density / (1.0 - material.porosity);
    hold_water(above.law, material.grain_density / above.grain_density);
    return above;
}

/// Weight of a soil per volume as its grains carry it, buoyant where it is saturated [N/m3].
double carried_weight(const Material& material, const Problem& problem)
{
    const double displaced = water_of(problem, material) ? problem.water->density : 0.0;
    return (1.0 - material.porosity) * (material.grain_density - displaced) * problem.gravity;
}

struct UnitWeights {
    double below = 0.0, above = 0.0; // the phreatic line [N/m3]
};

std::vector<UnitWeights> unit_weights(const Scene& scene, const std::vector<std::int32_t>& of_region,
                                      const Problem& problem)
{
    std::vector<UnitWeights> weights;
    for (const std::int32_t m : of_region) {
        const auto index = static_cast<std::size_t>(m);
        const Material& material = problem.materials[index];
        UnitWeights weight;
        weight.below = weight.above = carried_weight(material, problem);
        if (problem.water) {
            const double saturation = scene.materials[index].saturation_above_water;
            weight.above = carried_weight(unsaturated(material, *problem.water, saturation), problem);
        }
        weights.push_back(weight);
    }
    return weights;
}

/// sigma'_v at a point: total stress less pore pressure, both hydrostatic below the line at this x [Pa].
double vertical_effective_stress(const Section& section, const std::vector<UnitWeights>& weights,
                                 const Vector2& point, double line)
{
    const auto all = thickness_above(section, point);
    const auto dry = thickness_above(section, {point.x(), std::max(point.y(), line)});
    double stress = 0.0;
    for (std::size_t r = 0; r < all.size(); ++r)
        stress += (all[r] - dry[r]) * weights[r].below + dry[r] * weights[r].above;
    return stress;
}

/// Water that flows upward carries soil, but for a rest of this part of sigma'_v in still water: stresses
/// across the columns, which this estimate does not know, keep it in place [-].
constexpr double least_carried = 0.05;

/// sigma'_v where the water's pressure is not that of its depth below the line [Pa].
double less_flow_pressure(double vertical, double flow_pressure)
{
    return flow_pressure == 0.0 ? vertical : std::max(vertical - flow_pressure, least_carried * vertical);
}

bool differs_from_still_water(const Problem& problem, const Boundary& boundary)
{
    return std::any_of(boundary.segments.begin(), boundary.segments.end(), [&](const Segment& segment) {
        return outer_excess_pressure(problem, boundary, segment.start) != 0.0 ||
               outer_excess_pressure(problem, boundary, segment.end) != 0.0;
    });
}

/// Give the points of a line within a distance of x their mean height.
void level_beside(double x, double distance, std::vector<Vector2>& points)
{
    constexpr double rounding = 1e-6; // of the distance
    const auto is_beside = [&](const Vector2& point) {
        return std::abs(point.x() - x) < (1.0 + rounding) * distance;
    };
    double sum = 0.0, count = 0.0;
    for (const Vector2& point : points) {
        if (!is_beside(point)) continue;
        sum += point.y();
        count += 1.0;
    }
    for (Vector2& point : points)
        if (is_beside(point)) point.y() = sum / count;
}

} // namespace

double phreatic_elevation(const Scene& scene, double x)
{
    return scene.phreatic_line.empty() ? scene.water->level : elevation(scene.phreatic_line, x);
}

std::optional<WaterLine> line_of_flow(const FlowField& flow, const Problem& problem, int per_cell_x)
{
    const BackgroundGrid& grid = problem.grid;
    WaterLine line;
    for (int i = 0; i <= grid.cells_x * per_cell_x; ++i) {
        const double x = grid.origin.x() + grid.cell_size * i / per_cell_x;
        if (const std::optional<double> surface = flow.surface(x)) line.points.emplace_back(x, *surface);
    }
    for (const Boundary& boundary : problem.boundaries)
        if (std::holds_alternative<FreeFieldSide>(boundary.soil))
            for (const Segment& segment : boundary.segments)
                level_beside(segment.start.x(), grid.cell_size, line.points);
    return line.points.empty() ? std::nullopt : std::optional(line);
}

double GroundWater::head(const Vector2& point) const
{
    if (flow == nullptr) return phreatic_elevation(scene, point.x());
    return std::max(scene.water->level, flow->head(point)); // but for rounding, no water stands below it
}

double GroundWater::surface(double x) const
{
    if (flow == nullptr) return phreatic_elevation(scene, x);
    return std::max(scene.water->level, flow->surface(x).value_or(scene.water->level));
}

bool GroundWater::saturates(const Vector2& point, double tolerance) const
{
    // soil through which water only falls has no pressure, and a head of its own height
    if (flow != nullptr && point.y() > scene.water->level) return point.y() < head(point) - tolerance;
    return point.y() <= head(point) + tolerance;
}

void check_phreatic_line(const Scene& scene, Diagnostics& findings)
{
    const std::vector<Vector2>& line = scene.phreatic_line;
    if (!scene.water || line.empty()) return;
    const auto refuse = [&](const std::string& what, const std::string& expected, const std::string& hint) {
        findings.add(error_at(scene.phreatic_place, "phreatic-line", what, expected, hint));
    };
    if (scene.starts_seeping) {
        refuse("water.phreatic_line is given, and water.initial_flow = \"seepage\" computes it",
               "one of both", "remove the line, or set initial_flow = \"still\"");
        return;
    }
    for (std::size_t k = 0; k < line.size(); ++k) {
        const std::string point = "[" + number_text(line[k].x()) + ", " + number_text(line[k].y()) + "]";
        if (k > 0 && line[k].x() <= line[k - 1].x()) {
            refuse("the point " + point + " of the phreatic line does not lie to the right of the one before",
                   "points from left to right", "");
            return;
        }
        if (line[k].y() < scene.water->level) {
            refuse("the point " + point + " of the phreatic line lies below the water level " +
                       number_text(scene.water->level) + " m",
                   "points at the water level or above", "let level be that of the lowest still water");
            return;
        }
    }
}

void divide_materials(const Scene& scene, const FlowField* flow, const std::vector<const FlowField*>& earlier,
                      const Sampling& sampling, std::vector<std::int32_t>& of_domain, Problem& problem)
{
    if (!problem.water) return;
    const bool flows = flow != nullptr || !earlier.empty();
    std::vector<std::int32_t> above(problem.materials.size(), -1); // material -> its like above the line
    for (std::size_t p = 0; p < sampling.domains.size(); ++p) {
        const ParticleDomain& domain = sampling.domains[p];
        const double tolerance = 1e-9 * problem.grid.cell_size, y = domain.centre.y();
        const auto is_wet_by = [&](const FlowField* water) {
            return GroundWater{scene, water}.saturates(domain.centre, tolerance);
        };
        if (is_wet_by(flow) || std::any_of(earlier.begin(), earlier.end(), is_wet_by)) {
            problem.water->rises_above_level =
                problem.water->rises_above_level || flows || y > problem.water->level + tolerance;
            continue;
        }
        const auto m = static_cast<std::size_t>(of_domain[p]);
        if (above[m] < 0) {
            above[m] = static_cast<std::int32_t>(problem.materials.size());
            Material dry =
                unsaturated(problem.materials[m], *problem.water, scene.materials[m].saturation_above_water);
            dry.part_of = m;
            problem.materials.push_back(std::move(dry));
        }
        of_domain[p] = above[m];
    }
}

void check_outer_water(const Scene& scene, const Problem& problem, Diagnostics& findings)
{
    if (water_flow(problem) != WaterFlow::drained || problem.water->rises_above_level) return;
    for (const Boundary& boundary : problem.boundaries) {
        const auto* water = std::get_if<PrescribedWater>(&boundary.water);
        if (water == nullptr || !differs_from_still_water(problem, boundary)) continue;
        const SceneBoundary* written = find_boundary(scene, boundary.name);
        ENSURE(written != nullptr);
        const bool head = std::holds_alternative<WaterHead>(water->value);
        findings.add(error_at(
            written->water_place, "boundary",
            join_path({"boundaries", boundary.name, head ? "head" : "pore_pressure"}) +
                " has no effect with water.flow = \"drained\": the pores have the pressure of the still "
                "water",
            "still water at the level " + number_text(problem.water->level) +
                " m beyond the curve, or water.flow = \"coupled\" or \"undrained\"",
            "water that stands in the soil is water.phreatic_line; a load is pressure on a free curve"));
    }
}

void set_initial_state(const Scene& scene, const FlowField* flow, const Section& section,
                       const std::vector<std::int32_t>& of_region, const Problem& problem,
                       Particles& particles)
{
    const GroundWater ground{scene, flow};
    const std::vector<UnitWeights> weights = unit_weights(scene, of_region, problem);
    const auto count = static_cast<std::ptrdiff_t>(particles.size());
#pragma omp parallel for schedule(static)
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        const auto p = static_cast<std::size_t>(k);
        const Vector2 point = particles.position[p];
        const double line = problem.water ? ground.surface(point.x()) : point.y();
        const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
        const bool wet = problem.water && is_wet(material);
        const double head = wet ? ground.head(point) : line;
        const double pressure = wet ? pressure_below(problem, head, point.y()) : 0.0;
        if (bears_stress_as_drawn(material.law)) {
            const double at_rest = wet ? pressure_below(problem, line, point.y()) : 0.0;
            const double vertical = less_flow_pressure(
                vertical_effective_stress(section, weights, point, line), pressure - at_rest);
            particles.stress.yy[p] = -vertical;
            particles.stress.xx[p] = particles.stress.zz[p] = -scene.k0 * vertical;
        }
        if (particles.pore_pressure.empty() || !wet) continue; // drained, or dry
        if (!particles.water_table.empty()) particles.water_table[p] = head;
        particles.pore_pressure[p] =
            pressure - static_water_pressure(problem, point.y()) + scene.excess_pore_pressure;
    }
}

} // namespace quicksand
