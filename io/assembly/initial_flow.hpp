// The steady flow of the ground water that a scene may begin with: between the heads at its curves, with a
// phreatic line that is found.
#pragma once

#include "geometry/section/section.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/tables/scene.hpp"
#include "solver/problem/problem.hpp"
#include "solver/seepage/flow_field.hpp"
#include "solver/seepage/steady_flow.hpp"

#include <cstdint>
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

struct InitialFlow {
    FlowField field;
    double triangle_size = 0.0; // longest edge [m]
    double discharge = 0.0;     // through the section [m3/s per m]
    double imbalance = 0.0;     // what the balance of any part lacks, over the discharge [-]
    int iterations = 0;         // [-]
    std::vector<FaceFlow> faces;
};

/// The steady flow at the start, where the scene asks for it; none where no water stands at any curve, so
/// that nothing flows. Curves that water passes have the head that stands beyond them at the start, and are
/// faces of seepage above it; edges without a name have the still water's. Adds errors for water that stands
/// below the level, for seals and heads inside the soil and where the search for the line does not end. Wants
/// the boundaries, the rim, the grid and the sides of the problem; `of_region` holds the material of every
/// region.
std::optional<InitialFlow> find_initial_flow(const Scene& scene, const Section& section,
                                             const std::vector<std::int32_t>& of_region,
                                             const Problem& problem, Diagnostics& findings);

} // namespace quicksand
