// Whether soil that settles comes to rest.
#pragma once

#include "solver/measure/runaway.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/run/simulation.hpp"

#include <optional>

namespace quicksand {

/// Looks at the soil now and then, and ends a stage in which it cannot come to rest: with the place of the
/// particle that has moved farthest and that of the largest unbalanced force.
class SettlingWatch {
public:
    /// `problem` is that of the settling and outlives the watch, `particles` are those at its beginning. The
    /// body has moved as far as more than a `share` of the particles have [-]; 0: as the farthest one.
    SettlingWatch(const Problem& problem, const RelaxationControls& controls, const Particles& particles,
                  double share);

    /// Throws NumericalError where the soil runs away, or has taken all its steps; to be called every so many
    /// steps, the same number each time. `dt` is the step [s].
    void look(const State& state, const UnbalancedForces& unbalanced, double dt);

private:
    const Problem* problem_;
    RelaxationControls controls_;
    double share_;                   // of the particles that have moved farther than the body [-]
    double largest_displacement_;    // of soil that comes to rest [m]
    double least_of_slides_;         // displacement from which on soil may be said to slide [m]
    std::optional<Runaway> runaway_; // from the first look on
};

} // namespace quicksand
