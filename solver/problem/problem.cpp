#include "solver/problem/problem.hpp"

#include <algorithm>

namespace quicksand {

namespace {

StillWater still_water(const Problem& problem)
{
    return {problem.water->density * problem.gravity, problem.water->level};
}

} // namespace

const std::optional<Water>& water_of(const Problem& problem, const Material& material)
{
    static const std::optional<Water> none;
    return material.saturated ? problem.water : none;
}

bool has_soil_and_solids(const Problem& problem)
{
    const auto& all = problem.materials;
    const auto is_soil = [](const Material& material) { return material.has_pores; };
    return std::any_of(all.begin(), all.end(), is_soil) && !std::all_of(all.begin(), all.end(), is_soil);
}

bool has_pores(const Problem& problem, const Particles& particles, std::size_t p)
{
    return problem.materials[static_cast<std::size_t>(particles.material[p])].has_pores;
}

bool is_partly_wet(const Problem& problem)
{
    return problem.water && std::any_of(problem.materials.begin(), problem.materials.end(),
                                        [](const Material& material) { return !is_wet(material); });
}

bool settles_undrained(const Problem& problem)
{
    return problem.water && problem.water->while_settling == WaterFlow::undrained;
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
    if (problem.water && problem.water->rises_above_level)
        particles.water_table = Scalars(count, problem.water->level);
    if (!particles.pore_pressure.empty() && problem.water->cavitation_pressure)
        particles.tension_deficit = Scalars(count, 0.0);
}

double pressure_below(const Problem& problem, double surface, double y)
{
    return pressure_below(still_water(problem), surface, y);
}

double static_water_pressure(const Problem& problem, double y)
{
    return problem.water ? pressure_below(problem, problem.water->level, y) : 0.0;
}

double outer_excess_pressure(const Problem& problem, const Boundary& boundary, const Vector2& point,
                             double factor)
{
    return outer_excess(boundary.water, still_water(problem), point, factor);
}

double risen_pore_pressure(const Problem& problem, const Particles& particles, std::size_t p)
{
    if (!has_pores(problem, particles, p)) return 0.0;
    const double excess = excess_pore_pressure(particles, p);
    if (particles.water_table.empty()) return excess;
    const bool fixed = problem.strain == StrainForm::small;
    const double y = (fixed ? particles.reference_position : particles.position).y[p];
    return excess -
           (pressure_below(problem, particles.water_table[p], y) - static_water_pressure(problem, y));
}

double modulus_with_air(double water_modulus, double saturation, double air_pressure)
{
    return 1.0 / (saturation / water_modulus + (1.0 - saturation) / air_pressure);
}

} // namespace quicksand
