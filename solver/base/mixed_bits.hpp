// Numbers that look random and are the same on every machine.
#pragma once

#include <cstdint>

namespace quicksand {

/// What the state of the sequence grows by from number to number.
inline constexpr std::uint64_t golden_increment = 0x9e3779b97f4a7c15U;

/// The next number of splitmix64 from its state: neighbouring states give unlike numbers (Steele, Lea and
/// Flood 2014).
inline std::uint64_t mixed_bits(std::uint64_t state)
{
    std::uint64_t x = state + golden_increment;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

} // namespace quicksand
