// What the exit codes mean, for the help and the manual page.
#pragma once

#include "app/run/choices.hpp"

#include <span>
#include <string_view>

namespace quicksand {

struct ExitMeaning {
    ExitCode code = ExitCode::good;
    std::string_view meaning;
};

/// All exit codes, in ascending order.
std::span<const ExitMeaning> exit_meanings();

} // namespace quicksand
