// A verification study runs an assembled problem and compares it with what is known of it.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// One measured error, relative to what `norm` says [-].
struct StudyError {
    std::string quantity; // as "pressure at T = 0.1"; the same in every resolution
    std::string norm;     // as "L2 / load"
    double error = 0.0;
};

/// What a study cannot read off a problem.
struct StudyParameters {
    std::optional<double> amplitude; // of a manufactured motion [m] or [rad]; none: that of the published one
};

/// A study reads the parameters of its closed form off the problem and the state it is given, so that the
/// reference follows a scene that is changed. It throws InputError where the problem is not one that it knows
/// and NumericalError where the run fails.
struct Study {
    std::string_view name;      // as [verification] problem = "name"
    std::string_view reference; // author, year
    std::vector<StudyError> (*measure)(const Problem& problem, State state,
                                       const StudyParameters& parameters);
};

/// All studies, by name.
const std::vector<Study>& studies();

/// The study of this name; null when there is none.
const Study* find_study(std::string_view name);

} // namespace quicksand
