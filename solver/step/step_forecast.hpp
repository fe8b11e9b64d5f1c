// How many steps a run will take, and by which scheme it takes the least time.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// Steps from the start of the shaking through all `events`, ascending times that steps hit [s]: of the
/// length `dt`, which implicit ones keep while something moves the soil with waves and then grow from as far
/// as they may, with the vibration that it leaves followed to the end, and as far as pore pressures of soil
/// that drains may let them. Strains, and pressures that rise and fall, limit them further.
std::int64_t count_steps(const Problem& problem, const Particles& particles, double dt,
                         const std::vector<double>& events);

/// The scheme by which a run of the problem from the state takes the least time, at errors that are
/// about the same: the one whose steps waves of the skeleton limit, or implicit steps, which cost more each.
/// Undrained water has explicit steps alone, and so have runs that end before sound has crossed the body
/// twenty times; dry and drained soil that nothing moves but what acts at once or fast has those
/// of waves.
TimeScheme fastest_scheme(const Problem& problem, const State& state, double end_time);

} // namespace quicksand
