#include "solver/seepage/ground_flow.hpp"

#include "solver/base/failure.hpp"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace quicksand {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

constexpr int most_iterations = 200;
constexpr double rounding = 1e-10; // of the section's height for heads, of 1 for saturations [-]
constexpr double leak = 1e-12;     // of its conductance, by which soil without pressure loses water [-]

/// What is unknown at a node.
enum class Unknown : std::uint8_t {
    none,       // the pressure is given: that of a head, or 0 where water leaves
    pressure,   // the saturation is 1
    saturation, // the pressure is 0
};

/// The sets of nodes with and without pressure, and the solution that belongs to them.
class FlowIteration {
public:
    FlowIteration(const GroundFlowProblem& problem, const std::vector<FlowEdge>& edges);

    /// Let pores fill and drain, beginning with the sets of another flow.
    void follow(const FlowStorage& storage, const GroundFlow& before);
    GroundFlow solve();

private:
    bool solve_sets();
    bool revise_sets();
    Scalars inflows() const;
    GroundFlow report(int iterations, bool converged) const;

    const GroundFlowProblem& problem_;
    const std::vector<FlowEdge>& edges_;
    std::vector<Unknown> unknown_;  // of every node
    Scalars pressure_, saturation_; // of every node [m], [-]
    Scalars scale_;                 // of every node: the sum of its conductances' sizes [m/s]
    double height_ = 0.0;           // of the section [m]
    Scalars filling_;               // of every node: what its pores take up over the step when full [m2/s]
    Scalars before_;                // saturation of every node before the step [-]
};

FlowIteration::FlowIteration(const GroundFlowProblem& problem, const std::vector<FlowEdge>& edges)
    : problem_(problem), edges_(edges), unknown_(problem.mesh.nodes.size(), Unknown::pressure),
      pressure_(unknown_.size(), 0.0), saturation_(unknown_.size(), 1.0), scale_(unknown_.size(), 0.0),
      filling_(unknown_.size(), 0.0), before_(unknown_.size(), 0.0)
{
    double highest = problem.mesh.nodes.front().y(), lowest = highest;
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
        const double y = problem.mesh.nodes[i].y();
        lowest = std::min(lowest, y);
        highest = std::max(highest, y);
        if (problem.water[i] == NodeWater::closed) continue;
        unknown_[i] = Unknown::none; // all soil begins wet, and loses water at every open face
        if (problem.water[i] == NodeWater::head) pressure_[i] = std::max(0.0, problem.given_head[i] - y);
    }
    height_ = highest - lowest;
    for (const FlowEdge& edge : edges_) {
        scale_[edge.i] += std::abs(edge.conductance);
        scale_[edge.j] += std::abs(edge.conductance);
    }
}

void FlowIteration::follow(const FlowStorage& storage, const GroundFlow& before)
{
    before_ = storage.saturation;
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
        filling_[i] = storage.pores[i] / storage.dt;
        if (problem_.water[i] == NodeWater::head || before.saturation[i] >= 1.0) continue;
        unknown_[i] = Unknown::saturation;
    }
}

/// Pressures and saturations that balance the flow at every node with an unknown; whether there are any.
bool FlowIteration::solve_sets()
{
    std::vector<Eigen::Index> row(unknown_.size(), -1);
    Eigen::Index count = 0;
    for (std::size_t i = 0; i < unknown_.size(); ++i)
        if (unknown_[i] != Unknown::none) row[i] = count++;
    Entries entries;
    Eigen::VectorXd given = Eigen::VectorXd::Zero(count);
    // a flow that is the value of one node times a factor leaves i and enters j
    const auto add = [&](const FlowEdge& edge, std::size_t of, bool is_unknown, double value, double factor) {
        if (row[edge.i] >= 0) {
            if (is_unknown)
                entries.emplace_back(row[edge.i], row[of], factor);
            else
                given[row[edge.i]] -= factor * value;
        }
        if (row[edge.j] >= 0) {
            if (is_unknown)
                entries.emplace_back(row[edge.j], row[of], -factor);
            else
                given[row[edge.j]] += factor * value;
        }
    };
    for (const FlowEdge& edge : edges_) {
        const double c = edge.conductance;
        add(edge, edge.i, unknown_[edge.i] == Unknown::pressure, pressure_[edge.i], c);
        add(edge, edge.j, unknown_[edge.j] == Unknown::pressure, pressure_[edge.j], -c);
        add(edge, edge.i, unknown_[edge.i] == Unknown::saturation, saturation_[edge.i], c * edge.drop);
    }
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
        if (row[i] < 0) continue;
        given[row[i]] += filling_[i] * before_[i];
        if (unknown_[i] == Unknown::saturation)
            entries.emplace_back(row[i], row[i],
                                 filling_[i] > 0.0 ? filling_[i] : leak * scale_[i] * height_);
        else
            given[row[i]] -= filling_[i];
    }
    if (count == 0) return true;
    SparseMatrix matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<SparseMatrix> factors(matrix);
    if (factors.info() != Eigen::Success) return false;
    const Eigen::VectorXd values = factors.solve(given);
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
        if (unknown_[i] == Unknown::pressure) pressure_[i] = values[row[i]];
        if (unknown_[i] == Unknown::saturation) saturation_[i] = values[row[i]];
    }
    return values.allFinite();
}

/// What enters through the faces at every node, or is out of balance there [m2/s].
Scalars FlowIteration::inflows() const
{
    Scalars inflow(unknown_.size());
    for (std::size_t i = 0; i < inflow.size(); ++i) inflow[i] = filling_[i] * (saturation_[i] - before_[i]);
    for (const FlowEdge& edge : edges_) {
        const double flow =
            edge.conductance * (pressure_[edge.i] - pressure_[edge.j] + saturation_[edge.i] * edge.drop);
        inflow[edge.i] += flow;
        inflow[edge.j] -= flow;
    }
    return inflow;
}

/// A pressure below 0 becomes none, a saturation above 1 a pressure or, at an open face, water that leaves;
/// where water would enter from the air there is none. Whether any node has changed.
bool FlowIteration::revise_sets()
{
    const Scalars inflow = inflows();
    bool changed = false;
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
        const Unknown before = unknown_[i];
        if (before == Unknown::none && problem_.water[i] == NodeWater::open &&
            inflow[i] > rounding * scale_[i] * height_)
            unknown_[i] = Unknown::saturation;
        if (before == Unknown::pressure && pressure_[i] < -rounding * height_)
            unknown_[i] = Unknown::saturation;
        if (before == Unknown::saturation && saturation_[i] > 1.0 + rounding)
            unknown_[i] = problem_.water[i] == NodeWater::open ? Unknown::none : Unknown::pressure;
        if (unknown_[i] == before) continue;
        changed = true;
        if (unknown_[i] == Unknown::saturation)
            pressure_[i] = 0.0;
        else
            saturation_[i] = 1.0;
    }
    return changed;
}

GroundFlow FlowIteration::report(int iterations, bool converged) const
{
    GroundFlow flow;
    const Scalars inflow = inflows();
    flow.pressure_head = pressure_;
    flow.saturation = saturation_;
    flow.inflow.assign(inflow.size(), 0.0);
    std::map<double, double> from_heads; // faces with a common head exchange no water [m2/s]
    for (std::size_t i = 0; i < inflow.size(); ++i) {
        if (unknown_[i] == Unknown::none) {
            flow.inflow[i] = inflow[i];
            if (problem_.water[i] == NodeWater::head) from_heads[problem_.given_head[i]] += inflow[i];
        } else {
            flow.imbalance = std::max(flow.imbalance, std::abs(inflow[i]));
        }
    }
    for (const auto& [head, net] : from_heads) flow.discharge += std::max(0.0, net);
    flow.imbalance = flow.discharge > 0.0 ? flow.imbalance / flow.discharge : 0.0;
    flow.iterations = iterations;
    flow.converged = converged;
    return flow;
}

GroundFlow FlowIteration::solve()
{
    for (int k = 1; k <= most_iterations; ++k) {
        if (!solve_sets()) return report(k, false);
        if (!revise_sets()) return report(k, true);
    }
    return report(most_iterations, false);
}

} // namespace

std::vector<FlowEdge> flow_edges(const TriangleMesh& mesh, const Scalars& conductivity)
{
    ENSURE(conductivity.size() == mesh.triangles.size());
    std::map<std::pair<std::size_t, std::size_t>, double> conductances;
    for (std::size_t e = 0; e < mesh.triangles.size(); ++e) {
        const TriangleShape shape(corners_of(mesh, e));
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3, i = mesh.triangles[e][a], j = mesh.triangles[e][b];
            conductances[{std::min(i, j), std::max(i, j)}] -=
                conductivity[e] * shape.area * shape.slope[a].dot(shape.slope[b]);
        }
    }
    std::vector<FlowEdge> edges;
    for (const auto& [nodes, conductance] : conductances) {
        auto [i, j] = nodes;
        if (mesh.nodes[i].y() < mesh.nodes[j].y()) std::swap(i, j);
        edges.push_back({i, j, conductance, mesh.nodes[i].y() - mesh.nodes[j].y()});
    }
    return edges;
}

Scalars continued_heads(const TriangleMesh& mesh, const GroundFlow& flow)
{
    // of a conductance: ties drained parts that touch no water to the lowest point
    constexpr double loose = 1e-9;
    const std::size_t size = mesh.nodes.size();
    double lowest = mesh.nodes.front().y();
    for (const Vector2& node : mesh.nodes) lowest = std::min(lowest, node.y());
    Scalars head(size, 0.0);
    std::vector<Eigen::Index> row(size, -1);
    Eigen::Index count = 0;
    for (std::size_t i = 0; i < size; ++i) {
        head[i] = mesh.nodes[i].y() + std::max(0.0, flow.pressure_head[i]);
        if (flow.saturation[i] < 1.0) row[i] = count++;
    }
    if (count == 0) return head;
    Entries entries;
    Eigen::VectorXd given = Eigen::VectorXd::Zero(count);
    for (const FlowEdge& edge : flow_edges(mesh, Scalars(mesh.triangles.size(), 1.0))) {
        for (const auto& [a, b] : {std::pair(edge.i, edge.j), std::pair(edge.j, edge.i)}) {
            if (row[a] < 0) continue;
            entries.emplace_back(row[a], row[a], edge.conductance + loose * std::abs(edge.conductance));
            given[row[a]] += loose * std::abs(edge.conductance) * lowest;
            if (row[b] >= 0)
                entries.emplace_back(row[a], row[b], -edge.conductance);
            else
                given[row[a]] += edge.conductance * head[b];
        }
    }
    SparseMatrix matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd values = Eigen::SimplicialLDLT<SparseMatrix>(matrix).solve(given);
    for (std::size_t i = 0; i < size; ++i)
        if (row[i] >= 0) head[i] = std::min(mesh.nodes[i].y(), values[row[i]]);
    return head;
}

GroundFlow solve_steady_flow(const GroundFlowProblem& problem)
{
    const std::size_t count = problem.mesh.nodes.size();
    ENSURE(count > 0 && problem.water.size() == count && problem.given_head.size() == count);
    const std::vector<FlowEdge> edges = flow_edges(problem.mesh, problem.conductivity);
    GroundFlow flow = FlowIteration(problem, edges).solve();
    flow.head = continued_heads(problem.mesh, flow);
    return flow;
}

GroundFlow solve_flow_step(const GroundFlowProblem& problem, const std::vector<FlowEdge>& edges,
                           const FlowStorage& storage, const GroundFlow& before)
{
    const std::size_t count = problem.mesh.nodes.size();
    ENSURE(storage.pores.size() == count && storage.saturation.size() == count && storage.dt > 0.0);
    ENSURE(before.saturation.size() == count);
    FlowIteration iteration(problem, edges);
    iteration.follow(storage, before);
    return iteration.solve();
}

} // namespace quicksand
