// Round numbers for axes: ticks, limits, labels, and units with an SI prefix.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// A closed range of values, low <= high.
struct PlotRange {
    double low = 0.0, high = 1.0;
    double width() const { return high - low; }
};

/// Ticks at the multiples of a step that is 1, 2 or 5 times a power of ten.
struct Ticks {
    double step = 1.0;
    int decimals = 0; // that tell neighbouring ticks apart [-]
};

/// At most `at_most` (>= 2) ticks inside the interval.
Ticks nice_ticks(const PlotRange& interval, int at_most);

/// The interval widened to round limits; an empty one is opened around its value.
PlotRange round_limits(const PlotRange& interval);

/// How a quantity is shown: value / factor, in `text`.
struct DisplayUnit {
    double factor = 1.0;
    std::string text; // "kPa", "10⁻³" for small dimensionless numbers, "" for plain ones
};

/// The SI prefix (or power of a thousand) that brings `magnitude`, in `unit`, to 1 .. 1000. "%" is asked for
/// with the unit "%" and a magnitude as a plain ratio; tiny ones get a power of ten all the same.
DisplayUnit display_unit(std::string_view unit, double magnitude);

/// "Excess pore pressure [kPa]", without brackets where the unit has no text.
std::string label_with_unit(std::string_view label, const DisplayUnit& unit);

/// The largest magnitude among the finite values, -1 where there is none.
double largest_of(const std::vector<double>& values);

/// The values in the unit shown.
std::vector<double> scaled(const std::vector<double>& values, const DisplayUnit& unit);

} // namespace quicksand
