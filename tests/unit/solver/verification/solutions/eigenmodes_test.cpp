#include "solver/verification/solutions/eigenmodes.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using Complex = std::complex<double>;

Eigen::MatrixXcd turning_and_growing()
{
    Eigen::MatrixXcd A = Eigen::MatrixXcd::Zero(3, 3);
    A(0, 1) = -2.0;
    A(1, 0) = 2.0;
    A(1, 2) = Complex(0.5, 0.25);
    A(2, 2) = 3.0;
    return A;
}

TEST(Eigenmodes, DiagonalizeTheMatrix)
{
    const Eigen::MatrixXcd A = turning_and_growing();
    const Eigenmodes modes = eigenmodes(A);
    EXPECT_LT((A * modes.vectors - modes.vectors * modes.values.asDiagonal()).norm(), 1e-14);
    EXPECT_LT((modes.duals * modes.vectors - Eigen::MatrixXcd::Identity(3, 3)).norm(), 1e-14);
    for (const Complex expected : {Complex(0.0, 2.0), Complex(0.0, -2.0), Complex(3.0, 0.0)}) {
        EXPECT_LT((eigenvalues(A).array() - expected).abs().minCoeff(), 1e-14) << expected;
    }
}

TEST(Eigenmodes, InverseTimesTheMatrixIsOne)
{
    const Eigen::MatrixXcd A = turning_and_growing();
    EXPECT_LT((inverse(A) * A - Eigen::MatrixXcd::Identity(3, 3)).norm(), 1e-14);
}

} // namespace
} // namespace quicksand
