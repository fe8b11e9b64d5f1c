#include "solver/step_length/end_of_motion.hpp"

#include "solver/base/overload.hpp"
#include "solver/step_length/cell_extremes.hpp"
#include "solver/step_length/histories.hpp"
#include "solver/step_length/own_vibration.hpp"

#include <algorithm>
#include <limits>
#include <variant>

namespace quicksand {

namespace {

constexpr double slow_crossings = 100.0; // of shear waves: inertia answers a slower rise by less than 1 %

double end_of_motion(const History& history)
{
    return std::visit(
        Overload{[&](const ConstantHistory&) { return history.ramp_time; },
                 [](const SineHistory&) { return std::numeric_limits<double>::infinity(); },
                 [](const SampledHistory& table) { return table.times.empty() ? 0.0 : table.times.back(); }},
        history.shape);
}

/// Shortest time over which a history rises or falls [s].
double shortest_rise(const SampledHistory& table)
{
    double rise = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < table.times.size(); ++k)
        rise = std::min(rise, table.times[k] - table.times[k - 1]);
    return rise;
}

bool is_slow(const History& history, double crossing_time)
{
    const double least = slow_crossings * crossing_time;
    return std::visit(Overload{[&](const ConstantHistory&) { return history.ramp_time >= least; },
                               [](const SineHistory&) { return false; },
                               [&](const SampledHistory& table) { return shortest_rise(table) >= least; }},
                      history.shape);
}

/// Walls that move at constant velocity go on moving.
bool moves_on(const Boundary& boundary)
{
    const auto* wall = std::get_if<MovingWall>(&boundary.soil);
    return wall != nullptr && wall->motion.quantity == MotionQuantity::velocity;
}

/// Whether a history goes on after the time that may be slow.
bool may_rise_slowly(const Problem& problem, double time)
{
    bool may = false;
    for_each_history(problem, [&](const History& history) {
        const bool is_sine = std::holds_alternative<SineHistory>(history.shape);
        may = may || (!is_sine && time < end_of_motion(history));
    });
    return may;
}

} // namespace

BodyTimes body_times(const Problem& problem, const Particles& particles, double shear_speed)
{
    return {problem.grid.cell_size * problem.grid.cells_y / shear_speed,
            afterlife(problem, particles, shear_speed)};
}

double end_of_motion(const Problem& problem, const BodyTimes& body)
{
    const double shaking = duration(problem.base_motion);
    double end = shaking > 0.0 ? shaking + body.afterlife : 0.0;
    for_each_history(problem, [&](const History& history) {
        if (!is_slow(history, body.crossing)) end = std::max(end, end_of_motion(history));
    });
    const bool on = std::any_of(problem.boundaries.begin(), problem.boundaries.end(), moves_on);
    return on ? std::numeric_limits<double>::infinity() : end;
}

bool is_left_alone(const Problem& problem, const State& state)
{
    const double shaking = duration(problem.base_motion);
    if (state.time < shaking) return false;
    const bool hangs_on_body = may_rise_slowly(problem, state.time) ||
                               (shaking > 0.0 && undamped_share(problem, state.particles) > 0.0);
    const BodyTimes body = hangs_on_body ? body_times(problem, state.particles,
                                                      find_extremes(problem, state.particles).shear_speed)
                                         : BodyTimes();
    return state.time >= end_of_motion(problem, body);
}

} // namespace quicksand
