// Whether soil that settles comes to rest.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/run/simulation.hpp"

namespace quicksand {

/// Looks at the soil now and then, and ends a stage in which it cannot come to rest: with the place of the
/// particle that has moved farthest and that of the largest unbalanced force.
class SettlingWatch {
public:
    /// `problem` is that of the settling, `particles` are those at its beginning.
    SettlingWatch(const Problem& problem, const RelaxationControls& controls, const Particles& particles);

    /// Throws NumericalError where the soil runs away, or has taken all its steps. `dt` is the step [s].
    void look(const State& state, const UnbalancedForces& unbalanced, double dt) const;

private:
    RelaxationControls controls_;
    double largest_displacement_; // of soil that comes to rest [m]
};

} // namespace quicksand
