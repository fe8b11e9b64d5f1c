#include "io/assembly/initial_flow.hpp"

#include "geometry/section/section_mesh.hpp"
#include "io/assembly/face_water.hpp"
#include "io/keys/scene_schema.hpp"
#include "io/keys/scene_units.hpp"
#include "io/tables/scene_boundaries.hpp"
#include "solver/seepage/transient_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace quicksand {

namespace {

constexpr double head_rounding = 1e-6; // a head so little above the level is that of the level [cells]
constexpr double triangle_share = 0.3; // area of a triangle over its longest edge squared, as meshed [-]
constexpr double fewest = 16'000, most = 60'000; // triangles, whatever the cells [-]
constexpr double fewest_in_time = 12'000;        // [-]
constexpr int steps_in_time = 40;                // [-]

/// Whether no water passes the boundary. Where level ground goes on beyond a free-field side water flows
/// neither to it nor from it, unless the side has a head.
bool is_closed(const Boundary& boundary)
{
    if (std::holds_alternative<FreeFieldSide>(boundary.soil))
        return !std::holds_alternative<PrescribedWater>(boundary.water);
    return std::holds_alternative<Impervious>(boundary.water);
}

class FlowSection {
public:
    FlowSection(const Scene& scene, const Section& section, const Problem& problem, Diagnostics& findings)
        : scene_(scene), section_(section), problem_(problem), findings_(findings)
    {
        faces_.push_back({{}, problem.rim}); // what no boundary claims: open to the still water
        faces_.front().boundary.name = "";
    }

    bool check();
    std::optional<InitialFlow> solve(const std::vector<std::int32_t>& of_region);
    std::optional<InitialFlow> follow(const std::vector<std::int32_t>& of_region, double duration,
                                      const FlowStart& start);

private:
    struct Face {
        Boundary boundary;
        std::vector<Segment> segments; // [m]
    };

    double unit_weight() const { return problem_.water->density * problem_.gravity; }
    double level() const { return problem_.water->level; }
    double head_beyond(const Boundary& boundary, const Vector2& point, double time) const;
    void check_boundary(const Boundary& boundary);
    bool check_water_beyond(const Boundary& boundary, const SceneBoundary& written, double time);
    void check_sides(const FlowField& field);
    double triangle_size(double least_number) const;
    GroundFlowProblem mesh_flow(double size, const std::vector<std::int32_t>& of_region) const;
    Scalars drainable_porosity(const TriangleMesh& mesh, const std::vector<std::int32_t>& of_region) const;
    void fail_to_find(int iterations);
    InitialFlow found(const GroundFlowProblem& flow, const std::vector<OpenEdge>& edges,
                      const GroundFlow& solution, double size);
    std::vector<Vector2> water_lines() const;
    std::vector<OpenEdge> open_edges(const TriangleMesh& mesh) const;
    void place_water(double time, const TriangleMesh& mesh, std::vector<OpenEdge>& edges) const;
    void set_conditions(const std::vector<OpenEdge>& edges, GroundFlowProblem& flow) const;
    void fill_parts_without_head(GroundFlowProblem& flow) const;
    const Scene& scene_;
    const Section& section_;
    const Problem& problem_;
    Diagnostics& findings_;
    std::vector<Face> faces_;
};

/// Pressure head of the water beyond at a time, of the still water where the boundary has none [m].
double FlowSection::head_beyond(const Boundary& boundary, const Vector2& point, double time) const
{
    const double excess =
        outer_excess_pressure(problem_, boundary, point, outer_factor(boundary.water, time));
    return (excess + static_water_pressure(problem_, point.y())) / unit_weight();
}

void FlowSection::check_boundary(const Boundary& boundary)
{
    const SceneBoundary* written = find_boundary(scene_, boundary.name);
    const bool inside =
        std::any_of(boundary.segments.begin(), boundary.segments.end(),
                    [&](const Segment& segment) { return !any_along(problem_.rim, segment); });
    if (inside && !std::holds_alternative<Drained>(boundary.water)) {
        findings_.add(
            error_at(written != nullptr ? written->place : scene_.flow_place, "initial-flow",
                     "the curve \"" + boundary.name +
                         "\" lies inside the soil and is impervious or has a head: the steady flow "
                         "knows curves on the rim alone",
                     "curves on the rim of the soil, or water = \"drained\", which does nothing inside",
                     "a cut-off is a thin region of a small hydraulic_conductivity"));
        return;
    }
    if (is_closed(boundary) || written == nullptr) return;
    const auto* given = std::get_if<PrescribedWater>(&boundary.water);
    std::vector<double> times{0.0};
    if (given != nullptr && scene_.stage && scene_.stage->flow_duration)
        times = turning_times(given->history, *scene_.stage->flow_duration);
    for (const double time : times)
        if (!check_water_beyond(boundary, *written, time)) return;
    const bool is_steady =
        scene_.stage && scene_.stage->kind == StageKind::seepage && !scene_.stage->flow_duration;
    if (given != nullptr && is_steady && varies(given->history))
        findings_.add(warning_at(
            written->water_place, "boundaries." + boundary.name, "initial-flow",
            fmt::format("the water at the curve \"{}\" changes in time, but a stage of seepage without a "
                        "duration has the steady flow of its start",
                        boundary.name),
            "a duration of the stage, or water without ramp_time, frequency and history"));
}

/// Whether the water beyond stands at the level or above at a time, and at the curve or above.
bool FlowSection::check_water_beyond(const Boundary& boundary, const SceneBoundary& written, double time)
{
    for (const Segment& segment : boundary.segments) {
        for (const Vector2& point : {segment.start, segment.end}) {
            const double pressure = head_beyond(boundary, point, time);
            const double lowest =
                std::max(0.0, level() - point.y()) - head_rounding * problem_.grid.cell_size;
            if (pressure >= lowest) continue;
            const std::string high = pressure == 0.0 ? "no higher than the curve"
                                                     : fmt::format("{:.4g} m high", point.y() + pressure);
            findings_.add(error_at(
                written.water_place, "initial-flow",
                fmt::format(
                    "the water at the curve \"{}\" stands {} at [{:.5g}, {:.5g}]{}, below {}", boundary.name,
                    high, point.x(), point.y(), time > 0.0 ? fmt::format(" after {:.5g} s", time) : "",
                    lowest > 0.0 ? fmt::format("the water level {:.5g} m", level()) : "the curve itself"),
                "water at the water level or above, and no suction",
                "let level be that of the lowest water"));
            return false;
        }
    }
    return true;
}

bool FlowSection::check()
{
    if (!(problem_.gravity > 0.0))
        findings_.add(error_at(scene_.flow_place, "initial-flow",
                               "water.initial_flow = \"seepage\" without gravity: nothing drives the water",
                               "gravity.acceleration of more than 0"));
    if (findings_.has_errors()) return false;
    for (const Boundary& boundary : problem_.boundaries) check_boundary(boundary);
    for (const Boundary& boundary : problem_.boundaries) faces_.push_back({boundary, boundary.segments});
    return !findings_.has_errors();
}

/// Tied sides are one side, which has one pressure at a height.
void FlowSection::check_sides(const FlowField& field)
{
    if (!problem_.tied_sides) return;
    const auto left = field.surface(problem_.tied_sides->x_left),
               right = field.surface(problem_.tied_sides->x_right);
    if (!left || !right || std::abs(*left - *right) <= 0.1 * problem_.grid.cell_size) return;
    findings_.add(warning_at(
        scene_.flow_place, "water.initial_flow", "initial-flow",
        fmt::format(
            "the water stands {:.5g} m high at the tied side \"{}\" and {:.5g} m at \"{}\": a common side "
            "has one pore water pressure",
            *left, problem_.tied_sides->left, *right, problem_.tied_sides->right),
        "the same height at both"));
}

/// Of the cells' size, with at least so many triangles [m].
double FlowSection::triangle_size(double least_number) const
{
    double soil = 0.0;
    for (const Region& region : section_.regions) soil += area(region);
    return std::clamp(problem_.grid.cell_size, std::sqrt(soil / (triangle_share * most)),
                      std::sqrt(soil / (triangle_share * least_number)));
}

/// Where the water beyond meets the curves.
std::vector<Vector2> FlowSection::water_lines() const
{
    std::vector<Vector2> points;
    const auto cut = [&](const Segment& segment, double y) {
        const double from = segment.start.y() - y, to = segment.end.y() - y;
        if (from * to < 0.0)
            points.push_back(segment.start + from / (from - to) * (segment.end - segment.start));
    };
    for (const Face& face : faces_) {
        for (const Segment& segment : face.segments) {
            cut(segment, level());
            const auto* given = std::get_if<PrescribedWater>(&face.boundary.water);
            if (given == nullptr) continue;
            if (const auto* head = std::get_if<WaterHead>(&given->value)) cut(segment, head->head);
        }
    }
    return points;
}

/// The edges of the mesh on the rim, but for those on curves that hold the water.
std::vector<OpenEdge> FlowSection::open_edges(const TriangleMesh& mesh) const
{
    std::map<std::pair<std::size_t, std::size_t>, int> uses;
    for (const auto& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++uses[std::minmax(triangle[k], triangle[(k + 1) % 3])];
    std::vector<OpenEdge> edges;
    for (const auto& [nodes, count] : uses) {
        if (count != 1) continue;
        const Segment segment = {mesh.nodes[nodes.first], mesh.nodes[nodes.second]};
        std::size_t face = 0;
        for (std::size_t f = 1; f < faces_.size() && face == 0; ++f)
            if (any_along(faces_[f].segments, segment)) face = f;
        if (is_closed(faces_[face].boundary)) continue;
        edges.push_back({nodes.first, nodes.second, face});
    }
    place_water(0.0, mesh, edges);
    return edges;
}

/// The water beyond the edges at a time.
void FlowSection::place_water(double time, const TriangleMesh& mesh, std::vector<OpenEdge>& edges) const
{
    for (OpenEdge& edge : edges) {
        const Boundary& boundary = faces_[edge.face].boundary;
        const Vector2 &a = mesh.nodes[edge.a], &b = mesh.nodes[edge.b];
        edge.pressure_a = head_beyond(boundary, a, time);
        edge.pressure_b = head_beyond(boundary, b, time);
        edge.is_wet = head_beyond(boundary, 0.5 * (a + b), time) > 0.0;
    }
}

void FlowSection::set_conditions(const std::vector<OpenEdge>& edges, GroundFlowProblem& flow) const
{
    const auto& nodes = flow.mesh.nodes;
    flow.water.assign(nodes.size(), NodeWater::closed);
    flow.given_head.assign(nodes.size(), 0.0);
    for (const OpenEdge& edge : edges)
        if (!edge.is_wet) flow.water[edge.a] = flow.water[edge.b] = NodeWater::open;
    for (const OpenEdge& edge : edges) {
        if (!edge.is_wet) continue;
        for (const auto& [node, pressure] :
             {std::pair(edge.a, edge.pressure_a), std::pair(edge.b, edge.pressure_b)}) {
            const double head = nodes[node].y() + pressure;
            const bool first = flow.water[node] != NodeWater::head;
            flow.given_head[node] = first ? head : std::max(head, flow.given_head[node]);
            flow.water[node] = NodeWater::head;
        }
    }
}

/// Parts of the soil that no head reaches hold still water at the level.
void FlowSection::fill_parts_without_head(GroundFlowProblem& flow) const
{
    std::vector<std::uint8_t> reached(flow.water.size(), 0);
    for (std::size_t i = 0; i < reached.size(); ++i) reached[i] = flow.water[i] == NodeWater::head ? 1 : 0;
    for (bool grows = true; grows;) {
        grows = false;
        for (const auto& [a, b, c] : flow.mesh.triangles) {
            const int count = reached[a] + reached[b] + reached[c];
            if (count == 0 || count == 3) continue;
            reached[a] = reached[b] = reached[c] = 1;
            grows = true;
        }
    }
    for (std::size_t i = 0; i < reached.size(); ++i) {
        if (reached[i] != 0) continue;
        flow.water[i] = flow.mesh.nodes[i].y() < level() ? NodeWater::head : NodeWater::open;
        flow.given_head[i] = level();
    }
}

/// The soil in triangles; what its nodes are to the water is not known.
GroundFlowProblem FlowSection::mesh_flow(double size, const std::vector<std::int32_t>& of_region) const
{
    GroundFlowProblem flow;
    flow.mesh = mesh_section(section_, size, water_lines());
    for (const std::size_t region : flow.mesh.region) {
        const Material& material = problem_.materials[static_cast<std::size_t>(of_region[region])];
        flow.conductivity.push_back(material.hydraulic_conductivity * problem_.gravity /
                                    material.conductivity_gravity);
    }
    return flow;
}

/// Of every triangle: the pores that are not filled above the water.
Scalars FlowSection::drainable_porosity(const TriangleMesh& mesh,
                                        const std::vector<std::int32_t>& of_region) const
{
    Scalars porosity;
    for (const std::size_t region : mesh.region) {
        const auto m = static_cast<std::size_t>(of_region[region]);
        porosity.push_back(problem_.materials[m].porosity *
                           (1.0 - scene_.materials[m].saturation_above_water));
    }
    return porosity;
}

void FlowSection::fail_to_find(int iterations)
{
    findings_.add(
        error_at(scene_.flow_place, "initial-flow",
                 fmt::format("the phreatic line of the flow is not found: after {} iterations it still moves",
                             iterations),
                 "a flow with a steady state",
                 "look for a wrong conductivity, or draw the line with water.phreatic_line"));
}

InitialFlow FlowSection::found(const GroundFlowProblem& flow, const std::vector<OpenEdge>& edges,
                               const GroundFlow& solution, double size)
{
    std::vector<std::string> names;
    for (const Face& face : faces_) names.push_back(face.boundary.name);
    InitialFlow result{FlowField(flow.mesh, solution.head),
                       solution.saturation,
                       size,
                       solution.discharge,
                       solution.imbalance,
                       solution.iterations,
                       std::nullopt,
                       sum_face_flows(names, edges, flow, solution)};
    check_sides(result.field);
    return result;
}

std::optional<InitialFlow> FlowSection::solve(const std::vector<std::int32_t>& of_region)
{
    const double size = triangle_size(fewest);
    GroundFlowProblem flow = mesh_flow(size, of_region);
    const std::vector<OpenEdge> edges = open_edges(flow.mesh);
    set_conditions(edges, flow);
    const double still = head_rounding * problem_.grid.cell_size;
    bool flows = false;
    for (std::size_t i = 0; i < flow.water.size(); ++i)
        flows = flows || (flow.water[i] == NodeWater::head && std::abs(flow.given_head[i] - level()) > still);
    if (!flows) return std::nullopt;
    fill_parts_without_head(flow);
    const GroundFlow solution = solve_steady_flow(flow);
    if (!solution.converged) {
        fail_to_find(solution.iterations);
        return std::nullopt;
    }
    return found(flow, edges, solution, size);
}

std::optional<InitialFlow> FlowSection::follow(const std::vector<std::int32_t>& of_region, double duration,
                                               const FlowStart& start)
{
    const double size = triangle_size(fewest_in_time);
    GroundFlowProblem flow = mesh_flow(size, of_region);
    Scalars saturation = still_saturations(flow.mesh, flow.conductivity, start.level);
    if (start.flow != nullptr)
        for (std::size_t i = 0; i < saturation.size(); ++i)
            saturation[i] = std::clamp(
                start.flow->field.interpolate(start.flow->saturation, flow.mesh.nodes[i]), 0.0, 1.0);
    std::vector<OpenEdge> edges = open_edges(flow.mesh);
    const auto at_time = [&](double time) -> const GroundFlowProblem& {
        place_water(time, flow.mesh, edges);
        set_conditions(edges, flow);
        return flow;
    };
    const FlowHistory history =
        follow_flow(at_time, pores_of_nodes(flow.mesh, drainable_porosity(flow.mesh, of_region)), saturation,
                    duration, steps_in_time);
    if (!history.converged) {
        fail_to_find(history.iterations);
        return std::nullopt;
    }
    InitialFlow flow_at_end = found(flow, edges, history.end, size);
    const double lacking = std::abs(history.stored - history.inflow);
    flow_at_end.iterations = history.iterations;
    flow_at_end.flowed = {duration, history.stored,
                          history.turnover > 0.0 ? lacking / history.turnover : 0.0};
    return flow_at_end;
}

} // namespace

std::optional<InitialFlow> find_initial_flow(const Scene& scene, const Section& section,
                                             const std::vector<std::int32_t>& of_region,
                                             const Problem& problem, const FlowStart& start,
                                             Diagnostics& findings)
{
    if (!scene.starts_seeping) return std::nullopt;
    FlowSection flow(scene, section, problem, findings);
    if (!flow.check()) return std::nullopt;
    if (scene.stage && scene.stage->flow_duration)
        return flow.follow(of_region, *scene.stage->flow_duration, start);
    return flow.solve(of_region);
}

} // namespace quicksand
