// Powers and exponentials of 2 without tables and branches, so that loops over points vectorise. The same
// operations in the same order give the same bits in a vector and alone.
#pragma once

#include <bit>
#include <cstdint>

namespace quicksand::ubcsand {

/// log2(x) for a normal x > 0, to 2e-15 of its magnitude or absolutely.
inline double logarithm_2(double x)
{
    // x = 2^k m, m from sqrt(1/2) to sqrt(2): subtracting the bits of sqrt(1/2) carries into k what is above
    constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd, mantissa = 0x000fffffffffffff;
    constexpr std::uint64_t two_to_52 = 0x4330000000000000;
    const std::uint64_t shifted = std::bit_cast<std::uint64_t>(x) + (0x3ff0000000000000 - root_half);
    const double k = std::bit_cast<double>((shifted >> 52) | two_to_52) - (0x1p52 + 1023.0);
    const double m = std::bit_cast<double>((shifted & mantissa) + root_half);
    // ln m = 2 (z + z^3/3 + z^5/5 + ...), z = (m - 1)/(m + 1), |z| < 0.172
    const double z = (m - 1.0) / (m + 1.0), y = z * z;
    const double y_2 = y * y, y_4 = y_2 * y_2; // pairs of terms, and pairs of those: a short chain
    const double low = (1.0 + y * (1.0 / 3)) + y_2 * (1.0 / 5 + y * (1.0 / 7));
    const double middle = (1.0 / 9 + y * (1.0 / 11)) + y_2 * (1.0 / 13 + y * (1.0 / 15));
    const double series = low + y_4 * (middle + y_4 * (1.0 / 17 + y * (1.0 / 19)));
    return k + 2.885390081777926815 * z * series; // 2/ln 2
}

/// 2^x for x from -1000 to 1000, to 3e-16 of its value.
inline double exponential_2(double x)
{
    // x = k + f, |f| <= 1/2: adding 1.5 x 2^52 leaves k in the lowest bits
    constexpr double shift = 0x1.8p52;
    const double shifted = x + shift;
    const double u = (x - (shifted - shift)) * 0.693147180559945309; // f ln 2
    const double scale = std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) << 52) +
                                               std::bit_cast<std::uint64_t>(1.0));
    const double u_2 = u * u, u_4 = u_2 * u_2;
    const double low = (0.5 + u * (1.0 / 6)) + u_2 * (1.0 / 24 + u * (1.0 / 120));
    const double middle = (1.0 / 720 + u * (1.0 / 5040)) + u_2 * (1.0 / 40320 + u * (1.0 / 362880));
    const double high =
        (1.0 / 3628800 + u * (1.0 / 39916800)) + u_2 * (1.0 / 479001600 + u * (1.0 / 6227020800));
    return scale * (1.0 + (u + u_2 * (low + u_4 * (middle + u_4 * high))));
}

/// x^exponent for a normal x > 0 and |exponent log2 x| < 1000.
inline double power(double x, double exponent)
{
    return exponential_2(exponent * logarithm_2(x));
}

} // namespace quicksand::ubcsand
