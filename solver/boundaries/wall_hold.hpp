// What boundary curves hold of the grains and of the water.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// What a curve holds of the grains.
enum class GrainHold { none, normal, all };
/// What a curve holds of the water, normal to itself.
enum class WaterHold {
    none,
    sealed,      // the water has the wall's velocity
    with_grains, // an impervious film: the water has the grains' velocity
};

struct WallHold {
    GrainHold grains = GrainHold::none;
    WaterHold water = WaterHold::none;

    bool operator==(const WallHold&) const = default;
    bool any() const { return grains != GrainHold::none || water != WaterHold::none; }
};

/// What a segment holds in a stage. While the soil settles, viscous curves are held: bases fixed, steep sides
/// as rollers.
WallHold hold_of(const Boundary& boundary, const Segment& segment, Stage stage);

/// Whether a segment is a condition on nodes: it stands, and lies on a line of the grid.
bool holds_nodes(const Problem& problem, const Boundary& boundary, const Segment& segment);

} // namespace quicksand
