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

std::optional<WaterFlow> water_flow(const Problem& problem)
{
    if (!problem.water) return std::nullopt;
    return problem.water->flow;
}

void resize_particles(const Problem& problem, std::size_t count, Particles& particles)
{
    resize(particles, count, water_flow(problem));
    if (problem.interpolation == Interpolation::cpdi2)
        particles.twist.x = particles.twist.y = Scalars(count, 0.0);
    // drained water presses as long as its line rises above the level that static pressures count from
    if (water_flow(problem) == WaterFlow::drained && problem.water->rises_above_level)
        particles.pore_pressure = Scalars(count, 0.0);
    if (!particles.pore_pressure.empty() && problem.water->cavitation_pressure)
        particles.tension_deficit = Scalars(count, 0.0);
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

double modulus_with_air(double water_modulus, double saturation, double air_pressure)
{
    return 1.0 / (saturation / water_modulus + (1.0 - saturation) / air_pressure);
}

} // namespace quicksand
