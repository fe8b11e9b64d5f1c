// What no record of an earthquake goes beyond, models in a centrifuge included.
#pragma once

#include "solver/base/conventions.hpp"

namespace quicksand {

inline constexpr double largest_acceleration = 1000.0 * standard_gravity; // that is read [m/s2]
inline constexpr const char* allowed_accelerations = "at most 1000 g in amount";
inline constexpr double longest_interval = 10.0; // between values, that is read [s]

/// Beyond these a record is unusual. In a field of n g the acceleration is n times as large, the interval n
/// times as short. The largest peak recorded so far is some 4 g.
inline constexpr double usual_acceleration = 2.0 * standard_gravity; // [m/s2]
inline constexpr double usual_interval = 0.1;                        // [s]

/// Of a history that a load or a motion of a boundary is multiplied by [-].
inline constexpr double largest_factor = 1e12;

} // namespace quicksand
