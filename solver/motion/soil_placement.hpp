// Soil that a stage places on the ground of the stage before, and soil that it takes away.
//
// Placed soil is free of stress and has the volume drawn. In small strain it lies where it is drawn. In large
// strain the ground beneath has settled since it was drawn, and the soil is moved down with it: no gap is
// left, and what is brought in is what is drawn, whatever the ground does. Its top is lower by as much.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstddef>

namespace quicksand {

/// The soil of two stages side by side.
struct MatchedSoil {
    Particles drawn;   // of the stage that begins, as drawn: first what goes on, then what it places
    Particles reached; // of the stage before what goes on, in the same order
    std::size_t size() const { return reached.size(); } // what goes on
    bool is_same = true;                                // nothing is placed nor taken away
};

/// Match by lasting numbers. Throws InputError where the particles of a region differ otherwise than all or
/// none.
MatchedSoil match_soil(const Particles& drawn, Particles reached);

/// Let the particles from the end of `matched.reached` on be those that are placed: `particles` are those of
/// the stage that begins, with the state of the stage before in what goes on.
void place_soil(const Problem& problem, const MatchedSoil& matched, Particles& particles);

} // namespace quicksand
