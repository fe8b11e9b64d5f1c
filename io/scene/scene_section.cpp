#include "io/scene/scene_section.hpp"

#include "geometry/drawing/nearest_name.hpp"
#include "geometry/section/region_locator.hpp"
#include "io/keys/scene_schema.hpp"
#include "io/keys/scene_units.hpp"
#include "io/keys/scene_value_reader.hpp"
#include "io/keys/scene_words.hpp"
#include "io/scene/cell_size.hpp"
#include "solver/problem/base_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace quicksand {

namespace {

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& list)
{
    std::vector<std::string> names;
    for (const Named& item : list) names.push_back(item.name);
    return names;
}

std::vector<std::string> names_of(const std::vector<SceneBoundary>& list)
{
    std::vector<std::string> names;
    for (const SceneBoundary& item : list) names.push_back(item.boundary.name);
    return names;
}

/// An error for a name that the drawing does not know.
Diagnostic unknown_name(const SourcePlace& place, const std::string& what, const std::string& name,
                        const std::vector<std::string>& drawn)
{
    const std::string nearest = nearest_name(name, drawn);
    return error_at(place, "unknown-group", "the drawing has no " + what + " \"" + name + "\"",
                    drawn.empty() ? "the drawing has no " + what + " at all" : one_of(drawn),
                    nearest.empty() ? "" : "did you mean \"" + nearest + "\"?");
}

void check_regions(const Scene& scene, const std::vector<std::string>& drawn, Diagnostics& findings)
{
    const auto written = names_of(scene.regions);
    for (const SceneRegion& region : scene.regions) {
        if (!contains(drawn, region.name))
            findings.add(unknown_name(region.place, "physical surface", region.name, drawn));
    }
    for (const std::string& name : drawn) {
        if (contains(written, name)) continue;
        findings.add(error_at(scene.geometry_place, "missing-table",
                              "the drawing's physical surface \"" + name + "\" has no material", "",
                              "add a table [" + join_path({"regions", name}) + "] with a material"));
    }
}

const NamedCurve* find_curve(const Section& section, const std::string& name)
{
    for (const NamedCurve& curve : section.curves) {
        if (curve.name == name) return &curve;
    }
    return nullptr;
}

/// How far a coordinate is from the nearest grid line [m].
double offset_from_line(double coordinate, double origin, double cell_size)
{
    const double cells = (coordinate - origin) / cell_size;
    return (cells - std::round(cells)) * cell_size;
}

/// A viscous side of a shaken section absorbs the motion of the ground itself.
void check_viscous_side(const Scene& scene, const SceneBoundary& condition, const NamedCurve& curve,
                        Diagnostics& findings)
{
    const Boundary& boundary = condition.boundary;
    if (!std::holds_alternative<ViscousFace>(boundary.soil) ||
        std::holds_alternative<NoMotion>(scene.base_motion))
        return;
    const bool steep = std::any_of(curve.segments.begin(), curve.segments.end(), [](const Segment& segment) {
        const Vector2 along = (segment.end - segment.start).cwiseAbs();
        return along.y() > along.x();
    });
    if (!steep) return;
    findings.add(warning_at(condition.place, join_path({"boundaries", boundary.name}), "viscous-side",
                            "the viscous side \"" + boundary.name +
                                "\" damps the shaking of the ground itself, not only the outgoing waves",
                            "sides tied to each other, or free_field sides, where the base shakes"));
}

constexpr double long_time = 60.0; // after the shaking, in which dashpots let soil creep away [s]

/// What lets waves out bears no force for long.
void check_long_absorption(const Scene& scene, const SceneBoundary& condition, Diagnostics& findings)
{
    const bool runs = !scene.stage || scene.stage->kind == StageKind::shake;
    const double after = scene.end_time - duration(scene.base_motion);
    if (!runs || !lets_go(condition.boundary.soil) || !(after > long_time)) return;
    findings.add(warning_at(
        condition.place, join_path({"boundaries", condition.boundary.name}), "long-absorption",
        "the curve \"" + condition.boundary.name + "\" lets waves out, and the run goes on for " +
            time_text(after) + " after the shaking: dashpots bear no force for long, the soil creeps away",
        "a stage of kind = \"consolidate\" for what follows the shaking: it holds the curve"));
}

/// The boundary along a curve.
Boundary drawn_along(const NamedCurve& curve, Boundary boundary)
{
    boundary.name = curve.name;
    for (const Segment& segment : curve.segments) {
        if (segment.start != segment.end) boundary.segments.push_back(segment);
    }
    return boundary;
}

/// The ends of a segment, whichever way it goes.
using Ends = std::array<double, 4>;

Ends ends_of(const Segment& segment)
{
    const Vector2 &a = segment.start, &b = segment.end;
    const bool turned = std::pair(b.x(), b.y()) < std::pair(a.x(), a.y());
    return turned ? Ends{b.x(), b.y(), a.x(), a.y()} : Ends{a.x(), a.y(), b.x(), b.y()};
}

/// The curves with a table that own segments; an error where two of them own one, which has one condition.
std::map<Ends, const NamedCurve*> owners_of_segments(const Scene& scene, const Section& section,
                                                     Diagnostics& findings)
{
    std::map<Ends, const NamedCurve*> owners;
    for (const SceneBoundary& condition : scene.boundaries) {
        const NamedCurve* curve = find_curve(section, condition.boundary.name);
        if (curve == nullptr) continue;
        const NamedCurve* other = nullptr;
        for (const Segment& segment : curve->segments) {
            const auto [owner, is_new] = owners.emplace(ends_of(segment), curve);
            if (is_new || owner->second == curve || owner->second == other) continue;
            other = owner->second;
            findings.add(error_at(
                condition.place, "shared-curve",
                fmt::format(
                    "\"{}\" and \"{}\" are the same line from ({:.5g}, {:.5g}) to ({:.5g}, {:.5g}) m, "
                    "and both have conditions",
                    other->name, curve->name, segment.start.x(), segment.start.y(), segment.end.x(),
                    segment.end.y()),
                "each line in one physical curve with a table",
                "take it out of one of the physical curves, or remove one of the tables"));
        }
    }
    return owners;
}

/// The parts of a curve that begin at the same x, as one curve may be both sides.
std::vector<NamedCurve> by_place(const NamedCurve& curve, double tolerance)
{
    std::vector<NamedCurve> parts;
    for (const Segment& segment : curve.segments) {
        auto part = std::find_if(parts.begin(), parts.end(), [&](const NamedCurve& other) {
            return std::abs(other.segments.front().start.x() - segment.start.x()) <= tolerance;
        });
        if (part == parts.end()) part = parts.insert(part, NamedCurve{curve.name, {}});
        part->segments.push_back(segment);
    }
    return parts;
}

/// Whether a free-field side may have the water: the flow between heads is computed with that of the ground
/// beyond, all else goes on with its column.
bool may_have(const WaterCondition& water, bool flow_is_computed)
{
    if (std::holds_alternative<Drained>(water)) return true;
    const auto* given = std::get_if<PrescribedWater>(&water);
    return flow_is_computed && given != nullptr && std::holds_alternative<WaterHead>(given->value);
}

/// A pressure presses onto the soil, of which a curve within soil has two.
void check_pressed_side(const RegionLocator& soil, const SceneBoundary& condition, const NamedCurve& curve,
                        Diagnostics& findings)
{
    const auto* face = std::get_if<FreeFace>(&condition.boundary.soil);
    if (face == nullptr || !face->load || face->load->pressure == 0.0) return;
    for (const Segment& segment : curve.segments) {
        const auto [left, right] = regions_beside(soil, segment);
        if (!left || !right) continue;
        const Vector2 middle = 0.5 * (segment.start + segment.end);
        findings.add(error_at(
            condition.place, "pressed-side",
            fmt::format(
                "the pressure on \"{}\" has soil on both sides at ({:.5g}, {:.5g}) m: it has no side to "
                "press onto",
                curve.name, middle.x(), middle.y()),
            "a pressure on curves with soil on one side",
            "a load within the soil is a traction = [x, y], positive to the right and upward; a stage that "
            "buries the curve may give it so in its own table"));
        return;
    }
}

} // namespace

std::optional<UprightSide> find_upright_side(const SceneBoundary& boundary, const NamedCurve& curve,
                                             const BackgroundGrid& grid, const std::string& kind,
                                             Diagnostics& findings)
{
    const double tolerance = on_grid_line * grid.cell_size,
                 infinite = std::numeric_limits<double>::infinity();
    const std::string name = "the " + kind + " curve \"" + curve.name + "\"";
    UprightSide side{0.0, infinite, -infinite};
    bool vertical = !curve.segments.empty();
    if (vertical) side.x = curve.segments.front().start.x();
    for (const Segment& segment : curve.segments) {
        for (const Vector2& point : {segment.start, segment.end}) {
            vertical = vertical && std::abs(point.x() - side.x) <= tolerance;
            side.lower = std::min(side.lower, point.y());
            side.upper = std::max(side.upper, point.y());
        }
    }
    if (!vertical) {
        findings.add(error_at(boundary.place, kind, name + " is not a vertical line",
                              "a vertical straight line on a grid line"));
        return std::nullopt;
    }
    const double offset = offset_from_line(side.x, grid.origin.x(), grid.cell_size);
    if (std::abs(offset) <= tolerance) return side;
    findings.add(
        error_at(boundary.place, kind,
                 name + " at x = " + number_text(side.x) +
                     " m is not on a grid line: the nearest is at x = " + six_digits(side.x - offset) + " m",
                 "a vertical straight line on a grid line",
                 "choose a cell size that divides the width, or set origin in [grid]"));
    return std::nullopt;
}

/// A surface that was forgotten would leave a void.
void check_nameless(const Scene& scene, const Section& section, Diagnostics& findings)
{
    if (section.nameless.empty()) return;
    std::string places;
    for (const Box& box : section.nameless)
        places += fmt::format("{} between {} and {}", places.empty() ? "" : ",", place_text(box.lower),
                              place_text(box.upper));
    findings.add(warning_at(scene.geometry_place, "geometry.file", "nameless-surface",
                            "surfaces in no physical surface are left out, there is no soil:" + places, "",
                            "name them, as Physical Surface(\"sand\") = {...}; or delete them"));
}

void check_names(const Scene& scene, const Section& section, Diagnostics& findings)
{
    check_nameless(scene, section, findings);
    const auto curves = names_of(section.curves), points = names_of(section.points);
    check_regions(scene, names_of(section.regions), findings);
    for (const SceneBoundary& boundary : scene.boundaries) {
        const std::string& name = boundary.boundary.name;
        if (!contains(curves, name))
            findings.add(unknown_name(boundary.place, "physical curve", name, curves));
    }
    for (const SceneProbe& probe : scene.probes) {
        if (probe.at || contains(points, probe.name)) continue;
        Diagnostic finding = unknown_name(probe.place, "physical point", probe.name, points);
        finding.what = "the probe \"" + probe.name + "\" has no place: " + finding.what;
        if (finding.hint.empty())
            finding.hint = "give the probe at = [x, y], or name a physical point after it";
        findings.add(std::move(finding));
    }
}

std::vector<Boundary> find_boundaries(const Scene& scene, const Section& section, Diagnostics& findings)
{
    std::vector<Boundary> boundaries;
    const RegionLocator soil(section);
    for (const SceneBoundary& condition : scene.boundaries) {
        const NamedCurve* curve = find_curve(section, condition.boundary.name);
        if (curve == nullptr) continue;
        boundaries.push_back(drawn_along(*curve, condition.boundary));
        check_pressed_side(soil, condition, *curve, findings);
        check_viscous_side(scene, condition, *curve, findings);
        check_long_absorption(scene, condition, findings);
    }
    const auto owners = owners_of_segments(scene, section, findings);
    const auto written = names_of(scene.boundaries);
    for (NamedCurve curve : section.curves) {
        if (contains(written, curve.name)) continue;
        std::erase_if(curve.segments,
                      [&](const Segment& segment) { return owners.contains(ends_of(segment)); });
        if (curve.segments.empty()) continue; // a name for lines that have their conditions
        boundaries.push_back(drawn_along(curve, {}));
        const std::string path = join_path({"boundaries", curve.name});
        findings.add(
            warning_at(scene.geometry_place, path, "unnamed-boundary",
                       "the physical curve \"" + curve.name + "\" has no conditions: it is free and drained",
                       "", "say so with a table [" + path + "] and soil = \"free\""));
    }
    return boundaries;
}

void check_free_field_sides(const Scene& scene, const Section& section, const BackgroundGrid& grid,
                            Diagnostics& findings)
{
    const auto is_tied = [](const SceneBoundary& condition) {
        return std::holds_alternative<TiedSide>(condition.boundary.soil);
    };
    const bool any_tied = std::any_of(scene.boundaries.begin(), scene.boundaries.end(), is_tied);
    for (const SceneBoundary& condition : scene.boundaries) {
        const Boundary& boundary = condition.boundary;
        const NamedCurve* curve = find_curve(section, boundary.name);
        if (!std::holds_alternative<FreeFieldSide>(boundary.soil) || curve == nullptr) continue;
        for (const NamedCurve& side : by_place(*curve, on_grid_line * grid.cell_size))
            find_upright_side(condition, side, grid, "free-field", findings);
        if (any_tied)
            findings.add(
                error_at(condition.place, "free-field",
                         "the scene has the free-field side \"" + boundary.name + "\" and tied sides",
                         "sides of one of the two kinds",
                         "where the ground of both sides differs, both are free_field"));
        if (scene.water && !may_have(boundary.water, scene.starts_seeping))
            findings.add(error_at(condition.place, "free-field",
                                  "the free-field side \"" + boundary.name +
                                      "\" has a condition of its own for the water",
                                  "water = \"drained\", or none; in a computed flow a head as well",
                                  "water passes the side, with the pore pressure of the ground beyond it"));
    }
}

std::optional<TiedSides> find_tied_sides(const Scene& scene, const Section& section,
                                         const BackgroundGrid& grid, Diagnostics& findings)
{
    std::vector<const SceneBoundary*> tied;
    for (const SceneBoundary& boundary : scene.boundaries) {
        if (std::holds_alternative<TiedSide>(boundary.boundary.soil)) tied.push_back(&boundary);
    }
    if (tied.size() != 2) return std::nullopt;
    const std::string &first_name = tied[0]->boundary.name, &second_name = tied[1]->boundary.name;
    const NamedCurve* first_curve = find_curve(section, first_name);
    const NamedCurve* second_curve = find_curve(section, second_name);
    if (first_curve == nullptr || second_curve == nullptr) return std::nullopt;
    const auto first = find_upright_side(*tied[0], *first_curve, grid, "tied", findings);
    const auto second = find_upright_side(*tied[1], *second_curve, grid, "tied", findings);
    if (!first || !second) return std::nullopt;

    const auto refuse = [&](const std::string& what, const std::string& expected) {
        findings.add(error_at(tied[1]->place, "tied",
                              "the tied curves \"" + first_name + "\" and \"" + second_name + "\" " + what,
                              expected));
        return std::nullopt;
    };
    const double tolerance = on_grid_line * grid.cell_size;
    if (std::abs(first->lower - second->lower) > tolerance ||
        std::abs(first->upper - second->upper) > tolerance) {
        return refuse("reach from y = " + number_text(first->lower) + " to " + number_text(first->upper) +
                          " m and from " + number_text(second->lower) + " to " + number_text(second->upper) +
                          " m",
                      "two vertical lines of the same heights");
    }
    if (std::abs(first->x - second->x) <= tolerance) {
        return refuse("are at the same x = " + number_text(first->x) + " m", "two opposite sides");
    }
    const bool ordered = first->x < second->x;
    const auto& left = ordered ? *first : *second;
    const auto& right = ordered ? *second : *first;
    return TiedSides{ordered ? first_name : second_name, ordered ? second_name : first_name, left.x, right.x};
}

} // namespace quicksand
