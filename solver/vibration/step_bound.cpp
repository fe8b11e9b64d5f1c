#include "solver/vibration/step_bound.hpp"

#include "solver/vibration/vibration_limit.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// Boxes whose edges lie on grid lines reach over them as soon as the soil moves. The nodes beyond have
/// masses that go to zero with the square of the overlap, as their stiffness does: limits that do not depend
/// on it.
bool reaches_over_lines(const Problem& problem)
{
    return problem.strain == StrainForm::large &&
           (problem.interpolation == Interpolation::gimp || problem.interpolation == Interpolation::cpgimp);
}

/// The limit of the nodes' vibration, of boxes a little beside where they are [s].
double limit_of(const Problem& problem, const State& state, double largest)
{
    if (!reaches_over_lines(problem)) return vibration_limit(problem, state, largest).dt;
    constexpr double overlap = 1e-3; // [cells]
    for (const double side : {1.0, -1.0}) {
        State moved = state;
        const double way = side * overlap * problem.grid.cell_size;
        for (double& x : moved.particles.position.x) x += way;
        for (double& y : moved.particles.position.y) y += way;
        largest = std::min(largest, vibration_limit(problem, moved, largest).dt);
    }
    return largest;
}

double measure_scale(const Problem& problem, const State& state)
{
    if (problem.scheme == TimeScheme::implicit) return not_measured; // their inertia bears any step
    // Random motion of bodies at any angle, with all interpolations and both schemes, grows from 0.98 to 1.07
    // of the limit on.
    constexpr double margin = 0.9;
    Problem whole = problem;
    whole.step_fraction = 1.0;
    whole.strain = StrainForm::small; // the motion does not limit the waves
    const double closed = stable_time_step(whole, state.particles).dt;
    const double scale = margin * limit_of(problem, state, closed / margin) / closed;
    return std::clamp(scale, least_step_scale, 1.0);
}

/// Of the step of the closed forms, or of accuracy.
double part_left(const Problem& problem, double scale)
{
    return problem.scheme == TimeScheme::implicit ? 1.0 : scale;
}

} // namespace

void measure_bound(const Problem& problem, State& state)
{
    state.step_scale = measure_scale(problem, state);
    if (problem.scheme == TimeScheme::implicit) state.implicit_cost = not_measured; // until it matters
}

TimeStep bounded_time_step(const Problem& problem, const State& state)
{
    return stable_time_step(problem, state,
                            part_after_halvings(state) * part_left(problem, state.step_scale));
}

TimeStep measure_time_step(const Problem& problem, const State& state)
{
    return stable_time_step(problem, state, part_left(problem, measure_scale(problem, state)));
}

} // namespace quicksand
