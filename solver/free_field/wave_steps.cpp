#include "solver/free_field/wave_steps.hpp"

#include "solver/free_field/free_field_steps.hpp"
#include "solver/step/implicit_cost.hpp"
#include "solver/step/scheme_choice.hpp"
#include "solver/step_length/end_of_motion.hpp"
#include "solver/step_length/time_step_control.hpp"
#include "solver/vibration/step_bound.hpp"

namespace quicksand {

std::optional<TimeStep> step_replaced_by_waves(const Problem& problem, const Problem& wave_form, State& state)
{
    if (problem.scheme != TimeScheme::implicit || state.step_halvings > 0) return std::nullopt;
    const TimeStep accurate = shortest_time_step(problem, state);
    if (is_left_alone(problem, state) && accurate.limiter != TimeStepLimiter::flow)
        return std::nullopt; // steps grow
    if (state.implicit_cost == not_measured) state.implicit_cost = implicit_cost(count_parts(problem, state));
    const double cost = state.implicit_cost;
    // the bound costs as much as twenty steps: first whether it matters
    if (!are_waves_cheaper(stable_time_step(wave_form, state), accurate, cost)) return std::nullopt;
    if (state.step_scale == not_measured) measure_bounds(wave_form, state);
    const TimeStep by_waves = shortest_time_step(wave_form, state);
    if (!are_waves_cheaper(by_waves, accurate, cost)) return std::nullopt;
    return accurate;
}

TimeStep first_time_step(const Problem& problem, State state)
{
    const Problem wave_form = with_scheme(problem, scheme_of_waves(problem));
    measure_bounds(problem, state);
    const std::optional<TimeStep> replaced = step_replaced_by_waves(problem, wave_form, state);
    const Problem& form = replaced ? wave_form : problem;
    TimeStep step = shortest_time_step(form, state);
    step.scheme = form.scheme;
    if (replaced) step.replaced = replaced->dt;
    return step;
}

} // namespace quicksand
