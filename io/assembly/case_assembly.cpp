#include "io/assembly/case_assembly.hpp"

#include "geometry/section/present_section.hpp"
#include "io/assembly/case_checks.hpp"
#include "io/assembly/ground_water.hpp"
#include "io/assembly/interface_layers.hpp"
#include "io/assembly/present_soil.hpp"
#include "io/assembly/probe_places.hpp"
#include "io/assembly/stage_flows.hpp"
#include "io/scene/scene_grid.hpp"
#include "io/scene/scene_section.hpp"
#include "io/tables/scene_boundaries.hpp"
#include "solver/base/failure.hpp"
#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/columns/soil_column.hpp"
#include "solver/free_field/free_field_columns.hpp"
#include "solver/motion/slivers.hpp"
#include "solver/step/scheme_choice.hpp"
#include "solver/step/step_forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace quicksand {

namespace {

/// Probes without a place stand at the physical point of their name.
void place_probes(const Section& section, Scene& scene)
{
    for (SceneProbe& probe : scene.probes) {
        if (probe.at) continue;
        for (const NamedPoint& point : section.points) {
            if (point.name == probe.name) probe.at = point.position;
        }
    }
}

Sampling sample(const Scene& scene, const Section& section, const BackgroundGrid& grid,
                const std::vector<WaterLine>& water_lines)
{
    if (const auto* lattice = std::get_if<LatticeSampling>(&scene.sampling))
        return sample_lattice(section, grid, lattice->per_cell_x, lattice->per_cell_y, water_lines);
    return sample_mesh(section, grid);
}

/// `numbers` are the lasting ones of the domains.
Particles make_particles(const Problem& problem, const Sampling& sampling,
                         const std::vector<std::int32_t>& numbers,
                         const std::vector<std::int32_t>& material_of_domain)
{
    Particles particles;
    resize_particles(problem, sampling.domains.size(), particles);
    for (std::size_t p = 0; p < sampling.domains.size(); ++p) {
        const ParticleDomain& domain = sampling.domains[p];
        const std::int32_t m = material_of_domain[p];
        const Material& material = problem.materials[static_cast<std::size_t>(m)];
        particles.identifier[p] = numbers[p];
        particles.material[p] = m;
        particles.region[p] = static_cast<std::int32_t>(domain.region);
        particles.position.set(p, domain.centre);
        particles.half_edge_1.set(p, domain.half_edge_1);
        particles.half_edge_2.set(p, domain.half_edge_2);
        if (problem.interpolation == Interpolation::cpdi2) particles.twist.set(p, domain.twist);
        particles.volume[p] = domain.volume;
        particles.mass_solid[p] = (1.0 - material.porosity) * material.grain_density * domain.volume;
        if (problem.water) particles.porosity[p] = material.porosity;
    }
    reset_reference(particles);
    return particles;
}

/// The polygons of cut domains. Quadrilaterals whose corners move with the grid have none.
CutDomains take_cut_domains(const Problem& problem, Sampling& sampling)
{
    CutDomains cut;
    const auto is_piece = [](const ParticleDomain& domain) { return domain.is_piece; };
    if (std::any_of(sampling.domains.begin(), sampling.domains.end(), is_piece))
        for (const ParticleDomain& domain : sampling.domains) cut.pieces.push_back(domain.is_piece ? 1 : 0);
    if (sampling.shapes.empty() || problem.interpolation == Interpolation::cpdi2) return cut;
    for (const ParticleDomain& domain : sampling.domains) cut.number_of.push_back(domain.shape);
    cut.shapes = std::move(sampling.shapes);
    return cut;
}

void check_sampling(const Sampling& sampling, AssembledCase& assembled)
{
    for (std::size_t r = 0; r < sampling.regions.size(); ++r) {
        if (sampling.regions[r].particles > 0) continue;
        assembled.warnings.add(error_at(
            assembled.scene.grid_place, "sampling",
            fmt::format(
                "the region \"{}\" ({:.4g} m2) got no particle: it is thinner than a millionth of one",
                assembled.section.regions[r].name, sampling.regions[r].area),
            "", "use smaller cells or more particles_per_cell"));
    }
    if (sampling.domains.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
        assembled.warnings.add(error_at(assembled.scene.grid_place, "sampling",
                                        "there are too many material points", "at most 2147483647",
                                        "choose a larger cell_size"));
    }
    throw_errors(assembled.warnings, assembled.scene);
}

/// Whether soil lies at one of the points where a probe begins.
bool begins_in_soil(const SceneProbe& probe, const Problem& problem, const Particles& particles)
{
    if (probe.kind == ProbeKind::surface) return surface_point(problem, particles, probe.at->x()).found;
    const std::vector<Vector2> points = points_of(probe);
    return std::any_of(points.begin(), points.end(),
                       [&](const Vector2& point) { return !outside_soil(problem, particles, point); });
}

/// Probes ride with what lay nearest to their places in the drawing, however soil moves as it settles or in
/// earlier stages.
void choose_riders(AssembledCase& assembled)
{
    const Particles& drawn = assembled.state.particles;
    for (SceneProbe& probe : assembled.scene.probes)
        if (probe.kind == ProbeKind::material && probe.at)
            probe.rider = drawn.identifier[nearest_particle(drawn, *probe.at)];
}

/// A material probe rides with a particle and cannot do without; others may wait for soil.
void check_probes(AssembledCase& assembled)
{
    const Particles& particles = assembled.state.particles;
    for (const SceneProbe& probe : assembled.scene.probes) {
        if (!probe.at || begins_in_soil(probe, assembled.problem, particles)) continue;
        if (probe.kind == ProbeKind::material) {
            assembled.warnings.add(
                error_at(probe.place, "probe",
                         fmt::format("the probe \"{}\" {}", probe.name,
                                     *outside_soil(assembled.problem, particles, *probe.at)),
                         "", "places are in m, in the coordinates of the drawing"));
            continue;
        }
        assembled.warnings.add(warning_at(
            probe.place, "probes." + probe.name, "probe",
            fmt::format("the probe \"{}\" begins outside the soil: its rows stay empty until soil gets there",
                        probe.name),
            "a place in the drawing, in m"));
    }
    assembled.warnings.accept(assembled.scene.accepted);
    throw_errors(assembled.warnings, assembled.scene);
}

/// Hang what acts on curves on the particles beside them.
void attach_loads(AssembledCase& assembled)
{
    for (const std::string& name : attach_boundaries(assembled.problem, assembled.state.particles)) {
        const SceneBoundary* boundary = find_boundary(assembled.scene, name);
        ENSURE(boundary != nullptr);
        assembled.warnings.add(error_at(
            boundary->place, "load", "no material point lies beside a part of the curve \"" + name + "\"",
            "a curve on the rim of the soil", "choose a smaller cell_size, or move the curve to the soil"));
    }
    throw_errors(assembled.warnings, assembled.scene);
}

/// The ground beyond free-field sides, as it is beside them; all else is known.
void cut_columns(AssembledCase& assembled)
{
    for (const FreeFieldObstacle& obstacle : add_free_fields(assembled.problem, assembled.state)) {
        const SceneBoundary* boundary = find_boundary(assembled.scene, obstacle.boundary);
        ENSURE(boundary != nullptr);
        assembled.warnings.add(error_at(
            boundary->place, "free-field",
            "the free-field side \"" + obstacle.boundary + "\" has no column of its own: " + obstacle.what,
            "level ground over one cell beside the side",
            "draw the surface, the layers, the base and the phreatic line level over the last cells before "
            "the side"));
    }
    throw_errors(assembled.warnings, assembled.scene);
}

/// The scheme that takes the least time, for the one column of cells that a run computes where all are equal.
void choose_scheme(AssembledCase& assembled)
{
    const ColumnSearch search = assembled.scene.columns == ColumnsComputed::one
                                    ? find_soil_column(assembled.problem, assembled.state)
                                    : ColumnSearch();
    const Problem& computed = search.column ? search.column->problem : assembled.problem;
    const State& state = search.column ? search.column->state : assembled.state;
    assembled.problem =
        with_scheme(assembled.problem, fastest_scheme(computed, state, assembled.scene.end_time));
}

/// Beyond free-field sides the water is that of their columns, which begins as the flow has it beside them.
void leave_water_to_columns(Problem& problem)
{
    for (Boundary& boundary : problem.boundaries)
        if (std::holds_alternative<FreeFieldSide>(boundary.soil)) boundary.water = Drained{};
}

} // namespace

AssembledCase assemble_case(SceneReading reading, Section section)
{
    const std::vector<bool> absent = absent_regions(reading.keys, section);
    AssembledCase assembled = begin_case(std::move(reading.scene), std::move(reading.warnings),
                                         without_soil_of(absent, section), section);
    place_probes(section, assembled.scene);
    leave_out_probes(section, absent, assembled.scene);

    const auto of_region = materials_of_regions(assembled.scene, assembled.section);
    auto flows = flows_before(needed_flows(reading, assembled.scene), section, assembled.section);
    find_flow(reading, of_region, flows, assembled);
    leave_water_to_columns(assembled.problem);
    const FlowField* flow = assembled.initial_flow ? &assembled.initial_flow->field : nullptr;
    throw_errors(assembled.warnings, assembled.scene);
    assembled.water_lines = lines_of_parting(reading, section, assembled);
    assembled.sampling = sample(assembled.scene, section, assembled.problem.grid, assembled.water_lines);
    check_sampling(assembled.sampling, assembled);
    assembled.problem.cut_domains = take_cut_domains(assembled.problem, assembled.sampling);
    const std::vector<std::int32_t> numbers =
        keep_present(absent, assembled.problem.grid, assembled.sampling);
    auto of_domain = lay_interfaces(assembled.section, assembled.sampling, of_region, assembled.scene,
                                    assembled.problem, assembled.interfaces, assembled.warnings);
    assembled.warnings.accept(assembled.scene.accepted);
    throw_errors(assembled.warnings, assembled.scene);
    divide_materials(assembled.scene, flow, wetting_fields(reading, flows), assembled.sampling, of_domain,
                     assembled.problem);
    check_outer_water(assembled.scene, assembled.problem, assembled.warnings);
    throw_errors(assembled.warnings, assembled.scene);
    Particles& particles = assembled.state.particles;
    particles = make_particles(assembled.problem, assembled.sampling, numbers, of_domain);
    if (assembled.scene.stage) add_former_displacement(particles);
    if (assembled.problem.interpolation != Interpolation::cpdi2 && particles.size() > 0)
        assembled.problem.cut_domains.slivers =
            find_slivers(assembled.problem.cut_domains, particles,
                         *std::max_element(particles.volume.begin(), particles.volume.end()));
    assembled.sampling.domains = std::vector<ParticleDomain>(); // gives their memory back, {} would not
    set_initial_state(assembled.scene, flow, assembled.section, of_region, assembled.problem, particles);
    attach_loads(assembled);
    choose_riders(assembled);
    check_probes(assembled);
    assembled.state.stage = assembled.scene.relaxation ? Stage::relaxation : Stage::shaking;
    cut_columns(assembled);
    if (!assembled.scene.scheme) choose_scheme(assembled);
    return assembled;
}

AssembledCase assemble_case(SceneReading reading)
{
    Section section = read_section(reading.scene);
    return assemble_case(std::move(reading), std::move(section));
}

} // namespace quicksand
