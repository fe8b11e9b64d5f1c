// One column of cells in the place of a body whose columns are all equal.
//
// Between tied sides columns a whole number of widths apart are the same column. When the initial state
// repeats from cell to cell, and all actions on the body are equal for all columns, a shift by one cell
// maps the equations onto themselves and the initial state onto itself. Their solution is unique, so it
// repeats from cell to cell at all times, and is that of one column whose sides are tied at a width of one
// cell. Soil that leaves the column by one side comes in by the other. A run of all columns has the same
// result until soil drifts over its sides; there its outermost cells are filled in part only, those of the
// column never. It also lets differences of rounding between columns grow, which one column does not have.
// Nothing varies along x in the column either, so that one particle stands for a row of equal ones
// (equal_columns.hpp).
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// The column, and how its particles repeat in the body.
struct SoilColumn {
    Problem problem;    // one cell wide
    State state;        // its particles are numbered anew
    int columns = 1;    // of the body [-]
    int row_length = 1; // particles side by side in a column of the body, for which one stands [-]

    /// Particles of the body for which one stands.
    std::size_t repeats() const
    {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(row_length);
    }

    std::vector<std::int32_t> source;     // of each particle of the body: its number in the column [-]
    std::vector<std::int32_t> identifier; // of each particle of the body [-]
    Scalars drawn_x;                      // of each particle of the body: x at the beginning [m]
};

/// The column that represents the body, or the obstacle if there is none: empty for a body without tied
/// sides, where it has no interest. `state` is that at the start of a run.
struct ColumnSearch {
    std::optional<SoilColumn> column;
    std::string obstacle;
};

ColumnSearch find_soil_column(const Problem& problem, const State& state);

/// The state of the whole body, in the order of its particles at the beginning: values repeat, positions have
/// drifted as far as the soil has, the balances are those of all columns. Held reactions are left out.
void widen(const SoilColumn& column, const State& narrow, State& wide);

} // namespace quicksand
