#include "solver/step_length/end_of_motion.hpp"

#include "solver/base/failure.hpp"
#include "solver/base/overload.hpp"
#include "solver/step_length/histories.hpp"
#include "solver/step_length/own_vibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
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

/// The time in which a table would go through its whole range as fast as it ever rises or falls [s].
double shortest_rise(const SampledHistory& table)
{
    ENSURE(!table.values.empty());
    double steepest = 0.0, least = table.values.front(), most = least; // [1/s], [-]
    for (std::size_t k = 1; k < table.times.size(); ++k) {
        least = std::min(least, table.values[k]);
        most = std::max(most, table.values[k]);
        steepest = std::max(steepest, std::abs(table.values[k] - table.values[k - 1]) /
                                          (table.times[k] - table.times[k - 1]));
    }
    return steepest > 0.0 ? (most - least) / steepest : std::numeric_limits<double>::infinity();
}

/// The time over which a history rises or falls [s].
double shortest_rise(const History& history)
{
    return std::visit(
        Overload{[&](const ConstantHistory&) { return history.ramp_time; },
                 [](const SineHistory& sine) { return 1.0 / (std::numbers::pi * sine.frequency); },
                 [](const SampledHistory& table) { return shortest_rise(table); }},
        history.shape);
}

/// Walls that move at constant velocity go on moving.
bool moves_on(const Boundary& boundary)
{
    const auto* wall = std::get_if<MovingWall>(&boundary.soil);
    return wall != nullptr && wall->motion.quantity == MotionQuantity::velocity;
}

} // namespace

double crossing_time(const BackgroundGrid& grid, double shear_speed)
{
    return grid.cell_size * grid.cells_y / shear_speed;
}

bool is_slow(const History& history, double crossing_time)
{
    return shortest_rise(history) >= slow_crossings * crossing_time;
}

bool is_loaded_fast(const Problem& problem, double crossing_time)
{
    return std::any_of(problem.boundaries.begin(), problem.boundaries.end(), [&](const Boundary& boundary) {
        const auto* face = std::get_if<FreeFace>(&boundary.soil);
        return face != nullptr && face->load &&
               (history_value(face->load->history, 0.0) != 0.0 ||
                !is_slow(face->load->history, crossing_time));
    });
}

bool changes_slowly(const Problem& problem, double crossing_time)
{
    bool slowly = false;
    for_each_history(problem, [&](const History& history) {
        const bool changes = end_of_motion(history) > 0.0 && std::isfinite(shortest_rise(history));
        slowly = slowly || (changes && is_slow(history, crossing_time));
    });
    return slowly;
}

double end_of_motion(const Problem& problem, double crossing_time)
{
    double end = duration(problem.base_motion);
    for_each_history(problem, [&](const History& history) {
        if (!is_slow(history, crossing_time)) end = std::max(end, end_of_motion(history));
    });
    const bool on = std::any_of(problem.boundaries.begin(), problem.boundaries.end(), moves_on);
    return on ? std::numeric_limits<double>::infinity() : end;
}

bool is_left_alone(const Problem& problem, double time, const Particles& particles,
                   const CellExtremes& extremes)
{
    const double end = end_of_motion(problem, crossing_time(problem.grid, extremes.shear_speed));
    return time >= end && (time >= end + afterlife(particles, extremes.shear_slowness) ||
                           !vibrates(particles, extremes.shear_slowness));
}

bool is_left_alone(const Problem& problem, const State& state)
{
    if (state.time < duration(problem.base_motion)) return false;
    return is_left_alone(problem, state.time, state.particles, find_extremes(problem, state.particles));
}

} // namespace quicksand
