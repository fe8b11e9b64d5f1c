// Numbers of the command line: finite and within their range.
#pragma once

#include "io/keys/scene_schema.hpp"

#include <CLI/App.hpp>

namespace quicksand {

inline constexpr Interval any_number = {};
inline constexpr Interval positive_number = {.lower = 0.0, .lower_open = true};
inline constexpr Interval allowed_thread_count = {.lower = 1.0, .upper = 1024.0};

/// Refuses what is no finite number of the interval. CLI11's own ranges let nan pass.
CLI::Validator number_in(const Interval& interval);

} // namespace quicksand
