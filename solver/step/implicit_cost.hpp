// What an implicit step costs beside a step that waves of the skeleton limit.
//
// Both sum over particles and nodes. The implicit one also factorises the stiffness of the nodes, with the
// rows of walls between grid lines, and solves with it some ten times. Where rows repeat each other, as in
// corners between grid lines, it needs double precision and more corrections. It costs 1.9 to 2.5 times as
// much with 3 x 3 particles in a cell, 3 with one column of particles, 4 with such corners and 2 x 2.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

namespace quicksand {

/// What the cost of a step goes with: the numbers of its parts [-].
struct StepParts {
    double particles = 0.0;
    double nodes = 0.0;  // with soil
    double height = 0.0; // nodes across the shorter side of the soil
    double rows = 0.0;   // of walls between grid lines
    bool rows_repeat = false;
};

StepParts count_parts(const Problem& problem, const State& state);

/// Cost of an implicit step over that of a step that waves limit. Counted and not measured: the times of the
/// steps under way would choose other steps, and so other bits, in every run [-].
double implicit_cost(const StepParts& parts);

} // namespace quicksand
