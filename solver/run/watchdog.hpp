// Goes back and takes shorter steps where a run becomes unstable.
#pragma once

#include "solver/base/failure.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>

namespace quicksand {

/// Keeps the state of the last restart point. A run that fails, or whose steps make energy, goes on from
/// there with half the step; at the third time in a row it ends.
class Watchdog {
public:
    static constexpr int most_halvings = 3;

    Watchdog(const Problem& problem, const State& state) { keep(problem, state); }

    /// Keep the state to go back to; the run can go on from it with the same bits.
    void keep(const Problem& problem, const State& state);

    /// Whether enough steps have been taken since keep() that a copy costs little.
    bool may_keep(const State& state) const { return state.step >= kept_.step + steps_worth_a_copy; }

    /// Throws NumericalError where the steps since keep() have made energy: the balances are off by a tenth
    /// of what was turned over, and the kinetic energy has grown fourfold.
    void check(const Problem& problem, double dt, const State& state) const;

    /// Bring the state back with half the step; throws `error`, with what was tried, where that has not
    /// helped three times.
    void go_back(const NumericalError& error, State& state);

private:
    static constexpr std::int64_t steps_worth_a_copy = 8;

    State kept_;
    double kinetic_energy_ = 0.0; // of the kept state [J/m]
    int halvings_ = 0;            // in a row [-]
    double failed_time_ = -1.0;   // of the latest failure [s]
};

} // namespace quicksand
