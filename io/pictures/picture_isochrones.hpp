// The plot of a profile probe: values over height, one curve a time.
#pragma once

#include "io/pictures/line_plot.hpp"
#include "io/pictures/picture_table.hpp"
#include "io/pictures/picture_ticks.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// Rows [begin, end) of a table that share one time.
struct ProfileRows {
    double time = 0.0; // [s]
    std::size_t begin = 0, end = 0;
};

/// Curves of a plot, at most.
inline constexpr std::size_t isochrone_count = 8;

/// At most `count` profiles at about even times, the first and the last among them.
std::vector<ProfileRows> choose_profiles(const std::vector<double>& times, std::size_t count);

/// Excess pore pressure (dry: mean effective stress) and horizontal displacement over height, or along a
/// flat profile over the distance from its start. None where there are no values.
std::optional<LinePlot> isochrone_plot(const PictureTable& table, const std::string& name);

} // namespace quicksand
