// One way of taking the steps of a problem: what its scheme and its water need, and no more.
#pragma once

#include "solver/base/phase_timers.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace quicksand {

struct StepWorkspace;

class Stepper {
public:
    virtual ~Stepper() = default;

    /// Advance by dt <= stable_time_step(...).dt. Throws NumericalError.
    virtual void advance(const Problem& problem, double dt, State& state) = 0;

    /// Set up anew in the next step what serves several: a step after it depends on the state alone.
    virtual void restart() {}

    /// Particle domains scaled down to BackgroundGrid::domain_reach in the last step [-].
    virtual std::int64_t limited_domains() const = 0;

    /// The particles' places and weights at the start of the last step.
    virtual const StepWorkspace& workspace() const = 0;

    /// Mean of the velocities of the grains before and after the last step at a node; none without soil
    /// [m/s].
    virtual std::optional<Vector2> mean_velocity(std::size_t node) const = 0;

    /// By how much the acting pore pressure of a particle differed from that at the start of the last step
    /// [Pa].
    virtual double acting_increment(std::size_t) const { return 0.0; }

    /// Where the time of the steps went.
    virtual PhaseTimers& timers() = 0;
};

std::unique_ptr<Stepper> make_stepper(const Problem& problem);

} // namespace quicksand
