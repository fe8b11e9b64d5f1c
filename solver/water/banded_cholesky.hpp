// Cholesky factor of a symmetric matrix whose numbers lie near its diagonal. The matrix is positive definite,
// or the signs of its pivots are known. Single precision has half the bytes and twice the lanes of double.
#pragma once

#include <cstddef>
#include <vector>

namespace quicksand {

/// Eight rows of a factor: their columns from `first` to those of the triangle on the diagonal.
struct FactorBlock {
    std::size_t begin = 0;  // of the first row among the numbers
    std::size_t first = 0;  // column, a multiple of eight
    std::size_t stride = 0; // from row to row
};

/// L of A = L J L^T, J = diag(+-1), in blocks of eight rows, which are solved together: their triangle on the
/// diagonal is kept as its inverse. A block begins at the first column in which one of its rows has a number,
/// so that few rows with numbers far to the left cost little; L has none before them either.
template <class Number>
class BandedFactor {
public:
    static constexpr std::size_t lanes = 8; // rows of a block

    /// A zero matrix; the numbers of row i lie in the columns from first_columns[i] <= i to the diagonal.
    void reset(const std::vector<std::size_t>& first_columns);

    /// Add to A(row, column), first_columns[row] <= column <= row. Before factorise() only.
    void add(std::size_t row, std::size_t column, double value)
    {
        const FactorBlock& block = blocks_[row / lanes];
        lower_[block.begin + row % lanes * block.stride + column - block.first] += static_cast<Number>(value);
    }

    /// Let the pivot of a row be negative. Before factorise() only.
    void set_negative(std::size_t row) { signs_[row] = Number{-1}; }

    /// Pivots that rounding or left-out numbers have brought below `least_pivot`, apart from their signs,
    /// are set to it.
    void factorise(Number least_pivot);

    /// Of the vectors of the solves: the rows, and zeros to whole blocks.
    std::size_t vector_length() const { return blocks_.size() * lanes; }

    /// Solve A x = b in place: L y = b, then L^T x = J y.
    void solve(Number* vector) const
    {
        solve_lower(vector);
        solve_upper(vector);
    }
    void solve_lower(Number* vector) const;
    void solve_upper(Number* vector) const;

    /// Solve L y = b in place for a b that is zero but in rows [first, last). Ends where as many numbers of y
    /// in turn as the band has are below `least`: what follows is smaller still. Returns the row behind the
    /// last solved, a whole block's; the numbers from `first`'s block to there are y, the others as they
    /// were.
    std::size_t solve_lower(std::size_t first, std::size_t last, Number least, Number* vector) const;

private:
    std::vector<FactorBlock> blocks_;
    std::size_t band_ = 0;      // most numbers left of the diagonal, rounded up to whole blocks
    std::vector<Number> signs_; // of the pivots
    std::vector<Number> lower_;
};

using BandedCholesky = BandedFactor<float>;

} // namespace quicksand
