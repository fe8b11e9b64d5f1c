// Flow of water through soil with a free surface that is found, steady or over a step of time.
//
// With the pressure head p >= 0 and the saturation s of the soil, the flux is -k (grad p + s grad y), and
// s = 1 wherever p > 0: soil without pressure lets water fall through, as much of it as comes from above, and
// is dry where none comes (Brezis, Kinderlehrer and Stampacchia 1978; Alt 1980). Faces open to the air are
// faces of seepage: water leaves where its pressure would be positive, and none enters. Linear triangles, the
// saturation that of the higher node of an edge; on a Delaunay mesh no coefficient has the wrong sign. What
// is found is which nodes have pressure: the equations of a set are linear, and the sets follow each other
// until none changes (the active sets of Hintermueller, Ito and Kunisch 2002). In time the water of a node's
// pores changes by what flows in: n_d ds/dt, with the saturation at the end of the step.
#pragma once

#include "solver/particles/particles.hpp"
#include "solver/seepage/triangle_mesh.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// What a node is to the water.
enum class NodeWater : std::uint8_t {
    closed, // inside, or at a face that no water passes
    head,   // with a given head
    open,   // at a face open to the air
};

struct GroundFlowProblem {
    TriangleMesh mesh;
    Scalars conductivity;         // k of every triangle [m/s]
    std::vector<NodeWater> water; // of every node
    Scalars given_head;           // of nodes with a head, at y or above; of no use at others [m]
};

struct GroundFlow {
    Scalars pressure_head;  // p of every node, 0 where there is none [m]
    Scalars saturation;     // s of every node [-]
    Scalars head;           // h = y + p, continued where p is 0; none after a step [m]
    Scalars inflow;         // through the faces at every node, negative where water leaves [m2/s]
    double discharge = 0.0; // what enters from heads, without what leaves to the same head [m3/s per m]
    double imbalance = 0.0; // largest flow that a node without a face gains, over the discharge [-]
    int iterations = 0;     // sets that were tried [-]
    bool converged = false;
};

/// Between two nodes, the higher one first; water goes from i to j at c (p_i - p_j + s_i drop).
struct FlowEdge {
    std::size_t i = 0, j = 0;
    double conductance = 0.0; // c, of all triangles along the edge [m/s]
    double drop = 0.0;        // y_i - y_j, not negative [m]
};

/// The edges of a mesh with the conductivity of every triangle [m/s].
std::vector<FlowEdge> flow_edges(const TriangleMesh& mesh, const Scalars& conductivity);

/// Head of every node: h = y + p where the soil is saturated. Beyond, as the water's heads go on, at most y:
/// grad h has no part across a free surface, so that a smooth continuation places it within the triangles it
/// cuts [m].
Scalars continued_heads(const TriangleMesh& mesh, const GroundFlow& flow);

/// The steady state. Every connected part of the mesh must have a node with a given head. Where the sets of
/// wet nodes do not come to an end, `converged` is false and the heads are those of the last one.
GroundFlow solve_steady_flow(const GroundFlowProblem& problem);

/// Pores that fill and drain over a step.
struct FlowStorage {
    Scalars pores;      // of every node: n_d integrated over its function [m2]
    Scalars saturation; // before the step [-]
    double dt = 0.0;    // [s]
};

/// The flow at the end of a step, over the edges of the problem's mesh; `before` is that at its start or near
/// it, whose sets are tried first. No part of the mesh needs a head.
GroundFlow solve_flow_step(const GroundFlowProblem& problem, const std::vector<FlowEdge>& edges,
                           const FlowStorage& storage, const GroundFlow& before);

} // namespace quicksand
