// Random scenes: whole ones with their drawings, that anyone can run again by hand.
#pragma once

#include "app/stress/scenes/stress_row.hpp"

#include <cstdint>

namespace quicksand {

/// The scene of this number among those of a seed, the same whatever the others are: a row for each scheme
/// that suits its water. The semi-implicit one is the twin of the explicit one; implicit steps need not
/// follow the waves of a sudden load, and have no twin.
StressRows random_rows(std::uint64_t seed, int number);

} // namespace quicksand
