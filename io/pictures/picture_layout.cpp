#include "io/pictures/picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

namespace quicksand {
namespace {

// Room around the section [pixel].
constexpr double left_margin = 112.0;  // label and tick labels of y
constexpr double right_margin = 190.0; // colour bar with its labels
constexpr double top_margin = 98.0;    // title and note
constexpr double bottom_margin = 84.0; // label and tick labels of x
constexpr double largest_width = 1600.0 - left_margin - right_margin;
constexpr double largest_height = 900.0 - top_margin - bottom_margin;
constexpr double smallest_width = 470.0; // that leaves the title its room
constexpr double smallest_height = 260.0;

struct Extent {
    PlotRange x{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    PlotRange y = x;

    void include(const std::vector<DomainCorners>& domains)
    {
        for (const DomainCorners& domain : domains)
            for (const Vector2& corner : domain) include(corner);
    }
    void include(const Vector2& point)
    {
        x = {std::min(x.low, point.x()), std::max(x.high, point.x())};
        y = {std::min(y.low, point.y()), std::max(y.high, point.y())};
    }
};

Extent visible_extent(const FieldPicture& picture)
{
    Extent extent;
    extent.include(picture.domains);
    extent.include(picture.initial_domains);
    if (extent.x.width() < 0.0) extent.x = extent.y = {0.0, 1.0};
    const double size = std::max({extent.x.width(), extent.y.width(), 1e-12});
    const double rim = 0.03 * size;
    extent.x = {extent.x.low - rim, extent.x.high + rim};
    extent.y = {extent.y.low - rim, extent.y.high + rim};
    return extent;
}

PlotRange widen(const PlotRange& interval, double width)
{
    const double more = std::max(0.0, 0.5 * (width - interval.width()));
    return {interval.low - more, interval.high + more};
}

/// The extremes, or where they are far out the quantiles at 0.5 and 99.5 per cent.
PlotRange bulk_of(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const PlotRange all{values.front(), values.back()};
    const std::size_t cut = values.size() / 200;
    const PlotRange bulk{values[cut], values[values.size() - 1 - cut]};
    const double reach = 0.5 * bulk.width();
    return {all.low < bulk.low - reach ? bulk.low : all.low,
            all.high > bulk.high + reach ? bulk.high : all.high};
}

PlotRange automatic_limits(const PlotRange& values, ColourMap colours)
{
    if (colours == ColourMap::diverging) {
        const double largest = std::max(std::abs(values.low), std::abs(values.high));
        const double limit = largest > 0.0 ? round_limits({0.0, largest}).high : 1.0;
        return {-limit, limit};
    }
    if (values.low == 0.0 && values.high == 0.0) return {0.0, 1.0};
    if (values.low >= 0.0 && values.low < 0.5 * values.high) return round_limits({0.0, values.high});
    return round_limits(values);
}

} // namespace

PictureLayout lay_out_picture(const FieldPicture& picture)
{
    const Extent extent = visible_extent(picture);
    PictureLayout layout;
    const double scale = std::min(largest_width / extent.x.width(), largest_height / extent.y.width());
    layout.x = widen(extent.x, smallest_width / scale);
    layout.y = widen(extent.y, smallest_height / scale);
    // Frame and sheet on whole pixels, so that their lines are crisp.
    layout.axes = {left_margin, top_margin, std::round(layout.x.width() * scale),
                   std::round(layout.y.width() * scale)};
    layout.width = layout.axes.right() + right_margin;
    layout.height = layout.axes.bottom() + bottom_margin;
    return layout;
}

ColourRange choose_colour_range(const FieldPicture& picture)
{
    std::vector<double> values;
    std::copy_if(picture.values.begin(), picture.values.end(), std::back_inserter(values),
                 [](double value) { return std::isfinite(value); });
    if (values.empty()) return {picture.range.value_or(PlotRange{0.0, 1.0}), false, false};

    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const PlotRange extremes{*low, *high};
    ColourRange range;
    range.limits = picture.range ? *picture.range : automatic_limits(bulk_of(values), picture.colours);
    const double slack = 1e-6 * range.limits.width();
    range.beyond_low = extremes.low < range.limits.low - slack;
    range.beyond_high = extremes.high > range.limits.high + slack;
    return range;
}

std::vector<DomainCorners> exaggerate(const std::vector<DomainCorners>& initial,
                                      const std::vector<DomainCorners>& present, double factor)
{
    std::vector<DomainCorners> drawn = present;
    for (std::size_t p = 0; p < std::min(initial.size(), drawn.size()); ++p)
        for (std::size_t k = 0; k < drawn[p].size(); ++k)
            drawn[p][k] = initial[p][k] + factor * (present[p][k] - initial[p][k]);
    return drawn;
}

} // namespace quicksand
