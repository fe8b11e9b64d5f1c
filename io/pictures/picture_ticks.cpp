#include "io/pictures/picture_ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace quicksand {
namespace {

// Fraction of a step by which rounding may miss a tick.
constexpr double slack = 1e-9;

double next_round_step(double least)
{
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * decade >= least * (1.0 - slack)) return digit * decade;
    return 10.0 * decade;
}

int decimals_of(double step)
{
    return std::max(0, static_cast<int>(-std::floor(std::log10(step) + slack)));
}

struct Prefix {
    int thousands;          // the prefix stands for 1000^thousands [-]
    std::string_view text;  // before a unit
    std::string_view power; // where there is no unit
};

constexpr std::array<Prefix, 7> prefixes{{{-3, "n", "10⁻⁹"},
                                          {-2, "µ", "10⁻⁶"},
                                          {-1, "m", "10⁻³"},
                                          {0, "", ""},
                                          {1, "k", "10³"},
                                          {2, "M", "10⁶"},
                                          {3, "G", "10⁹"}}};

Prefix prefix_for(double magnitude)
{
    if (!(magnitude > 0.0) || !std::isfinite(magnitude)) return prefixes[3];
    // 0.9995 of a unit prints as 1.00 of it rather than as 999.5 of the one below.
    const int thousands = static_cast<int>(std::floor(std::log10(magnitude / 0.9995) / 3.0));
    return prefixes[static_cast<std::size_t>(std::clamp(thousands, -3, 3) + 3)];
}

} // namespace

Ticks nice_ticks(const PlotRange& interval, int at_most)
{
    Ticks ticks;
    if (!(interval.width() > 0.0)) return ticks;
    ticks.step = next_round_step(interval.width() / std::max(1, at_most));
    double first = std::ceil(interval.low / ticks.step - slack);
    double last = std::floor(interval.high / ticks.step + slack);
    while (last - first + 1.0 > at_most) {
        ticks.step = next_round_step(1.01 * ticks.step);
        first = std::ceil(interval.low / ticks.step - slack);
        last = std::floor(interval.high / ticks.step + slack);
    }
    ticks.decimals = decimals_of(ticks.step);
    return ticks;
}

PlotRange round_limits(const PlotRange& interval)
{
    const double largest = std::max(std::abs(interval.low), std::abs(interval.high));
    if (interval.width() <= 1e-9 * largest || largest == 0.0) {
        const double half = largest > 0.0 ? 0.1 * largest : 1.0;
        return round_limits({interval.low - half, interval.high + half});
    }
    const double step = next_round_step(interval.width() / 10.0);
    return {step * std::floor(interval.low / step + slack), step * std::ceil(interval.high / step - slack)};
}

DisplayUnit display_unit(std::string_view unit, double magnitude)
{
    // Below a hundredth of a per cent the powers of ten read better.
    if (unit == "%") return magnitude >= 1e-4 ? DisplayUnit{0.01, "%"} : display_unit("", magnitude);
    // Ratios such as ru read best as they are.
    if (unit.empty() && magnitude >= 0.01 && magnitude < 1000.0) return {};
    const Prefix prefix = prefix_for(magnitude);
    const double factor = std::pow(1000.0, prefix.thousands);
    if (unit.empty()) return {factor, std::string(prefix.power)};
    return {factor, std::string(prefix.text) + std::string(unit)};
}

std::string label_with_unit(std::string_view label, const DisplayUnit& unit)
{
    return unit.text.empty() ? std::string(label) : fmt::format("{} [{}]", label, unit.text);
}

double largest_of(const std::vector<double>& values)
{
    double largest = -1.0;
    for (const double value : values)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    return largest;
}

std::vector<double> scaled(const std::vector<double>& values, const DisplayUnit& unit)
{
    std::vector<double> result(values.size());
    std::transform(values.begin(), values.end(), result.begin(),
                   [&unit](double value) { return value / unit.factor; });
    return result;
}

} // namespace quicksand
