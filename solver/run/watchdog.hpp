// Goes back and takes shorter steps where a run becomes unstable.
#pragma once

#include "solver/base/failure.hpp"
#include "solver/measure/balances.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>

namespace quicksand {

/// Keeps the state of the last restart point. A run that fails, or whose steps make energy, goes on from
/// there with half the step; at the third time in a row it ends. Steps that waves limit stay halved, for
/// their limit was wrong; implicit ones, whose limits are those of accuracy, until the next restart point. A
/// run whose steps damp the sound of the water too much goes on with explicit ones for a while.
class Watchdog {
public:
    static constexpr int most_halvings = 3;
    /// In one go: a tenth of the time is lost where semi-implicit steps are tried again in vain [-].
    static constexpr std::int64_t explicit_steps = 512;

    Watchdog(const Problem& problem, State& state) { keep(problem, state); }

    /// Keep the state of a restart point to go back to: the run can go on from it with the same bits. Ends
    /// the halvings of implicit steps.
    void keep(const Problem& problem, State& state);

    /// Throws NumericalError where the steps since keep() have made energy: the balances are off by a tenth
    /// of what was turned over, and the kinetic energy has grown fourfold. `problem` has the scheme of the
    /// steps. Costs a sum over the particles.
    void check_growth(const Problem& problem, double dt, const State& state) const;

    /// The same, and where the energy that they made is lost again between particles and grid: a tenth of all
    /// that was ever put in, or is held by stress and water at keep(), since then, and twice of it in all.
    /// Likewise where semi-implicit steps, or implicit ones that follow the sound of the water, have lost
    /// energy since keep(), and 1 % of what was turned over in all.
    void check(const Problem& problem, double dt, const State& state) const;

    /// Bring the state back with the remedy of `error`; throws it, with what was tried, where half the step
    /// has not helped three times.
    void go_back(const NumericalError& error, State& state);

private:
    bool has_nothing_to_check(const State& state) const;
    /// From rest, without shaking, a load that comes at once makes sound first. Implicit steps that pass over
    /// it balance its little energy badly, and what they have made of it fades. Until the next restart point.
    bool begins_with_sound(const Problem& problem, double dt, const State& state) const;
    void check_growth(const EnergyBalance& energy, double dt, const State& state) const;
    void check_sound(const Problem& problem, const EnergyBalance& energy, double dt,
                     const State& state) const;
    void check_loss(const Problem& problem, const EnergyBalance& energy, double dt, const State& state) const;

    State kept_;
    EnergyBalance energy_;      // of the kept state
    int halvings_ = 0;          // in a row [-]
    double failed_time_ = -1.0; // of the latest failure [s]
};

} // namespace quicksand
