#include "io/assembly/face_flows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace quicksand {

namespace {

constexpr double least_outflow = 1e-9;   // of all that leaves, that counts as water leaving [-]
constexpr double height_rounding = 1e-6; // of the section's height [-]

/// All that leaves through faces [m3/s per m].
double outflow_of(const GroundFlow& solution)
{
    double outflow = 0.0;
    for (const double inflow : solution.inflow) outflow += std::max(0.0, -inflow);
    return outflow;
}

double height_of(const TriangleMesh& mesh)
{
    const auto [lowest, highest] =
        std::minmax_element(mesh.nodes.begin(), mesh.nodes.end(),
                            [](const Vector2& a, const Vector2& b) { return a.y() < b.y(); });
    return highest->y() - lowest->y();
}

} // namespace

std::vector<FaceFlow> sum_face_flows(const std::vector<std::string>& names,
                                     const std::vector<OpenEdge>& edges, const GroundFlowProblem& flow,
                                     const GroundFlow& solution)
{
    std::vector<FaceFlow> flows(names.size());
    for (std::size_t f = 0; f < flows.size(); ++f) flows[f].name = names[f];
    const double same_height = height_rounding * height_of(flow.mesh);
    const double least = least_outflow * outflow_of(solution);
    std::vector<std::uint8_t> counted(flow.water.size(), 0); // a node between two faces belongs to one
    std::vector<double> outflow(flows.size(), 0.0);          // at the exit found so far [m2/s]
    const auto raise_entry = [&](FaceFlow& face, const Vector2& place) {
        if (!face.entry || place.y() > face.entry->y()) face.entry = place;
    };
    // on level ground water leaves everywhere: there the place of the most counts, the toe
    const auto raise_exit = [&](std::size_t f, const Vector2& place, double leaves) {
        std::optional<Vector2>& exit = flows[f].exit;
        const bool level = exit && std::abs(place.y() - exit->y()) <= same_height;
        if (exit && !(level ? leaves > outflow[f] : place.y() > exit->y())) return;
        exit = place;
        outflow[f] = leaves;
    };
    for (const bool wet : {true, false}) {
        for (const OpenEdge& edge : edges) {
            if (edge.is_wet != wet) continue;
            for (const std::size_t node : {edge.a, edge.b}) {
                FaceFlow& face = flows[edge.face];
                if (wet) raise_entry(face, flow.mesh.nodes[node]);
                if (counted[node] != 0) continue;
                counted[node] = 1;
                face.inflow += solution.inflow[node];
                const double leaves = -solution.inflow[node];
                if (!wet && leaves > least) raise_exit(edge.face, flow.mesh.nodes[node], leaves);
            }
        }
    }
    std::erase_if(flows, [](const FaceFlow& face) { return !face.entry && !face.exit; });
    return flows;
}

} // namespace quicksand
