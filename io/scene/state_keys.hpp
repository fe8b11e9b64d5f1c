// What a run's state hangs on: all keys of its scene but those that only end a stage or report on it.
#pragma once

#include "io/keys/scene_check.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// Whether a run may go on with another value of the key: texts, figures, where a stage ends, and when
/// results are written. Steps that end at other times of output differ in their last digits.
bool only_stops_or_reports(std::string_view path);

/// The values of all other keys, line by line: equal texts are of runs that can go on from each other.
std::string state_text(const std::vector<ResolvedKey>& keys);

/// The keys that the state hangs on and whose values differ, as "materials.sand.porosity: 0.4 -> 0.42".
std::vector<std::string> state_changes(const std::vector<ResolvedKey>& before,
                                       const std::vector<ResolvedKey>& now);

/// The other keys whose values differ, likewise.
std::vector<std::string> report_changes(const std::vector<ResolvedKey>& before,
                                        const std::vector<ResolvedKey>& now);

} // namespace quicksand
