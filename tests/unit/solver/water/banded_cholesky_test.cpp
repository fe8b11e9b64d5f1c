#include "solver/water/banded_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <random>

namespace quicksand {
namespace {

/// A random positive definite matrix with a diagonal near one and `band` numbers left of it.
Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index band)
{
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(rows, rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
        for (Eigen::Index column = std::max<Eigen::Index>(0, row - band); column < row; ++column) {
            const double value = 0.4 * number(generator) / static_cast<double>(band);
            matrix(row, column) = matrix(column, row) = value;
        }
    }
    return matrix;
}

/// The columns in which the rows of a matrix begin.
std::vector<std::size_t> first_columns(const Eigen::MatrixXd& A)
{
    std::vector<std::size_t> first;
    for (Eigen::Index row = 0; row < A.rows(); ++row) {
        Eigen::Index column = 0;
        while (column < row && A(row, column) == 0.0) ++column;
        first.push_back(static_cast<std::size_t>(column));
    }
    return first;
}

template <class Number>
void fill_factor(const Eigen::MatrixXd& A, BandedFactor<Number>& factor)
{
    const std::vector<std::size_t> first = first_columns(A);
    factor.reset(first);
    for (std::size_t row = 0; row < first.size(); ++row)
        for (std::size_t column = first[row]; column <= row; ++column)
            factor.add(row, column, A(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
}

template <class Number>
double largest_error(const Eigen::MatrixXd& A)
{
    const Eigen::Index rows = A.rows();
    BandedFactor<Number> factor;
    fill_factor(A, factor);
    factor.factorise(Number(1e-4));
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(rows, -1.0, 2.0);
    std::vector<Number> vector(factor.vector_length(), Number{0});
    std::transform(b.begin(), b.end(), vector.begin(),
                   [](double value) { return static_cast<Number>(value); });
    factor.solve(vector.data());
    const Eigen::VectorXd x = A.llt().solve(b);
    double error = 0.0;
    for (Eigen::Index row = 0; row < rows; ++row) {
        const Number found = vector[static_cast<std::size_t>(row)];
        error = std::max(error, std::abs(static_cast<double>(found) - x[row]));
    }
    return error;
}

TEST(BandedCholesky, SolvesToThePrecisionOfItsNumbers)
{
    for (const Eigen::Index band : {1, 7, 8, 9, 30, 100}) {
        EXPECT_LT(largest_error<float>(random_matrix(150, band)), 3e-6) << band;
        EXPECT_LT(largest_error<double>(random_matrix(150, band)), 6e-15) << band;
    }
}

TEST(BandedCholesky, TakesFewRowsThatReachFartherThanTheOthers)
{
    Eigen::MatrixXd A = random_matrix(150, 9);
    for (const Eigen::Index row : {3, 40, 41, 75, 149})
        for (Eigen::Index column = std::max<Eigen::Index>(0, row - 60); column < row; column += 7)
            A(row, column) = A(column, row) = 0.02;
    EXPECT_LT(largest_error<float>(A), 3e-6);
    EXPECT_LT(largest_error<double>(A), 6e-15);
}

/// Conditions on the unknowns before them, as rows of a quasi-definite matrix.
TEST(BandedCholesky, SolvesWithPivotsOfKnownSigns)
{
    constexpr Eigen::Index rows = 150, band = 20;
    Eigen::MatrixXd A = random_matrix(rows, band);
    std::vector<std::size_t> negative;
    for (Eigen::Index row = 9; row < rows; row += 14) {
        A(row, row) = row % 4 == 1 ? 0.0 : -0.5;
        for (Eigen::Index k = 1; k < 6; ++k) A(row, row - k) = A(row - k, row) = 0.4;
        negative.push_back(static_cast<std::size_t>(row));
    }
    BandedCholesky factor;
    fill_factor(A, factor);
    for (const std::size_t row : negative) factor.set_negative(row);
    factor.factorise(1e-6f);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(rows, -1.0, 2.0);
    const Eigen::VectorXd x = A.partialPivLu().solve(b);
    std::vector<float> vector(factor.vector_length(), 0.0f);
    std::transform(b.begin(), b.end(), vector.begin(),
                   [](double value) { return static_cast<float>(value); });
    factor.solve(vector.data());
    for (Eigen::Index row = 0; row < rows; ++row)
        EXPECT_NEAR(static_cast<double>(vector[static_cast<std::size_t>(row)]), x[row],
                    1e-5 * x.cwiseAbs().maxCoeff())
            << row;
}

TEST(BandedCholesky, SolvesTheLowerHalfAsFarAsItIsNotSmall)
{
    constexpr Eigen::Index rows = 300, band = 8;
    const Eigen::MatrixXd A = random_matrix(rows, band);
    BandedCholesky factor;
    fill_factor(A, factor);
    factor.factorise(1e-4f);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(rows);
    b[13] = 1.0;
    b[30] = -0.5;
    const Eigen::VectorXd y = A.llt().matrixL().solve(b);
    for (const float least : {0.0f, 1e-3f}) {
        std::vector<float> vector(factor.vector_length(), 0.0f);
        vector[13] = 1.0f;
        vector[30] = -0.5f;
        const std::size_t end = factor.solve_lower(13, 31, least, vector.data());
        EXPECT_EQ(end % BandedCholesky::lanes, 0U);
        if (least == 0.0f) {
            EXPECT_EQ(end, 304U);
        } else {
            EXPECT_LT(end, 100U);
        }
        for (std::size_t row = 0; row < rows; ++row)
            EXPECT_NEAR(vector[row], y[static_cast<Eigen::Index>(row)],
                        std::max(1e-6, static_cast<double>(least)));
    }
}

TEST(BandedCholesky, TakesMatricesOfLessThanABlock)
{
    EXPECT_LT(largest_error<float>(random_matrix(5, 20)), 1e-6);
    EXPECT_LT(largest_error<float>(random_matrix(1, 1)), 1e-6);
}

TEST(BandedCholesky, KeepsPivotsPositive)
{
    BandedCholesky factor;
    factor.reset({0, 0});
    factor.add(0, 0, 1.0);
    factor.add(1, 0, 2.0); // not positive definite
    factor.add(1, 1, 1.0);
    factor.factorise(0.25f);
    std::vector<float> vector(factor.vector_length(), 0.0f);
    vector[0] = 1.0f;
    factor.solve(vector.data());
    EXPECT_FLOAT_EQ(vector[0], 17.0f); // of L = [1 0; 2 0.5]
    EXPECT_FLOAT_EQ(vector[1], -8.0f);
}

} // namespace
} // namespace quicksand
