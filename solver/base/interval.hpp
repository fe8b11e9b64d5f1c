// An interval of numbers, with its bounds or without.
#pragma once

#include <limits>

namespace quicksand {

struct Interval {
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    bool lower_open = false; // the bound itself is excluded
    bool upper_open = false;

    bool contains(double value) const
    {
        return (lower_open ? value > lower : value >= lower) && (upper_open ? value < upper : value <= upper);
    }
};

} // namespace quicksand
