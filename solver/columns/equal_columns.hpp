// Which particles of a body repeat: from column to column of its cells, and from side to side of a cell.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace quicksand {

/// How the particles of a body lie in its columns of cells, all of them equal.
struct EqualColumns {
    double left = 0.0;               // x of the first column [m]
    double width = 0.0;              // of a column, a cell [m]
    int count = 0;                   // of columns [-]
    int row_length = 1;              // particles side by side in a column for which one stands [-]
    std::vector<int> column;         // of every particle [-]
    std::vector<std::size_t> source; // of every particle: the one of the first column that stands for it [-]
    Scalars shift;                   // of every particle from its source [m]
    std::vector<std::size_t> particles; // those that stand for others, in order [-]
};

/// The columns between the tied sides, where every particle has its like in each of them at the same place.
std::optional<EqualColumns> find_equal_columns(const Problem& problem, const Particles& particles);

/// Where all rows of a column are of so many equal domains side by side, let one particle stand for each row.
///
/// The nodes at both sides of a column of one cell are the same, so that nothing varies along x in it: what a
/// particle gives to the nodes of a height and what it gets from them does not depend on its x.
void join_rows(const Particles& particles, EqualColumns& columns);

} // namespace quicksand
