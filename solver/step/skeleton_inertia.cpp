// The force with which the skeleton's stiffness resists accelerations, - beta dt K (v' - v), in a step that
// is under way (inertia_solve.hpp).
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/node_response.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "solver/inertia/node_masses.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step/two_phase_step.hpp"

#include <utility>
#include <vector>

namespace quicksand {

namespace {

/// Sums of a node at rest on which an impulse acts.
TwoPhaseSums at_rest(const TwoPhaseSums& node, const Vector2& force)
{
    TwoPhaseSums still{};
    still.mass_solid = node.mass_solid;
    still.mass_fluid = node.mass_fluid;
    still.volume = node.volume;
    still.drag = node.drag;
    still.stress_force_x = force.x();
    still.stress_force_y = force.y();
    return still;
}

SinglePhaseSums at_rest(const SinglePhaseSums& node, const Vector2& force)
{
    SinglePhaseSums still{};
    still.mass = node.mass;
    still.stress_force_x = force.x();
    still.stress_force_y = force.y();
    return still;
}

/// Velocities of a step from rest by the sums' forces alone.
void answer_forces(const Problem& still, double velocity_dt, SemiImplicitWorkspace& work)
{
    solve_two_phase_momentum(still, work.conditions, velocity_dt, 0.0, work.sums, work.motion);
    brake_by_dashpots(still, work.conditions, velocity_dt, work.dashpots, work.sums, work.motion);
    rest_at_walls(still, work.sums, work.walls, work.motion);
    spread_tied_motion(work.conditions, work.motion);
}

void answer_forces(const Problem& still, double velocity_dt, SinglePhaseWorkspace& work)
{
    solve_single_phase_momentum(still, work.conditions, velocity_dt, 0.0, 0.0, work.sums, work.motion);
    brake_by_dashpots(work.conditions, velocity_dt, work.dashpots, work.sums, work.motion);
    rest_at_walls(work.walls, work.motion);
}

/// Let the pressure answer the motion, and the motion the pressure; returns whether the pressure was found.
bool answer_pressure(const Problem& still, double dt, double velocity_dt, SemiImplicitWorkspace& work)
{
    // R of conjugate gradients must be the same for every vector
    constexpr PressureSolveControls sharp{.tolerance = 1e-4};
    const double step = set_fluxes(dt, velocity_dt, work);
    if (!answer_flux(still.grid, work.lists, work.conditions, step, sharp, work.pressure)) return false;
    add_increment_forces(still, work);
    answer_forces(still, velocity_dt, work);
    return true;
}

bool answer_pressure(const Problem&, double, double, SinglePhaseWorkspace&)
{
    return true;
}

/// change = velocities of the motion less those before the step, at the nodes that carry sums.
template <class Motion>
void set_change(const NodeConditions& conditions, const std::vector<Motion>& motion,
                const std::vector<Motion>& before, InertiaSolve& inertia)
{
    for_each_index(motion.size(), [&](std::size_t i) {
        if (conditions.master[i] != i) return;
        const std::size_t place = inertia.rows.place(i);
        inertia.change.set(place, solid_velocity(motion[i]) - solid_velocity(before[i]));
    });
}

template <class Workspace, class Sums>
void resist(const Problem& problem, double dt, double velocity_dt, std::vector<Sums> known,
            const State& state, Workspace& work)
{
    InertiaSolve& inertia = *work.inertia;
    set_up_stiffness([&](std::size_t i) { return work.sums[i].active(); }, inertia);
    const auto before = velocities_before(problem, work.conditions, work.walls, work.sums);
    set_change(work.conditions, work.motion, before, inertia);
    const double factor = inertia_fraction * dt * velocity_dt;
    multiply_stiffness(-factor, inertia.change, inertia); // what the change leaves
    inertia.residual = inertia.product;
    const auto carries_sums = [&](std::size_t i) {
        return known[i].active() && work.conditions.master[i] == i;
    };
    for_each_index(known.size(), [&](std::size_t i) { // but for what the known forces resist already
        if (!carries_sums(i)) return;
        const std::size_t place = inertia.rows.place(i);
        inertia.residual.x[place] -= velocity_dt * known[i].inertia_force_x;
        inertia.residual.y[place] -= velocity_dt * known[i].inertia_force_y;
    });
    const Problem& still = *work.weightless;
    const auto respond = [&](const Vectors& impulse, Vectors& velocity) {
        for_each_index(known.size(), [&](std::size_t i) {
            if (carries_sums(i))
                work.sums[i] = at_rest(known[i], impulse[inertia.rows.place(i)] / velocity_dt);
        });
        answer_forces(still, velocity_dt, work);
        if (!answer_pressure(still, dt, velocity_dt, work)) fail_to_resist(dt, work, state);
        for_each_index(known.size(), [&](std::size_t i) {
            if (work.conditions.master[i] == i)
                velocity.set(inertia.rows.place(i), solid_velocity(work.motion[i]));
        });
    };
    if (!solve_change(factor, respond, {}, inertia)) fail_to_resist(dt, work, state);
    multiply_stiffness(-inertia_fraction * dt, inertia.change, inertia);
    for_each_index(known.size(), [&](std::size_t i) {
        if (!carries_sums(i)) return;
        const std::size_t place = inertia.rows.place(i);
        known[i].inertia_force_x = inertia.product.x[place];
        known[i].inertia_force_y = inertia.product.y[place];
    });
    work.sums = std::move(known);
}

} // namespace

void resist_acceleration(const Problem& problem, double dt, double velocity_dt,
                         std::vector<TwoPhaseSums> known, const State& state, SemiImplicitWorkspace& work)
{
    const Scalars increment = work.pressure.increment;
    resist(problem, dt, velocity_dt, std::move(known), state, work);
    work.pressure.increment = increment;
}

void resist_acceleration(const Problem& problem, double dt, double velocity_dt, const State& state,
                         SinglePhaseWorkspace& work)
{
    resist(problem, dt, velocity_dt, work.sums, state, work);
}

} // namespace quicksand
