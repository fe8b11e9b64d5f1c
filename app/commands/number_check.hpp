// Numbers of the command line: finite and within their range.
#pragma once

#include "io/keys/scene_schema.hpp"

#include <CLI/CLI.hpp>

#include <cmath>
#include <string>

namespace quicksand {

inline constexpr Interval any_number = {};
inline constexpr Interval positive_number = {.lower = 0.0, .lower_open = true};
inline constexpr Interval thread_number = {.lower = 1.0, .upper = 1024.0};

/// Refuses what is no finite number of the interval. CLI11's own ranges let nan pass.
inline CLI::Validator number_in(const Interval& interval)
{
    const std::string allowed = describe(interval, Dimension::none);
    const auto refusal = [interval, allowed](std::string& word) -> std::string {
        double number = 0.0;
        const bool finite = CLI::detail::lexical_cast(word, number) && std::isfinite(number);
        if (finite && interval.contains(number)) return "";
        return word + (finite ? " is out of range" : " is not a finite number") + "\nexpected: " + allowed;
    };
    return {refusal, allowed};
}

} // namespace quicksand
