// The columns of free-field sides, cut out of the body.
//
// A column is that of the cells beside the side: its particles with their state, the base, the surface and
// the water there, in level rows. Its own sides are tied at a width of one cell, and it has no end
// (soil_column.hpp).
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// Why a side has no column.
struct FreeFieldObstacle {
    std::string boundary; // the curve
    std::string what;     // "its layers are not level beside it"
};

/// Add a column to the problem, and its state to the state, for every place of free-field sides; the state is
/// that at the start, pieces of curves are attached. The sides lie on grid lines. Returns what is in the way;
/// without obstacles every side has its column.
std::vector<FreeFieldObstacle> add_free_fields(Problem& problem, State& state);

} // namespace quicksand
