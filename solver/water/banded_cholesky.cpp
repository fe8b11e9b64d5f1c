#include "solver/water/banded_cholesky.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/singles.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// The sum of each of eight vectors.
Singles sums_of(const Singles (&s)[8])
{
    const auto add_pairs = [](const Singles& a, const Singles& b) {
        return __builtin_shufflevector(a, b, 0, 2, 8, 10, 4, 6, 12, 14) +
               __builtin_shufflevector(a, b, 1, 3, 9, 11, 5, 7, 13, 15);
    };
    const Singles low = add_pairs(add_pairs(s[0], s[1]), add_pairs(s[2], s[3]));
    const Singles high = add_pairs(add_pairs(s[4], s[5]), add_pairs(s[6], s[7]));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 8, 9, 10, 11) +
           __builtin_shufflevector(low, high, 4, 5, 6, 7, 12, 13, 14, 15);
}

/// Row by row, each from its first column on; the rows are those of BandedCholesky, with 1/L(r, r) on the
/// diagonal.
VECTOR_KERNEL
void factorise_rows(std::size_t rows, std::size_t band, float least_pivot, float* lower)
{
    constexpr std::size_t lanes = BandedCholesky::lanes;
    const std::size_t stride = band + lanes;
    for (std::size_t r = 0; r < rows; ++r) {
        const std::size_t block = r / lanes * lanes;
        float* row = lower + r * stride; // column c is number c + band - block
        for (std::size_t c = r < band ? 0 : r - band; c < r; ++c) {
            const std::size_t before = c + band - block; // columns left of c
            const std::size_t block_of_c = c / lanes * lanes;
            const float* row_of_c = lower + c * stride + block - block_of_c;
            row[before] = (row[before] - dot(row, row_of_c, before)) * row_of_c[before];
        }
        const std::size_t before = r + band - block;
        const float pivot = std::max(least_pivot, row[before] - dot(row, row, before));
        row[before] = 1.0f / std::sqrt(pivot);
    }
}

/// Replace the triangle T of a block, its diagonal inverted already, by T^-1:
///   T^-1(i, j) = - T^-1(i, i) sum_k T(i, k) T^-1(k, j), k from j to i - 1.
void invert_triangle(std::size_t stride, float* triangle)
{
    for (std::size_t i = 0; i < BandedCholesky::lanes; ++i) {
        float* row = triangle + i * stride;
        for (std::size_t j = 0; j < i; ++j) {
            float sum = 0.0f;
            for (std::size_t k = j; k < i; ++k) sum += row[k] * triangle[k * stride + j];
            row[j] = -row[i] * sum;
        }
    }
}

/// The eight rows of a block of L y = b, from the solved ones before; returns their y.
inline Singles solve_lower_block(std::size_t r, std::size_t band, const float* lower, float* vector)
{
    constexpr std::size_t lanes = BandedCholesky::lanes;
    const std::size_t stride = band + lanes;
    const float* block = lower + r * stride;
    float* own = vector + band + r;
    Singles sums[lanes] = {};
    for (std::size_t k = 0; k < band; k += lanes) {
        const Singles x = load(vector + r + k);
        for (std::size_t i = 0; i < lanes; ++i) sums[i] += load(block + i * stride + k) * x;
    }
    const Singles rest = load(own) - sums_of(sums);
    for (std::size_t i = 0; i < lanes; ++i) sums[i] = load(block + i * stride + band) * rest;
    const Singles y = sums_of(sums);
    store(y, own);
    return y;
}

float largest_of(const Singles& s)
{
    float largest = 0.0f;
    for (std::size_t i = 0; i < BandedCholesky::lanes; ++i) largest = std::max(largest, std::abs(s[i]));
    return largest;
}

VECTOR_KERNEL
std::size_t solve_lower_blocks(std::size_t first, std::size_t last, std::size_t rows, std::size_t band,
                               float least, const float* lower, float* vector)
{
    constexpr std::size_t lanes = BandedCholesky::lanes;
    std::size_t small = 0; // numbers in turn
    std::size_t r = first / lanes * lanes;
    for (; r < rows && (r < last || small < band); r += lanes) {
        const float largest = largest_of(solve_lower_block(r, band, lower, vector));
        small = largest < least ? small + lanes : 0;
    }
    return r;
}

VECTOR_KERNEL
void solve_blocks(std::size_t rows, std::size_t band, const float* lower, float* vector)
{
    constexpr std::size_t lanes = BandedCholesky::lanes;
    const std::size_t stride = band + lanes;
    for (std::size_t r = 0; r < rows; r += lanes) solve_lower_block(r, band, lower, vector); // L y = b
    for (std::size_t r = rows; r > 0;) {                                                     // L^T x = y
        r -= lanes;
        const float* block = lower + r * stride;
        float* own = vector + band + r;
        Singles x = {};
        for (std::size_t i = 0; i < lanes; ++i) x += own[i] * load(block + i * stride + band);
        store(x, own);
        for (std::size_t k = 0; k < band; k += lanes) {
            Singles rest = load(vector + r + k);
            for (std::size_t i = 0; i < lanes; ++i) rest -= x[i] * load(block + i * stride + k);
            store(rest, vector + r + k);
        }
    }
}

} // namespace

void BandedCholesky::reset(std::size_t rows, std::size_t band)
{
    rows_ = rows;
    band_ = (band + lanes - 1) / lanes * lanes;
    lower_.assign(padded_rows() * (band_ + lanes), 0.0f);
    for (std::size_t row = rows_; row < padded_rows(); ++row) add(row, row, 1.0);
}

void BandedCholesky::factorise(float least_pivot)
{
    factorise_rows(padded_rows(), band_, least_pivot, lower_.data());
    const std::size_t stride = band_ + lanes;
    for (std::size_t r = 0; r < rows_; r += lanes) invert_triangle(stride, &lower_[r * stride + band_]);
}

void BandedCholesky::solve(float* vector) const
{
    solve_blocks(padded_rows(), band_, lower_.data(), vector);
}

std::size_t BandedCholesky::solve_lower(std::size_t first, std::size_t last, float least, float* vector) const
{
    return solve_lower_blocks(first, last, padded_rows(), band_, least, lower_.data(), vector);
}

} // namespace quicksand
