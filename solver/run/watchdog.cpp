#include "solver/run/watchdog.hpp"

#include "solver/measure/balances.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/motion/particle_order.hpp"

#include <algorithm>
#include <string>

namespace quicksand {

namespace {

constexpr double energy_made = 0.1; // of the energy turned over
constexpr double growth = 4.0;      // of the kinetic energy from one restart point to the next

std::string percentage(double part)
{
    return std::to_string(static_cast<int>(100.0 * std::min(part, 10.0))) + " %";
}

} // namespace

void Watchdog::keep(const Problem& problem, const State& state)
{
    kept_ = state;
    kinetic_energy_ = state.balance_terms ? monitor(problem, state, {}).kinetic_energy : 0.0;
    if (state.time > failed_time_) halvings_ = 0;
}

void Watchdog::check(const Problem& problem, double dt, const State& state) const
{
    if (!state.balance_terms || state.step == kept_.step) return;
    const double made = balance(problem, state).energy_error;
    if (made <= energy_made) return;
    if (monitor(problem, state, {}).kinetic_energy <= growth * kinetic_energy_) return;
    FailureRecord record = failure_at(dt, state, fastest_particle(state.particles));
    record.phase = "watchdog";
    record.what = "the steps have made energy, " + percentage(made) +
                  " of what was turned over, and the motion grows; the particle below is the fastest";
    record.causes = causes_of_instability;
    throw NumericalError(record);
}

void Watchdog::go_back(const NumericalError& error, State& state)
{
    if (halvings_ == most_halvings) {
        FailureRecord record = error.record;
        record.what += "; half the step, taken " + std::to_string(most_halvings) +
                       " times from the last restart point, has not helped";
        throw NumericalError(record);
    }
    ++halvings_;
    failed_time_ = std::max(failed_time_, error.record.time);
    kept_.step_halvings = std::max(kept_.step_halvings, state.step_halvings) + 1;
    state = kept_;
}

} // namespace quicksand
