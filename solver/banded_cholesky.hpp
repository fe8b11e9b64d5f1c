// Cholesky factor of a symmetric positive definite matrix whose numbers lie near its diagonal, in single
// precision: a preconditioner needs no more, and it is half the bytes and twice the lanes.
#pragma once

#include <cstddef>
#include <vector>

namespace quicksand {

/// L of A = L L^T, row by row.
class BandedCholesky {
public:
    static constexpr std::size_t lanes = 8;

    /// A zero matrix of `rows` rows with at most `band` numbers left of the diagonal.
    void reset(std::size_t rows, std::size_t band);

    std::size_t rows() const { return rows_; }
    std::size_t band() const { return band_; } // rounded up to whole lanes

    /// Add to A(row, column), column <= row, row - column <= band. Before factorise() only.
    void add(std::size_t row, std::size_t column, double value)
    {
        if (row == column) {
            diagonal_[row] += static_cast<float>(value);
        } else {
            lower_[row * band_ + band_ + column - row] += static_cast<float>(value);
        }
    }

    /// Pivots that rounding or left-out numbers have brought below `least_pivot` are set to it.
    void factorise(float least_pivot);

    /// Solve A x = b in place. The vector has band() zeros before its rows() numbers.
    void solve(float* vector) const;

private:
    std::size_t rows_ = 0, band_ = 0;
    std::vector<float> lower_;    // band_ numbers of a row, the last is that next to the diagonal
    std::vector<float> diagonal_; // of A, then 1 / L(r, r)
};

} // namespace quicksand
