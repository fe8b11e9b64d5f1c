#include "solver/water/banded_cholesky.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/singles.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// The sum of each of eight vectors.
template <class Vector>
Vector sums_of(const Vector (&s)[8])
{
    const auto add_pairs = [](const Vector& a, const Vector& b) {
        return __builtin_shufflevector(a, b, 0, 2, 8, 10, 4, 6, 12, 14) +
               __builtin_shufflevector(a, b, 1, 3, 9, 11, 5, 7, 13, 15);
    };
    const Vector low = add_pairs(add_pairs(s[0], s[1]), add_pairs(s[2], s[3]));
    const Vector high = add_pairs(add_pairs(s[4], s[5]), add_pairs(s[6], s[7]));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 8, 9, 10, 11) +
           __builtin_shufflevector(low, high, 4, 5, 6, 7, 12, 13, 14, 15);
}

constexpr std::size_t lanes = BandedCholesky::lanes;

/// Eight rows of a block: row i from `rows + i stride` on, in it the columns from `first` on.
template <class Number>
struct RowBlock {
    Number* rows;
    std::size_t stride, first;

    Number& operator()(std::size_t i, std::size_t column) const { return rows[i * stride + column - first]; }
};

template <class Number>
RowBlock<Number> rows_of(const FactorBlock& block, Number* numbers)
{
    return {numbers + block.begin, block.stride, block.first};
}

/// The products of eight rows with another over `count` columns from `first` on, which `b` points at.
template <class Number>
Eight<Number> products_of(const RowBlock<Number>& a, std::size_t first, const Number* b, std::size_t count)
{
    Eight<Number> sums[lanes] = {};
    for (std::size_t k = 0; k < count; k += lanes) {
        const Eight<Number> x = load(b + k);
        for (std::size_t i = 0; i < lanes; ++i) sums[i] += load(&a(i, first + k)) * x;
    }
    return sums_of(sums);
}

/// Columns of a block of 8 x 8 from its rows.
template <class Number>
void transpose(const RowBlock<Number>& rows, std::size_t first, Eight<Number> (&columns)[lanes])
{
    for (std::size_t j = 0; j < lanes; ++j)
        for (std::size_t i = 0; i < lanes; ++i) columns[j][i] = rows(i, first + j);
}

/// L J of the block `own` in the columns of an earlier block, those from `column` on:
///   L_RC J_C = (A_RC - sum_k L_Rk J_k L_Ck^T) L_CC^-T, k from where both blocks have begun.
template <class Number>
void solve_columns(const RowBlock<Number>& own, const RowBlock<Number>& earlier, std::size_t column)
{
    Eight<Number> columns[lanes];
    transpose(own, column, columns);
    const std::size_t first = std::max(own.first, earlier.first);
    if (first < column)
        for (std::size_t j = 0; j < lanes; ++j)
            columns[j] -= products_of(own, first, &earlier(j, first), column - first);
    for (std::size_t j = 0; j < lanes; ++j) {
        Eight<Number> solved = {};
        for (std::size_t k = 0; k <= j; ++k) solved += columns[k] * earlier(j, column + k);
        for (std::size_t i = 0; i < lanes; ++i) own(i, column + j) = solved[i];
    }
}

/// Factorise the triangle of a block, which begins in column `d`, with the signs of its pivots; 1/L(r, r) on
/// the diagonal.
template <class Number>
void factorise_triangle(const RowBlock<Number>& own, std::size_t d, const Number* signs, Number least_pivot)
{
    for (std::size_t r = 0; r < lanes; ++r) {
        Number* row = &own(r, d);
        Number pivot = signs[r] * row[r];
        for (std::size_t c = 0; c < r; ++c) {
            const Number* row_of_c = &own(c, d);
            Number sum = row[c];
            for (std::size_t k = 0; k < c; ++k) sum -= row[k] * signs[k] * row_of_c[k];
            row[c] = sum * row_of_c[c] * signs[c];
            pivot -= signs[r] * signs[c] * row[c] * row[c];
        }
        row[r] = Number{1} / std::sqrt(std::max(least_pivot, pivot));
    }
}

/// Replace the triangle T of a block, its diagonal inverted already, by T^-1:
///   T^-1(i, j) = - T^-1(i, i) sum_k T(i, k) T^-1(k, j), k from j to i - 1.
template <class Number>
void invert_triangle(const RowBlock<Number>& own, std::size_t d)
{
    for (std::size_t i = 0; i < lanes; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            Number sum = Number{0};
            for (std::size_t k = j; k < i; ++k) sum += own(i, d + k) * own(k, d + j);
            own(i, d + j) = -own(i, d + i) * sum;
        }
    }
}

/// Block by block, each from its first column on. `signs` are those of the pivots, `signed_rows` room for
/// eight rows of the widest block without its triangle.
template <class Number>
VECTOR_KERNEL void factorise_blocks(const FactorBlock* blocks, std::size_t count, const Number* signs,
                                    Number least_pivot, Number* lower, Number* signed_rows)
{
    for (std::size_t block = 0; block < count; ++block) {
        const std::size_t d = block * lanes; // the triangle's first column
        const RowBlock<Number> own = rows_of<Number>(blocks[block], lower);
        const std::size_t width = d - own.first;
        for (std::size_t column = own.first; column < d; column += lanes)
            solve_columns(own, rows_of<Number>(blocks[column / lanes], lower), column);
        const RowBlock<Number> with_signs{signed_rows, width, own.first};
        for (std::size_t i = 0; i < lanes; ++i)
            for (std::size_t column = own.first; column < d; column += lanes)
                store<Number>(load(&own(i, column)) * load(signs + column), &with_signs(i, column)); // L
        for (std::size_t j = 0; j < lanes; ++j) {
            const Eight<Number> sums = products_of(own, own.first, signed_rows + j * width, width);
            for (std::size_t i = j; i < lanes; ++i) own(i, d + j) -= sums[i];
        }
        for (std::size_t i = 0; i < lanes; ++i)
            std::copy_n(signed_rows + i * width, width, own.rows + i * own.stride);
        factorise_triangle(own, d, signs + d, least_pivot);
        invert_triangle(own, d);
    }
}

/// The eight rows of a block of L y = b, from the solved ones before; returns their y. `d` is the first one.
template <class Number>
Eight<Number> solve_lower_block(const RowBlock<const Number>& block, std::size_t d, Number* vector)
{
    Eight<Number> sums[lanes] = {};
    for (std::size_t column = block.first; column < d; column += lanes) {
        const Eight<Number> x = load(vector + column);
        for (std::size_t i = 0; i < lanes; ++i) sums[i] += load(&block(i, column)) * x;
    }
    const Eight<Number> rest = load(vector + d) - sums_of(sums);
    for (std::size_t i = 0; i < lanes; ++i) sums[i] = load(&block(i, d)) * rest;
    const Eight<Number> y = sums_of(sums);
    store<Number>(y, vector + d);
    return y;
}

template <class Number>
Number largest_of(const Eight<Number>& s)
{
    Number largest = 0;
    for (std::size_t i = 0; i < lanes; ++i) largest = std::max(largest, std::abs(s[i]));
    return largest;
}

template <class Number>
VECTOR_KERNEL std::size_t solve_lower_blocks(const FactorBlock* blocks, std::size_t count, std::size_t first,
                                             std::size_t last, std::size_t band, Number least,
                                             const Number* lower, Number* vector)
{
    std::size_t small = 0; // numbers in turn
    std::size_t d = first / lanes * lanes;
    for (; d < count * lanes && (d < last || small < band); d += lanes) {
        const RowBlock<const Number> block = rows_of<const Number>(blocks[d / lanes], lower);
        const Number largest = largest_of<Number>(solve_lower_block(block, d, vector));
        small = largest < least ? small + lanes : 0;
    }
    return d;
}

template <class Number>
VECTOR_KERNEL void solve_all_lower_blocks(const FactorBlock* blocks, std::size_t count, const Number* lower,
                                          Number* vector)
{
    for (std::size_t block = 0; block < count; ++block)
        solve_lower_block(rows_of(blocks[block], lower), block * lanes, vector);
}

template <class Number>
VECTOR_KERNEL void solve_upper_blocks(const FactorBlock* blocks, std::size_t count, const Number* signs,
                                      const Number* lower, Number* vector)
{
    for (std::size_t d = 0; d < count * lanes; d += lanes)
        store<Number>(load(vector + d) * load(signs + d), vector + d);
    for (std::size_t d = count * lanes; d > 0;) {
        d -= lanes;
        const RowBlock<const Number> block = rows_of(blocks[d / lanes], lower);
        Number* own = vector + d;
        Eight<Number> x = {};
        for (std::size_t i = 0; i < lanes; ++i) x += own[i] * load(&block(i, d));
        store<Number>(x, own);
        for (std::size_t column = block.first; column < d; column += lanes) {
            Eight<Number> rest = load(vector + column);
            for (std::size_t i = 0; i < lanes; ++i) rest -= x[i] * load(&block(i, column));
            store<Number>(rest, vector + column);
        }
    }
}

} // namespace

template <class Number>
void BandedFactor<Number>::reset(const std::vector<std::size_t>& first_columns)
{
    const std::size_t rows = first_columns.size(), count = (rows + lanes - 1) / lanes;
    blocks_.resize(count);
    band_ = 0;
    std::size_t numbers = 0;
    for (std::size_t block = 0; block < count; ++block) {
        const std::size_t d = block * lanes;
        std::size_t first = d;
        for (std::size_t row = d; row < std::min(d + lanes, rows); ++row) {
            first = std::min(first, first_columns[row] / lanes * lanes);
            band_ = std::max(band_, (row - first_columns[row] + lanes - 1) / lanes * lanes);
        }
        blocks_[block] = {numbers, first, d + lanes - first};
        numbers += lanes * blocks_[block].stride;
    }
    signs_.assign(count * lanes, Number{1});
    lower_.assign(numbers, Number{0});
    for (std::size_t row = rows; row < count * lanes; ++row) add(row, row, 1.0);
}

template <class Number>
void BandedFactor<Number>::factorise(Number least_pivot)
{
    std::vector<Number> signed_rows(lanes * band_);
    factorise_blocks(blocks_.data(), blocks_.size(), signs_.data(), least_pivot, lower_.data(),
                     signed_rows.data());
}

template <class Number>
void BandedFactor<Number>::solve_lower(Number* vector) const
{
    solve_all_lower_blocks(blocks_.data(), blocks_.size(), lower_.data(), vector);
}

template <class Number>
void BandedFactor<Number>::solve_upper(Number* vector) const
{
    solve_upper_blocks(blocks_.data(), blocks_.size(), signs_.data(), lower_.data(), vector);
}

template <class Number>
std::size_t BandedFactor<Number>::solve_lower(std::size_t first, std::size_t last, Number least,
                                              Number* vector) const
{
    return solve_lower_blocks(blocks_.data(), blocks_.size(), first, last, band_, least, lower_.data(),
                              vector);
}

template class BandedFactor<float>;
template class BandedFactor<double>;

} // namespace quicksand
