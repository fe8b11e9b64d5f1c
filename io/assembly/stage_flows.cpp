#include "io/assembly/stage_flows.hpp"

#include "geometry/section/present_section.hpp"
#include "io/assembly/case_checks.hpp"
#include "io/assembly/ground_water.hpp"
#include "io/assembly/present_soil.hpp"
#include "solver/base/failure.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>

namespace quicksand {

namespace {

/// What a flow in time begins with after the flows of these stages.
FlowStart start_after(const std::vector<Scene>& stages, const std::vector<std::optional<InitialFlow>>& flows,
                      const Problem& problem)
{
    if (!problem.water) return {};
    if (flows.empty()) return {nullptr, problem.water->level};
    const std::optional<InitialFlow>& last = flows.back();
    return {last ? &*last : nullptr, stages[flows.size() - 1].water->level};
}

/// The flow of a stage whose case has begun.
std::optional<InitialFlow> flow_of(const FlowStart& start, AssembledCase& stage)
{
    return find_initial_flow(stage.scene, stage.section, materials_of_regions(stage.scene, stage.section),
                             stage.problem, start, stage.warnings);
}

/// Whether two lines are one but for the meshes on which their flows were found.
bool is_same_line(const WaterLine& a, const WaterLine& b, double cell_size)
{
    constexpr double of_meshes = 0.01; // of a cell
    return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                      [&](const Vector2& one, const Vector2& other) {
                          return one.x() == other.x() &&
                                 std::abs(one.y() - other.y()) <= of_meshes * cell_size;
                      });
}

/// Call visit(flow, problem) for the flow of a stage in its soil, if there is one; its own beginning tells
/// what is wrong with it.
template <class Visit>
void visit_flow(const SeepingStage& stage, const Section& drawn, Visit&& visit)
{
    AssembledCase of_stage = begin_case(stage.scene, Diagnostics(),
                                        without_soil_of(absent_regions(stage.keys, drawn), drawn), drawn);
    if (const auto flow = flow_of({}, of_stage)) visit(flow->field, of_stage.problem);
}

} // namespace

std::vector<std::int32_t> materials_of_regions(const Scene& scene, const Section& section)
{
    const auto material_index = [&](const std::string& name) {
        for (std::size_t m = 0; m < scene.materials.size(); ++m) {
            if (scene.materials[m].material.name == name) return static_cast<std::int32_t>(m);
        }
        throw InternalError("a region without a material has passed the checks");
    };
    std::vector<std::int32_t> materials;
    for (const Region& region : section.regions) {
        const auto entry =
            std::find_if(scene.regions.begin(), scene.regions.end(),
                         [&](const SceneRegion& candidate) { return candidate.name == region.name; });
        ENSURE(entry != scene.regions.end());
        materials.push_back(material_index(entry->material));
    }
    return materials;
}

std::vector<Scene> needed_flows(const SceneReading& reading, const Scene& scene)
{
    if (reading.keeps_flow || (scene.stage && scene.stage->flow_duration)) return reading.flows;
    return {reading.flows.end() - static_cast<std::ptrdiff_t>(reading.wetting), reading.flows.end()};
}

std::vector<std::optional<InitialFlow>> flows_before(const std::vector<Scene>& stages, const Section& drawn,
                                                     const Section& section)
{
    std::vector<std::optional<InitialFlow>> flows;
    for (const Scene& scene : stages) {
        AssembledCase before = begin_case(scene, Diagnostics(), section, drawn);
        const FlowStart start = start_after(stages, flows, before.problem);
        flows.push_back(flow_of(start, before));
    }
    return flows;
}

void find_flow(const SceneReading& reading, const std::vector<std::int32_t>& of_region,
               std::vector<std::optional<InitialFlow>>& flows, AssembledCase& assembled)
{
    if (reading.keeps_flow) {
        assembled.initial_flow = std::move(flows.back());
        flows.pop_back();
        return;
    }
    const Scene& scene = assembled.scene;
    assembled.initial_flow =
        find_initial_flow(scene, assembled.section, of_region, assembled.problem,
                          start_after(reading.flows, flows, assembled.problem), assembled.warnings);
    if (!scene.stage || !scene.stage->flow_duration) return;
    for (Boundary& boundary : assembled.problem.boundaries)
        hold_water(boundary.water, *scene.stage->flow_duration);
}

std::vector<WaterLine> lines_of_parting(const SceneReading& reading, const Section& drawn,
                                        const AssembledCase& assembled)
{
    if (reading.parted_before) return *reading.parted_before;
    std::vector<WaterLine> lines = reading.water_lines;
    const auto* lattice = std::get_if<LatticeSampling>(&assembled.scene.sampling);
    if (lattice == nullptr) return lines;
    const auto part_at = [&](const FlowField& flow, const Problem& problem) {
        const std::optional<WaterLine> line = line_of_flow(flow, problem, lattice->per_cell_x);
        if (!line) return;
        const auto is_line = [&](const WaterLine& known) {
            return is_same_line(known, *line, problem.grid.cell_size);
        };
        if (std::none_of(lines.begin(), lines.end(), is_line)) lines.push_back(*line);
    };
    if (!assembled.scene.stage) {
        if (assembled.initial_flow) part_at(assembled.initial_flow->field, assembled.problem);
    } else {
        for (const SeepingStage& stage : reading.seeping) {
            if (assembled.initial_flow && stage.scene.stage->name == assembled.scene.stage->name)
                part_at(assembled.initial_flow->field, assembled.problem);
            else
                visit_flow(stage, drawn, part_at);
        }
    }
    return lines;
}

std::vector<const FlowField*> wetting_fields(const SceneReading& reading,
                                             const std::vector<std::optional<InitialFlow>>& flows)
{
    std::vector<const FlowField*> fields;
    const std::size_t count = reading.wetting - (reading.keeps_flow ? 1 : 0); // its own flow wets as well
    for (std::size_t k = flows.size() - count; k < flows.size(); ++k)
        if (flows[k]) fields.push_back(&flows[k]->field);
    return fields;
}

} // namespace quicksand
