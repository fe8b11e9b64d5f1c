// Random scenes: whole ones with their drawings, that anyone can run again by hand.
#pragma once

#include "app/stress/scenes/stress_row.hpp"

#include <cstdint>

namespace quicksand {

/// The scene of this number among those of a seed, the same whatever the others are. With water that flows it
/// is two rows, one a scheme, each the twin of the other.
StressRows random_rows(std::uint64_t seed, int number);

} // namespace quicksand
