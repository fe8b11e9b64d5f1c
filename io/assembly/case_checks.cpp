#include "io/assembly/case_checks.hpp"

#include "geometry/drawing/gmsh_file.hpp"
#include "geometry/section/present_section.hpp"
#include "geometry/section/section_check.hpp"
#include "geometry/section/section_rim.hpp"
#include "io/assembly/face_water.hpp"
#include "io/assembly/ground_water.hpp"
#include "io/assembly/present_soil.hpp"
#include "io/assembly/thin_gaps.hpp"
#include "io/assembly/thin_layers.hpp"
#include "io/keys/scene_schema.hpp"
#include "io/scene/cell_size.hpp"
#include "io/scene/scene_grid.hpp"
#include "io/scene/scene_section.hpp"
#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/problem/motion_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace quicksand {

namespace {

constexpr double curve_tolerance = 0.01; // greatest distance of a curved line from its chords [cells]

GmshRequest request_of(const Scene& scene)
{
    GmshRequest request;
    request.file = scene.geometry_file;
    request.parameters = scene.geometry_parameters;
    if (const auto* mesh = std::get_if<MeshSampling>(&scene.sampling)) request.quad_size = mesh->quad_size;
    request.curve_tolerance = curve_tolerance * scene.cell_size;
    return request;
}

Problem make_problem(const Scene& scene, const Section& section)
{
    Problem problem;
    for (const SceneMaterial& material : scene.materials) problem.materials.push_back(material.material);
    for (const Region& region : section.regions) problem.region_names.push_back(region.name);
    problem.interpolation = scene.interpolation;
    problem.strain = scene.strain;
    problem.scheme = scene.scheme.value_or(TimeScheme::explicit_steps);
    problem.step_fraction = scene.step_fraction;
    problem.water = scene.water;
    problem.gravity = scene.gravity;
    problem.base_motion = scene.base_motion;
    return problem;
}

/// Whether a curve lets the soil beside it slide downward: it is free, repeats the other side, or is upright
/// and smooth.
bool lets_fall(const Boundary& boundary)
{
    const bool is_upright =
        std::all_of(boundary.segments.begin(), boundary.segments.end(), [](const Segment& segment) {
            constexpr double slant = 1e-9; // [-]
            const Vector2 along = segment.end - segment.start;
            return std::abs(along.x()) <= slant * along.norm();
        });
    return std::holds_alternative<FreeFace>(boundary.soil) ||
           std::holds_alternative<TiedSide>(boundary.soil) ||
           std::holds_alternative<FreeFieldSide>(boundary.soil) ||
           (std::holds_alternative<RollerWall>(boundary.soil) && is_upright);
}

/// Warn of soil that falls, for no curve bears it.
void doubt_support(const Scene& scene, const Problem& problem, Diagnostics& findings)
{
    const bool falls = std::all_of(problem.boundaries.begin(), problem.boundaries.end(), lets_fall);
    if (falls && problem.gravity > 0.0)
        findings.add(warning_at(scene.geometry_place, "boundaries", "support",
                                "no curve bears the soil: it falls under its weight",
                                "soil = \"fixed\" or \"roller\" on a curve, as in [boundaries.base]"));
}

/// Warn of shaking that soil is not damped in as it was asked for.
void doubt_damping(const Scene& scene, Diagnostics& findings)
{
    const double highest = highest_frequency(scene.base_motion);
    for (const SceneMaterial& each : scene.materials) {
        const auto damping = vibration_damping_of(each.material.law);
        if (!damping || highest == 0.0) continue;
        if (highest >= damping->lowest && highest <= damping->highest) continue;
        const std::string table = join_path({"materials", each.material.name});
        findings.add(warning_at(
            each.place, table + ".damping_frequency", "damping",
            fmt::format(
                "{}.damping_ratio holds from {:.3g} to {:.3g} Hz, and the shaking has up to {:.3g} Hz", table,
                damping->lowest, damping->highest, highest),
            "", "damping_frequency is the middle of the band: take that of the shaking"));
    }
}

/// Everything that can be wrong between scene and section before a particle exists. Names and grid are those
/// of all that is drawn, boundaries those of the soil that is there.
void check_case(const Section& drawn, AssembledCase& assembled)
{
    const Scene& scene = assembled.scene;
    const Section& section = assembled.section;
    Problem& problem = assembled.problem;
    Diagnostics& findings = assembled.warnings;
    check_names(scene, drawn, findings);
    check_phreatic_line(scene, findings);
    if (auto choice = choose_grid(scene, drawn, findings)) {
        const BackgroundGrid& grid = problem.grid = choice->grid;
        if (problem.strain == StrainForm::small)
            problem.grid.line_tolerance = BackgroundGrid::line_tolerance_of_still_shapes;
        assembled.grid_reasons = std::move(choice->reasons);
        for (std::string& what : check_section(drawn, grid)) {
            findings.add(error_at(scene.geometry_place, "section", std::move(what)));
        }
        problem.boundaries = find_boundaries(scene, section, findings);
        if (scene.stage && scene.stage->kind == StageKind::consolidate)
            for (Boundary& boundary : problem.boundaries) hold(boundary.soil);
        doubt_support(scene, problem, findings);
        doubt_damping(scene, findings);
        problem.rim = rim_of(section);
        problem.tied_sides = find_tied_sides(scene, section, grid, findings);
        check_free_field_sides(scene, section, grid, findings);
        check_gaps(scene, problem, findings);
        check_layers(scene, section, problem.grid.cell_size, findings);
        set_face_water(scene, section, problem, findings);
    }
    findings.accept(scene.accepted);
    throw_errors(findings, scene);
}

} // namespace

void throw_errors(const Diagnostics& findings, const Scene& scene)
{
    if (findings.has_errors()) throw_findings(findings, scene.text);
}

Section read_section(const Scene& scene)
{
    GmshRequest request = request_of(scene);
    const bool asks_for_size = request.quad_size && !(*request.quad_size > 0.0);
    if (asks_for_size) request.quad_size = std::nullopt;
    Section section = read_gmsh_file(request);
    if (asks_for_size) { // quadrilaterals of a third of the cells that suit the outlines
        request.quad_size = choose_cell_size(scene, section).size / 3.0;
        section = read_gmsh_file(request);
    }
    return section;
}

AssembledCase begin_case(Scene scene, Diagnostics warnings, Section present, const Section& drawn)
{
    AssembledCase assembled;
    assembled.scene = std::move(scene);
    assembled.warnings = std::move(warnings);
    assembled.section = std::move(present);
    assembled.problem = make_problem(assembled.scene, assembled.section);
    check_case(drawn, assembled);
    return assembled;
}

void require_sound(const std::vector<SceneReading>& stages)
{
    const Section drawn = read_section(stages.front().scene);
    for (const SceneReading& stage : stages)
        begin_case(stage.scene, stage.warnings, without_soil_of(absent_regions(stage.keys, drawn), drawn),
                   drawn);
}

} // namespace quicksand
