#include "solver/free_field/free_field_steps.hpp"

#include "solver/motion/particle_order.hpp"
#include "solver/motion/wrapping.hpp"
#include "solver/step/free_field_rows.hpp"
#include "solver/vibration/step_bound.hpp"

#include <cstddef>

namespace quicksand {

void measure_bounds(const Problem& problem, State& state)
{
    measure_bound(problem, state);
    for (std::size_t k = 0; k < problem.free_fields.size(); ++k)
        measure_bound(problem.free_fields[k].column, state.free_fields[k].column);
}

TimeStep shortest_time_step(const Problem& problem, State& state)
{
    TimeStep shortest = bounded_time_step(problem, state);
    for (std::size_t k = 0; k < problem.free_fields.size(); ++k) {
        State& column = state.free_fields[k].column;
        column.step_halvings = state.step_halvings;
        const TimeStep step = bounded_time_step(problem.free_fields[k].column, column);
        if (step.dt < shortest.dt) shortest = step;
    }
    return shortest;
}

void note_whole_step(double dt, State& state)
{
    state.whole_step = dt;
    for (FreeFieldState& field : state.free_fields) field.column.whole_step = dt;
}

FreeFieldSteps::FreeFieldSteps(const Problem& problem)
{
    for (const FreeField& field : problem.free_fields) steppers_.push_back(make_stepper(field.column));
}

void FreeFieldSteps::advance(const Problem& problem, double dt, State& state)
{
    for (std::size_t k = 0; k < steppers_.size(); ++k) {
        const Problem& column = problem.free_fields[k].column;
        FreeFieldState& field = state.free_fields[k];
        Stepper& stepper = *steppers_[k];
        const SectionStress stress = section_stress(column, field.column.particles);
        stepper.advance(column, dt, field.column);
        find_section_forces(
            column, stepper.workspace(), field.column.particles, stress,
            [&](std::size_t p) { return stepper.acting_increment(p); }, field.rows);
        find_row_velocities(column, stepper, field.rows);
        wrap_particles(column, field.column.particles);
        check_particles(dt, field.column);
    }
}

void FreeFieldSteps::restart()
{
    for (const auto& stepper : steppers_) stepper->restart();
}

} // namespace quicksand
