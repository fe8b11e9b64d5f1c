#include "solver/faces/water_condition.hpp"

#include "solver/base/overload.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// y of the water's surface at x [m].
double surface_of(const std::optional<WaterLine>& line, const StillWater& still, double x)
{
    return line ? elevation(line->points, x) : still.level;
}

/// Excess of water up to a height at height y [Pa].
double excess_below(const StillWater& still, double surface, double y)
{
    return pressure_below(still, surface, y) - pressure_below(still, still.level, y);
}

double excess_of(const std::optional<WaterLine>& line, const StillWater& still, const Vector2& point)
{
    return excess_below(still, surface_of(line, still, point.x()), point.y());
}

double excess_of(const PrescribedWater& water, const StillWater& still, const Vector2& point, double factor)
{
    if (const auto* given = std::get_if<WaterHead>(&water.value)) {
        const double at_rest = surface_of(water.at_rest, still, point.x());
        return excess_below(still, at_rest + factor * (given->head - at_rest), point.y());
    }
    const double at_rest = excess_of(water.at_rest, still, point);
    const double full =
        std::get<PorePressure>(water.value).pressure - pressure_below(still, still.level, point.y());
    return at_rest + factor * (full - at_rest);
}

} // namespace

double elevation(const std::vector<Vector2>& line, double x)
{
    const auto right = std::find_if(line.begin(), line.end(), [&](const Vector2& p) { return p.x() >= x; });
    if (right == line.begin()) return line.front().y();
    if (right == line.end()) return line.back().y();
    const Vector2 &b = *right, &a = *(right - 1);
    return a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x());
}

double pressure_below(const StillWater& still, double surface, double y)
{
    return still.unit_weight * std::max(0.0, surface - y);
}

WaterHold water_held_by(const WaterCondition& water, GrainHold grains)
{
    if (!std::holds_alternative<Impervious>(water)) return WaterHold::none;
    return grains == GrainHold::none ? WaterHold::with_grains : WaterHold::sealed;
}

bool has_outer_water(const WaterCondition& water)
{
    return std::visit(Overload{[](const PrescribedWater&) { return true; },
                               [](const auto& face) { return face.beyond.has_value(); }},
                      water);
}

double outer_factor(const WaterCondition& water, double time)
{
    const auto* prescribed = std::get_if<PrescribedWater>(&water);
    return prescribed != nullptr ? history_value(prescribed->history, time) : 1.0;
}

void hold_water(WaterCondition& water, double time)
{
    auto* given = std::get_if<PrescribedWater>(&water);
    if (given != nullptr)
        given->history = {SampledHistory{{0.0}, {history_value(given->history, time)}}, 0.0};
}

double outer_excess(const WaterCondition& water, const StillWater& still, const Vector2& point, double factor)
{
    return std::visit(
        Overload{[&](const PrescribedWater& given) { return excess_of(given, still, point, factor); },
                 [&](const auto& face) { return excess_of(face.beyond, still, point); }},
        water);
}

} // namespace quicksand
