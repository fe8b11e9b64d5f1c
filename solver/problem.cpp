#include "solver/problem.hpp"

#include <algorithm>

namespace quicksand {

const std::optional<Water>& water_of(const Problem& problem, const Material& material)
{
    static const std::optional<Water> none;
    return material.saturated ? problem.water : none;
}

bool has_unsaturated_soil(const Problem& problem)
{
    return problem.water && std::any_of(problem.materials.begin(), problem.materials.end(),
                                        [](const Material& material) { return !material.saturated; });
}

double static_water_pressure(const Problem& problem, double y)
{
    if (!problem.water) return 0.0;
    return problem.water->density * problem.gravity * std::max(0.0, problem.water->level - y);
}

double outer_excess_pressure(const Problem& problem, const OuterWater& outer, double y)
{
    double pressure = 0.0;
    if (const auto* water = std::get_if<WaterHead>(&outer.value)) {
        pressure = problem.water->density * problem.gravity * std::max(0.0, water->head - y);
    } else {
        pressure = std::get<PorePressure>(outer.value).pressure;
    }
    return pressure - static_water_pressure(problem, y);
}

} // namespace quicksand
