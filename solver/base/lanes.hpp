// Four doubles worked on together, and kernels that exist in two or three versions of the same bits.
//
// The arithmetic of lanes is element by element, and fused multiply-adds are off, so that a kernel gives the
// same bits whether the machine takes eight doubles at once (AVX-512), four (AVX2) or two (baseline x86-64).
#pragma once

#include <cstdint>
#include <cstring>

/// A kernel with all its calls inlined, compiled for the baseline and for AVX2; chosen when the program
/// starts.
#if defined(__GNUC__) && !defined(__clang__)
#define VECTOR_KERNEL [[gnu::flatten, gnu::target_clones("avx2", "default")]]
#else
#define VECTOR_KERNEL
#endif

/// The same, and for AVX-512: for loops over eight points at once. Kernels of four lanes gain nothing by it.
#if defined(__GNUC__) && !defined(__clang__)
#define WIDE_VECTOR_KERNEL [[gnu::flatten, gnu::target_clones("arch=x86-64-v4", "avx2", "default")]]
#else
#define WIDE_VECTOR_KERNEL
#endif

namespace quicksand {

using Lanes = double __attribute__((vector_size(32)));

inline Lanes load_lanes(const double* from)
{
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

inline void store_lanes(const Lanes& lanes, double* to)
{
    std::memcpy(to, &lanes, sizeof lanes);
}

inline Lanes all_lanes(double value)
{
    return Lanes{value, value, value, value};
}

inline Lanes absolute(const Lanes& lanes)
{
    using Bits = std::int64_t __attribute__((vector_size(32)));
    constexpr std::int64_t magnitude = std::int64_t{0x7fffffffffffffff};
    return reinterpret_cast<Lanes>(reinterpret_cast<Bits>(lanes) &
                                   Bits{magnitude, magnitude, magnitude, magnitude});
}

/// Negative lanes become zero.
inline Lanes positive_part(const Lanes& lanes)
{
    const Lanes zero = all_lanes(0.0);
    return lanes > zero ? lanes : zero;
}

} // namespace quicksand
