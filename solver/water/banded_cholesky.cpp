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

/// Eight rows of a block: row i from `rows + i stride` on.
template <class Number>
struct RowBlock {
    Number* rows;
    std::size_t stride;

    Number& operator()(std::size_t i, std::size_t k) const { return rows[i * stride + k]; }
};

/// The products of eight rows with another, over `count` numbers.
template <class Number>
Eight<Number> products_of(const RowBlock<Number>& a, const Number* b, std::size_t count)
{
    Eight<Number> sums[lanes] = {};
    for (std::size_t k = 0; k < count; k += lanes) {
        const Eight<Number> x = load(b + k);
        for (std::size_t i = 0; i < lanes; ++i) sums[i] += load(&a(i, k)) * x;
    }
    return sums_of(sums);
}

/// Columns of a block of 8 x 8 from its rows, or the other way round.
template <class Number>
void transpose(const RowBlock<Number>& rows, std::size_t first, Eight<Number> (&columns)[lanes])
{
    for (std::size_t j = 0; j < lanes; ++j)
        for (std::size_t i = 0; i < lanes; ++i) columns[j][i] = rows(i, first + j);
}

/// L J of the block `own` in the columns of an earlier block, `before` being the numbers left of them:
///   L_RC J_C = (A_RC - sum_k L_Rk J_k L_Ck^T) L_CC^-T.
template <class Number>
void solve_columns(const RowBlock<Number>& own, const RowBlock<Number>& earlier, std::size_t before,
                   std::size_t band)
{
    Eight<Number> columns[lanes];
    transpose(own, before, columns);
    for (std::size_t j = 0; j < lanes; ++j)
        columns[j] -= products_of(own, &earlier(j, band - before), before);
    for (std::size_t j = 0; j < lanes; ++j) {
        Eight<Number> solved = {};
        for (std::size_t k = 0; k <= j; ++k) solved += columns[k] * earlier(j, band + k);
        for (std::size_t i = 0; i < lanes; ++i) own(i, before + j) = solved[i];
    }
}

/// Factorise the triangle T of a block with the signs of its pivots; 1/L(r, r) on the diagonal.
template <class Number>
void factorise_triangle(const RowBlock<Number>& own, std::size_t band, const Number* signs,
                        Number least_pivot)
{
    for (std::size_t r = 0; r < lanes; ++r) {
        Number* row = &own(r, band);
        Number pivot = signs[r] * row[r];
        for (std::size_t c = 0; c < r; ++c) {
            const Number* row_of_c = &own(c, band);
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
void invert_triangle(const RowBlock<Number>& own, std::size_t band)
{
    for (std::size_t i = 0; i < lanes; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            Number sum = Number{0};
            for (std::size_t k = j; k < i; ++k) sum += own(i, band + k) * own(k, band + j);
            own(i, band + j) = -own(i, band + i) * sum;
        }
    }
}

/// Block by block, each from its first column on. `signs` are those of the pivots, `signed_rows` room for
/// eight rows without their last eight columns.
template <class Number>
VECTOR_KERNEL void factorise_blocks(std::size_t rows, std::size_t band, const Number* signs,
                                    Number least_pivot, Number* lower, Number* signed_rows)
{
    const std::size_t stride = band + lanes;
    for (std::size_t r = 0; r < rows; r += lanes) {
        const RowBlock<Number> own{lower + r * stride, stride}; // column c is number c + band - r
        for (std::size_t before = r < band ? band - r : 0; before < band; before += lanes)
            solve_columns(own, RowBlock<Number>{lower + (r + before - band) * stride, stride}, before, band);
        const RowBlock<Number> with_signs{signed_rows, band};
        for (std::size_t i = 0; i < lanes; ++i) {
            for (std::size_t k = 0; k < band; k += lanes)
                store<Number>(r + k < band ? Eight<Number>{}
                                           : load(&own(i, k)) * load(signs + (r + k - band)),
                              &with_signs(i, k)); // L
        }
        for (std::size_t j = 0; j < lanes; ++j) {
            const Eight<Number> sums = products_of(own, &with_signs(j, 0), band);
            for (std::size_t i = j; i < lanes; ++i) own(i, band + j) -= sums[i];
        }
        for (std::size_t i = 0; i < lanes; ++i)
            for (std::size_t k = 0; k < band; k += lanes) store<Number>(load(&with_signs(i, k)), &own(i, k));
        factorise_triangle(own, band, signs + r, least_pivot);
        invert_triangle(own, band);
    }
}

/// The eight rows of a block of L y = b, from the solved ones before; returns their y.
template <class Number>
Eight<Number> solve_lower_block(std::size_t r, std::size_t band, const Number* lower, Number* vector)
{
    const std::size_t stride = band + lanes;
    const Number* block = lower + r * stride;
    Number* own = vector + band + r;
    Eight<Number> sums[lanes] = {};
    for (std::size_t k = 0; k < band; k += lanes) {
        const Eight<Number> x = load(vector + r + k);
        for (std::size_t i = 0; i < lanes; ++i) sums[i] += load(block + i * stride + k) * x;
    }
    const Eight<Number> rest = load(own) - sums_of(sums);
    for (std::size_t i = 0; i < lanes; ++i) sums[i] = load(block + i * stride + band) * rest;
    const Eight<Number> y = sums_of(sums);
    store<Number>(y, own);
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
VECTOR_KERNEL std::size_t solve_lower_blocks(std::size_t first, std::size_t last, std::size_t rows,
                                             std::size_t band, Number least, const Number* lower,
                                             Number* vector)
{
    std::size_t small = 0; // numbers in turn
    std::size_t r = first / lanes * lanes;
    for (; r < rows && (r < last || small < band); r += lanes) {
        const Number largest = largest_of<Number>(solve_lower_block(r, band, lower, vector));
        small = largest < least ? small + lanes : 0;
    }
    return r;
}

template <class Number>
VECTOR_KERNEL void solve_blocks(std::size_t rows, std::size_t band, const Number* signs, const Number* lower,
                                Number* vector)
{
    const std::size_t stride = band + lanes;
    for (std::size_t r = 0; r < rows; r += lanes) solve_lower_block(r, band, lower, vector); // L y = b
    for (std::size_t r = 0; r < rows; r += lanes)
        store<Number>(load(vector + band + r) * load(signs + r), vector + band + r);
    for (std::size_t r = rows; r > 0;) { // L^T x = J y
        r -= lanes;
        const Number* block = lower + r * stride;
        Number* own = vector + band + r;
        Eight<Number> x = {};
        for (std::size_t i = 0; i < lanes; ++i) x += own[i] * load(block + i * stride + band);
        store<Number>(x, own);
        for (std::size_t k = 0; k < band; k += lanes) {
            Eight<Number> rest = load(vector + r + k);
            for (std::size_t i = 0; i < lanes; ++i) rest -= x[i] * load(block + i * stride + k);
            store<Number>(rest, vector + r + k);
        }
    }
}

} // namespace

template <class Number>
void BandedFactor<Number>::reset(std::size_t rows, std::size_t band)
{
    rows_ = rows;
    band_ = (band + lanes - 1) / lanes * lanes;
    signs_.clear();
    lower_.assign(padded_rows() * (band_ + lanes), Number{0});
    for (std::size_t row = rows_; row < padded_rows(); ++row) add(row, row, 1.0);
}

template <class Number>
void BandedFactor<Number>::factorise(Number least_pivot)
{
    signs_.resize(padded_rows(), Number{1});
    std::vector<Number> signed_rows(lanes * band_);
    factorise_blocks(padded_rows(), band_, signs_.data(), least_pivot, lower_.data(), signed_rows.data());
}

template <class Number>
void BandedFactor<Number>::solve(Number* vector) const
{
    solve_blocks(padded_rows(), band_, signs_.data(), lower_.data(), vector);
}

template <class Number>
std::size_t BandedFactor<Number>::solve_lower(std::size_t first, std::size_t last, Number least,
                                              Number* vector) const
{
    return solve_lower_blocks(first, last, padded_rows(), band_, least, lower_.data(), vector);
}

template class BandedFactor<float>;
template class BandedFactor<double>;

} // namespace quicksand
