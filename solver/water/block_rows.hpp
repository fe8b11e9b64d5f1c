// The rows of walls in the blocks that precondition the pressure solve.
//
// The equations of a block without the rows are F. With the rows' parts G of the cells and their own matrix P
// they are F - G^T P^-1 G, and the inverse is F^-1 + F^-1 G^T C^-1 G F^-1 with C = P - G F^-1 G^T (Sherman
// and Morrison 1950, Woodbury 1950): one more solve with the factor of F.
#pragma once

#include "solver/walls/velocity_rows.hpp"
#include "solver/water/banded_cholesky.hpp"
#include "solver/water/node_touches.hpp"

#include <Eigen/Cholesky>
#include <cstddef>
#include <vector>

namespace quicksand {

struct BlockRows {
    struct Part {
        std::size_t row; // of the block
        float value;
    };
    std::vector<std::vector<Part>> parts; // G, of rows scaled to a diagonal of P of ones
    Eigen::LLT<Eigen::MatrixXf> factor;   // of C
    Eigen::VectorXf multipliers;          // work array
};

/// Set up the rows that touch a block. `scale` are the block's own, 1 / sqrt(diagonal) [Pa^1/2 / m], `factor`
/// is that of F, and `solution` a work array of its vector length.
void set_up_rows(double dt, const std::vector<HeldRow>& held, const NodeTouches& touches,
                 const std::vector<double>& scale, const BandedCholesky& factor, std::vector<float>& solution,
                 BlockRows& rows);

/// Turn `solution`, that of F for the right-hand side `given`, into that of the equations with the rows.
void hold_rows(const BandedCholesky& factor, const std::vector<float>& given, BlockRows& rows,
               std::vector<float>& solution);

} // namespace quicksand
