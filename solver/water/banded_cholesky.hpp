// Cholesky factor of a symmetric matrix whose numbers lie near its diagonal. The matrix is positive definite,
// or the signs of its pivots are known. Single precision has half the bytes and twice the lanes of double.
#pragma once

#include <cstddef>
#include <vector>

namespace quicksand {

/// L of A = L J L^T, J = diag(+-1), in blocks of eight rows, which are solved together: their triangle on the
/// diagonal is kept as its inverse.
template <class Number>
class BandedFactor {
public:
    static constexpr std::size_t lanes = 8; // rows of a block

    /// A zero matrix of `rows` rows with at most `band` numbers left of the diagonal.
    void reset(std::size_t rows, std::size_t band);

    std::size_t band() const { return band_; } // rounded up to whole lanes

    /// Add to A(row, column), column <= row, row - column <= band. Before factorise() only.
    void add(std::size_t row, std::size_t column, double value)
    {
        const std::size_t first = row / lanes * lanes; // of the block
        lower_[row * (band_ + lanes) + band_ + column - first] += static_cast<Number>(value);
    }

    /// Let the pivot of a row be negative. Before factorise() only.
    void set_negative(std::size_t row)
    {
        signs_.resize(padded_rows(), Number{1});
        signs_[row] = Number{-1};
    }

    /// Pivots that rounding or left-out numbers have brought below `least_pivot`, apart from their signs,
    /// are set to it.
    void factorise(Number least_pivot);

    /// Of the vectors of solve(): band() zeros, rows() numbers, and zeros to whole blocks.
    std::size_t vector_length() const { return band_ + padded_rows(); }

    /// Solve A x = b in place.
    void solve(Number* vector) const;

    /// Solve L y = b in place for a b that is zero but in rows [first, last). Ends where band() numbers of y
    /// in turn are below `least`: what follows is smaller still. Returns the row behind the last solved, a
    /// whole block's; the numbers from `first`'s block to there are y, the others as they were.
    std::size_t solve_lower(std::size_t first, std::size_t last, Number least, Number* vector) const;

private:
    std::size_t padded_rows() const { return (rows_ + lanes - 1) / lanes * lanes; }

    std::size_t rows_ = 0, band_ = 0;
    std::vector<Number> signs_; // of the pivots
    std::vector<Number> lower_; // of a row the columns from band_ before its block to the block's last
};

using BandedCholesky = BandedFactor<float>;

} // namespace quicksand
