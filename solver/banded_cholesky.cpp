#include "solver/banded_cholesky.hpp"

#include "solver/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace quicksand {

namespace {

using Singles = float __attribute__((vector_size(32)));

Singles load(const float* from)
{
    Singles singles;
    std::memcpy(&singles, from, sizeof singles);
    return singles;
}

float sum_of(const Singles& s)
{
    return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

/// Sum of a[k] b[k] over `count` numbers.
float dot(const float* a, const float* b, std::size_t count)
{
    Singles even{}, odd{};
    std::size_t k = 0;
    for (; k + 16 <= count; k += 16) {
        even += load(a + k) * load(b + k);
        odd += load(a + k + 8) * load(b + k + 8);
    }
    if (k + 8 <= count) {
        even += load(a + k) * load(b + k);
        k += 8;
    }
    float sum = sum_of(even + odd);
    for (; k < count; ++k) sum += a[k] * b[k];
    return sum;
}

VECTOR_KERNEL
void factorise_band(std::size_t rows, std::size_t band, float least_pivot, float* lower, float* diagonal)
{
    for (std::size_t r = 0; r < rows; ++r) {
        float* row = lower + r * band;
        const std::size_t first = r < band ? band - r : 0; // numbers before the first column are zero
        for (std::size_t k = first; k < band; ++k) {
            const std::size_t column = r + k - band;
            row[k] = (row[k] - dot(row, lower + column * band + band - k, k)) * diagonal[column];
        }
        const float pivot = std::max(least_pivot, diagonal[r] - dot(row, row, band));
        diagonal[r] = 1.0f / std::sqrt(pivot);
    }
}

VECTOR_KERNEL
void solve_band(std::size_t rows, std::size_t band, const float* lower, const float* diagonal, float* vector)
{
    for (std::size_t r = 0; r < rows; ++r) {
        float& x = vector[band + r];
        x = (x - dot(lower + r * band, vector + r, band)) * diagonal[r];
    }
    for (std::size_t r = rows; r-- > 0;) {
        const float x = vector[band + r] * diagonal[r];
        vector[band + r] = x;
        const float* row = lower + r * band;
        for (std::size_t k = 0; k < band; k += BandedCholesky::lanes) {
            const Singles rest = load(vector + r + k) - x * load(row + k);
            std::memcpy(vector + r + k, &rest, sizeof rest);
        }
    }
}

} // namespace

void BandedCholesky::reset(std::size_t rows, std::size_t band)
{
    rows_ = rows;
    band_ = (band + lanes - 1) / lanes * lanes;
    lower_.assign(rows_ * band_, 0.0f);
    diagonal_.assign(rows_, 0.0f);
}

void BandedCholesky::factorise(float least_pivot)
{
    factorise_band(rows_, band_, least_pivot, lower_.data(), diagonal_.data());
}

void BandedCholesky::solve(float* vector) const
{
    solve_band(rows_, band_, lower_.data(), diagonal_.data(), vector);
}

} // namespace quicksand
