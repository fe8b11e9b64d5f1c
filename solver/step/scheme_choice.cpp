#include "solver/step/scheme_choice.hpp"

#include <cmath>

namespace quicksand {

TimeScheme scheme_of_waves(const Problem& problem)
{
    return water_flow(problem) == WaterFlow::coupled ? TimeScheme::semi_implicit : TimeScheme::explicit_steps;
}

Problem with_scheme(const Problem& problem, TimeScheme scheme)
{
    Problem form = problem;
    form.scheme = scheme;
    for (FreeField& field : form.free_fields) field.column.scheme = scheme;
    return form;
}

bool are_waves_cheaper(const TimeStep& by_waves, const TimeStep& accurate, double cost)
{
    return cost * by_waves.dt > accurate.dt;
}

double step_after(double last_step, double dt)
{
    // x (x + last_step) / 2 = dt^2
    return last_step > dt ? 0.5 * (std::sqrt(last_step * last_step + 8.0 * dt * dt) - last_step) : dt;
}

} // namespace quicksand
