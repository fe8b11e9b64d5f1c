// Values and vectors of small matrices. One source compiles the library's solver, which takes gcc half a
// minute.
#pragma once

#include <Eigen/Core>

namespace quicksand {

/// Modes of A v = s v.
struct Eigenmodes {
    Eigen::VectorXcd values;  // s [unit of A]
    Eigen::MatrixXcd vectors; // v, a column each, of length 1
    Eigen::MatrixXcd duals;   // a row each, the inverse of the vectors
};

/// All modes of a square matrix, which must have as many vectors as rows.
Eigenmodes eigenmodes(const Eigen::MatrixXcd& matrix);

/// Its values alone, in no order.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXcd& matrix);

/// A^-1 of a regular matrix.
Eigen::MatrixXcd inverse(const Eigen::MatrixXcd& matrix);

} // namespace quicksand
