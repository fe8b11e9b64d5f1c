// The flow of the ground water that a scene may begin with: between the heads at its curves, with a phreatic
// line that is found; steady, or after a time from the flow of an earlier stage on.
#pragma once

#include "geometry/section/section.hpp"
#include "io/assembly/face_flows.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/tables/scene.hpp"
#include "solver/problem/problem.hpp"
#include "solver/seepage/flow_field.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace quicksand {

/// What has flowed in the time of a flow.
struct FlowedWater {
    double duration = 0.0;  // [s]
    double stored = 0.0;    // what the soil holds more than before, negative where it has drained [m3 per m]
    double imbalance = 0.0; // what the faces have not let in of it, over what has passed them [-]
};

struct InitialFlow {
    FlowField field;
    Scalars saturation;                // of the nodes of its mesh [-]
    double triangle_size = 0.0;        // longest edge [m]
    double discharge = 0.0;            // through the section, at the end of the time [m3/s per m]
    double imbalance = 0.0;            // what the balance of any part lacks, over the discharge [-]
    int iterations = 0;                // [-]
    std::optional<FlowedWater> flowed; // none: the flow is steady
    std::vector<FaceFlow> faces;
};

/// What a flow in time begins with.
struct FlowStart {
    const InitialFlow* flow = nullptr; // none: still water at the level
    double level = 0.0;                // [m]
};

/// The flow at the start, where the scene asks for it, steady or after the time of its stage; none where no
/// water stands at any curve, so that nothing flows. Curves that water passes have the head that stands
/// beyond them at the start, and are faces of seepage above it; edges without a name have the still water's.
/// Adds errors for water that stands below the level, for seals and heads inside the soil and where the
/// search for the line does not end. Wants the boundaries, the rim, the grid and the sides of the problem;
/// `of_region` holds the material of every region.
std::optional<InitialFlow> find_initial_flow(const Scene& scene, const Section& section,
                                             const std::vector<std::int32_t>& of_region,
                                             const Problem& problem, const FlowStart& start,
                                             Diagnostics& findings);

} // namespace quicksand
