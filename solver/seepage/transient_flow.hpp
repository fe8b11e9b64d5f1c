// Flow of water through soil whose heads change: pores drain above the falling water and fill below the
// rising one.
//
// Backward Euler steps of the balance of ground_flow.hpp with the storage n_d ds/dt, n_d the drainable
// porosity. The soil does not yield, and the water does not either: what pores hold moves at once. Water that
// falls through drained soil does so at k, its gradient being 1. Steps begin short and become longer, t_k = T
// (k/N)^2, for a sudden change of heads is followed by an ever slower flow.
#pragma once

#include "solver/seepage/ground_flow.hpp"

#include <functional>

namespace quicksand {

/// The flow from a start on.
struct FlowHistory {
    GroundFlow end;
    double inflow = 0.0;       // of water through all faces, negative where more has left [m3 per m]
    double stored = 0.0;       // what the pores hold more than at the start [m3 per m]
    double turnover = 0.0;     // what has passed faces in either direction [m3 per m]
    double longest_step = 0.0; // [s]
    int iterations = 0;        // sets that were tried in all steps [-]
    bool converged = false;    // in every step
};

/// n_d integrated over the function of every node; one drainable porosity for every triangle [m2].
Scalars pores_of_nodes(const TriangleMesh& mesh, const Scalars& drainable_porosity);

/// Saturations with still water at a level: those at which nothing flows, for water rises from nodes with
/// pressure into the row above until its saturation outweighs it. A line between two rows of nodes is where
/// the upper row is filled in part.
Scalars still_saturations(const TriangleMesh& mesh, const Scalars& conductivity, double level);

/// Follow the flow over a duration, from saturations at the start; at_time(t) gives the flow problem with the
/// heads that act at t, on the same mesh.
FlowHistory follow_flow(const std::function<const GroundFlowProblem&(double)>& at_time, const Scalars& pores,
                        const Scalars& saturation, double duration, int steps);

} // namespace quicksand
