// The rows of walls in the blocks that precondition the pressure solve.
//
// The equations of a block without the rows are F = L L^T. With the rows' parts G of the cells and their own
// matrix P they are F - G^T P^-1 G, and the inverse is F^-1 + F^-1 G^T C^-1 G F^-1 with C = P - G F^-1 G^T
// (Sherman and Morrison 1950, Woodbury 1950). With Y = L^-1 G^T it is L^-T (1 + Y C^-1 Y^T) L^-1: the rows
// come between the two halves of a solve.
#pragma once

#include "solver/walls/velocity_rows.hpp"
#include "solver/water/banded_cholesky.hpp"
#include "solver/water/node_touches.hpp"

#include <Eigen/Cholesky>
#include <cstddef>
#include <vector>

namespace quicksand {

/// A column of Y: numbers [first, first + y.size()); those behind are next to nothing.
struct RowResponse {
    std::size_t first = 0;
    std::vector<float> y;
};

struct BlockRows {
    std::vector<RowResponse> responses; // Y, of rows scaled to a diagonal of P of ones
    Eigen::LLT<Eigen::MatrixXf> factor; // of C
    Eigen::VectorXf multipliers;        // work array
};

/// Set up the rows that touch a block. `scale` are the block's own, 1 / sqrt(diagonal) [Pa^1/2 / m], `factor`
/// is that of F, and `work` an array of its vector length.
void set_up_rows(double dt, const std::vector<HeldRow>& held, const NodeTouches& touches,
                 const std::vector<double>& scale, const BandedCholesky& factor, std::vector<float>& work,
                 BlockRows& rows);

/// Turn L^-1 b into (1 + Y C^-1 Y^T) L^-1 b.
void hold_rows(BlockRows& rows, std::vector<float>& vector);

} // namespace quicksand
