// Which nodes touch which walls: the functions of the nodes integrated along the curves.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/walls/wall_chains.hpp"

#include <cstddef>
#include <vector>

namespace quicksand {

/// A node whose function does not vanish on a chain, as means over the chain weighted by that function.
struct WallContact {
    std::size_t node = 0;               // that carries the sums: a master
    std::size_t chain = 0;              // in SoilEdges::chains
    double length = 0.0;                // of the chain under the function, int N_i ds [m]
    double drawn = 0.0;                 // the part of it within the curve, not beyond its end [m]
    double s = 0.0;                     // arc length [m]
    Vector2 normal = Vector2::Zero();   // outward [-]
    Vector2 velocity = Vector2::Zero(); // of the wall over the step [m/s]
    Vector2 change = Vector2::Zero();   // of that velocity since the step before [m/s]
};

/// The same of an edge that is in no chain.
struct EdgeContact {
    std::size_t node = 0;
    double length = 0.0;              // [m]
    Vector2 normal = Vector2::Zero(); // outward [-]
};

/// Both in the order of the nodes.
struct WallContacts {
    std::vector<WallContact> walls;
    std::vector<EdgeContact> others;
};

/// When a step begins [s], its length and that of the step before, 0 for the first one of a stage.
struct StepTimes {
    double begin = 0.0, length = 0.0, last = 0.0; // [s]
};

/// The contacts with the moving walls where they are as the step begins, and their velocities in it; while
/// the soil settles they stand still, and in small strain the equations have them where they were drawn.
WallContacts find_contacts(const Problem& problem, const SoilEdges& edges, const NodeConditions& conditions,
                           Stage stage, const StepTimes& times);

/// Length of a segment under each node's function, int N_i ds; a node may come several times.
struct NodeLength {
    std::size_t node = 0;
    double length = 0.0; // [m]
};
std::vector<NodeLength> lengths_along(const BackgroundGrid& grid, const Segment& segment);

} // namespace quicksand
