// One way of taking the steps of a problem: what its scheme and its water need, and no more.
#pragma once

#include "solver/base/phase_timers.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>
#include <memory>

namespace quicksand {

class Stepper {
public:
    virtual ~Stepper() = default;

    /// Advance by dt <= stable_time_step(...).dt. Throws NumericalError.
    virtual void advance(const Problem& problem, double dt, State& state) = 0;

    /// Set up anew in the next step what serves several: a step after it depends on the state alone.
    virtual void restart() {}

    /// Particle domains scaled down to BackgroundGrid::domain_reach in the last step [-].
    virtual std::int64_t limited_domains() const = 0;

    /// Where the time of the steps went.
    virtual PhaseTimers& timers() = 0;
};

std::unique_ptr<Stepper> make_stepper(const Problem& problem);

} // namespace quicksand
