#include "solver/seepage/transient_flow.hpp"

#include "solver/base/failure.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

Scalars pores_of_nodes(const TriangleMesh& mesh, const Scalars& drainable_porosity)
{
    ENSURE(drainable_porosity.size() == mesh.triangles.size());
    Scalars pores(mesh.nodes.size(), 0.0);
    for (std::size_t e = 0; e < mesh.triangles.size(); ++e) {
        const double third = drainable_porosity[e] * TriangleShape(corners_of(mesh, e)).area / 3.0;
        for (const std::size_t node : mesh.triangles[e]) pores[node] += third;
    }
    return pores;
}

Scalars still_saturations(const TriangleMesh& mesh, const Scalars& conductivity, double level)
{
    // sum c (p_j - s_i drop) = 0 over the edges to lower nodes
    Scalars rising(mesh.nodes.size(), 0.0), falling(mesh.nodes.size(), 0.0);
    for (const FlowEdge& edge : flow_edges(mesh, conductivity)) {
        rising[edge.i] += edge.conductance * std::max(0.0, level - mesh.nodes[edge.j].y());
        falling[edge.i] += edge.conductance * edge.drop;
    }
    Scalars saturation(mesh.nodes.size(), 1.0);
    for (std::size_t i = 0; i < saturation.size(); ++i)
        if (mesh.nodes[i].y() > level)
            saturation[i] = falling[i] > 0.0 ? std::clamp(rising[i] / falling[i], 0.0, 1.0) : 0.0;
    return saturation;
}

FlowHistory follow_flow(const std::function<const GroundFlowProblem&(double)>& at_time, const Scalars& pores,
                        const Scalars& saturation, double duration, int steps)
{
    ENSURE(duration > 0.0 && steps > 0);
    FlowHistory history;
    history.converged = true;
    history.end.saturation = saturation;
    const GroundFlowProblem& flow = at_time(0.0);
    const std::vector<FlowEdge> edges = flow_edges(flow.mesh, flow.conductivity);
    double time = 0.0;
    for (int k = 1; k <= steps; ++k) {
        const double part = static_cast<double>(k) / steps, next = duration * part * part;
        const FlowStorage storage = {pores, history.end.saturation, next - time};
        history.longest_step = std::max(history.longest_step, storage.dt);
        history.end = solve_flow_step(at_time(next), edges, storage, history.end);
        for (const double inflow : history.end.inflow) {
            history.inflow += storage.dt * inflow;
            history.turnover += storage.dt * std::abs(inflow);
        }
        history.iterations += history.end.iterations;
        history.converged = history.converged && history.end.converged;
        time = next;
    }
    history.end.head = continued_heads(flow.mesh, history.end);
    for (std::size_t i = 0; i < pores.size(); ++i)
        history.stored += pores[i] * (history.end.saturation[i] - saturation[i]);
    return history;
}

} // namespace quicksand
