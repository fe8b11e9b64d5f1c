#include "solver/verification/solutions/eigenmodes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace quicksand {

Eigenmodes eigenmodes(const Eigen::MatrixXcd& matrix)
{
    const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors(), inverse(solver.eigenvectors())};
}

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXcd& matrix)
{
    return Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(matrix, false).eigenvalues();
}

Eigen::MatrixXcd inverse(const Eigen::MatrixXcd& matrix)
{
    return matrix.inverse();
}

} // namespace quicksand
