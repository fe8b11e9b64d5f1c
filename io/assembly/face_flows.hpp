// What passes the faces of the soil, from the flows at the nodes of a mesh.
#pragma once

#include "solver/seepage/ground_flow.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// What passes a boundary curve, or the edges without a name.
struct FaceFlow {
    std::string name;             // of the curve; "" of edges without one
    double inflow = 0.0;          // negative where water leaves [m3/s per m]
    std::optional<Vector2> entry; // highest point below the water that stands beyond [m]
    std::optional<Vector2>
        exit; // highest point where water leaves into the air, of several the one with the most [m]
};

/// An edge of the mesh at which water may pass, with the face it belongs to.
struct OpenEdge {
    std::size_t a = 0, b = 0;
    std::size_t face = 0;                      // index into their names
    double pressure_a = 0.0, pressure_b = 0.0; // of the water beyond at a time [m of head]
    bool is_wet = false;                       // below the water beyond
};

/// The faces that water stands at or leaves, by the flows of a solution.
std::vector<FaceFlow> sum_face_flows(const std::vector<std::string>& names,
                                     const std::vector<OpenEdge>& edges, const GroundFlowProblem& flow,
                                     const GroundFlow& solution);

} // namespace quicksand
