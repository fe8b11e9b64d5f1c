#include "solver/faces/water_condition.hpp"

#include "solver/base/overload.hpp"

#include <algorithm>

namespace quicksand {

namespace {

double pressure_at(const WaterLine& line, const StillWater& still, const Vector2& point)
{
    return pressure_below(still, elevation(line.points, point.x()), point.y());
}

double pressure_at(const WaterHead& water, const StillWater& still, const Vector2& point)
{
    return pressure_below(still, water.head, point.y());
}

double pressure_at(const PorePressure& pore, const StillWater&, const Vector2&)
{
    return pore.pressure;
}

double excess_of(const std::optional<WaterLine>& line, const StillWater& still, const Vector2& point)
{
    if (!line) return 0.0;
    return pressure_at(*line, still, point) - pressure_below(still, still.level, point.y());
}

double excess_of(const PrescribedWater& water, const StillWater& still, const Vector2& point, double factor)
{
    const double at_rest = excess_of(water.at_rest, still, point);
    const double full =
        std::visit([&](const auto& value) { return pressure_at(value, still, point); }, water.value) -
        pressure_below(still, still.level, point.y());
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
