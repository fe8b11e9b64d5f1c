// How unlike two soils are: which of them bears where one is a thin layer in the other.
#pragma once

#include "solver/problem/skeleton_law.hpp"

#include <cstdint>

namespace quicksand {

enum class Contrast : std::uint8_t {
    none,        // they are alike
    unlike,      // neither clearly bears more than the other
    first_bears, // it is clearly stiffer, or of like stiffness and stronger
    second_bears,
};

/// By the moduli of unloading at one atmosphere, from 1.5 on clearly, and by the lines of failure.
Contrast contrast_between(const SkeletonLaw& first, const SkeletonLaw& second);

} // namespace quicksand
