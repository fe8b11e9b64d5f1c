// Walls off the grid lines as chains of segments with hat functions along them.
//
// Standing walls that lie on grid lines are conditions on nodes (boundary_conditions.hpp). All other curves
// that hold grains or water, and all that move, are chains: segments of one condition joined by turns below
// 45 degrees. Hats along the arc length, some 2.5 cells apart, carry one condition on the velocities each
// (wall_rows.hpp); of rings one stands at the highest place, wherever the drawing begins. Closer hats lock
// the soil at the wall, as multipliers that are too rich for the velocities do (Babuska 1973).
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quicksand {

/// A straight part of a chain.
struct ChainEdge {
    Segment drawn;
    double first = 0.0;       // arc length at its start [m]
    std::size_t boundary = 0; // in Problem::boundaries
    std::size_t segment =
        0;               // of the boundary; that which is continued where the edge goes on beyond the curve
    bool beyond = false; // whether it does
};

struct WallChain {
    WallHold hold;
    std::vector<ChainEdge> edges;
    double first = 0.0, last = 0.0; // arc lengths of its ends, the drawn part from 0 on [m]
    double spacing = 0.0;           // of the hats; they stand at its multiples [m]
    std::size_t hats = 0;           // a single one is constant
    double first_hat = 0.0;         // where the first stands [m]
    bool closed = false; // its end is its start: a ring, or a chain from one tied side to the other
    bool straight = true;
    int line_axis = -1; // of a wall parallel to x (0) or y (1): its hats are the grid's lines across it,
                        // whose numbers stand for arc lengths; -1 at any other angle
};

/// Edges of the soil beside the chains: their part of the normals is not the chains'.
struct SoilEdges {
    std::vector<WallChain> chains;
    std::vector<Segment> others;

    bool empty() const { return chains.empty(); }
};

SoilEdges make_soil_edges(const Problem& problem, Stage stage);

/// Call add(hat, value) for the one or two hats at an arc length; the values add up to 1.
template <class Add>
void for_each_hat(const WallChain& chain, double s, Add&& add);

template <class Add>
void for_each_hat(const WallChain& chain, double s, Add&& add)
{
    if (chain.hats == 1) {
        add(std::size_t{0}, 1.0);
        return;
    }
    const auto most = static_cast<double>(chain.closed ? chain.hats : chain.hats - 1);
    double place = (s - chain.first_hat) / chain.spacing;
    if (chain.closed && place < 0.0) place += most;
    place = std::clamp(place, 0.0, most);
    const auto left = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(most) - 1);
    const double fraction = place - static_cast<double>(left);
    add(left, 1.0 - fraction);
    add(left + 1 == chain.hats ? std::size_t{0} : left + 1, fraction);
}

} // namespace quicksand
