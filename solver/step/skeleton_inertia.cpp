// The force with which the skeleton's stiffness resists accelerations, - beta dt K (v' - v), in a step that
// is under way (inertia_solve.hpp).
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/node_response.hpp"
#include "solver/inertia/node_masses.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step/two_phase_step.hpp"

namespace quicksand {

namespace {

template <class Workspace>
void set_up(const Problem& problem, double dt, double velocity_dt, Workspace& work)
{
    InertiaSolve& inertia = *work.inertia;
    set_up_stiffness([&](std::size_t i) { return work.sums[i].active(); }, inertia);
    inertia.response.set_shares(work.conditions, velocity_dt, work.sums);
    inertia.response.factorise(work.conditions, velocity_dt, inertia_fraction * dt * velocity_dt,
                               work.dashpots, work.walls.rows, inertia.rows, inertia.stiffness);
    const auto before = velocities_before(problem, work.conditions, work.walls, work.sums);
    inertia.before.x.assign(inertia.rows.size(), 0.0);
    inertia.before.y.assign(inertia.rows.size(), 0.0);
    for_each_index(before.size(), [&](std::size_t i) {
        inertia.before.set(inertia.rows.place(i), solid_velocity(before[i]));
    });
}

template <class Workspace>
void resist(double dt, double velocity_dt, Workspace& work)
{
    InertiaSolve& inertia = *work.inertia;
    const auto for_each_node_with_sums = [&](auto&& visit) {
        for_each_index(work.sums.size(), [&](std::size_t i) {
            if (work.conditions.master[i] == i && work.sums[i].active()) visit(i, inertia.rows.place(i));
        });
    };
    for_each_node_with_sums([&](std::size_t i, std::size_t place) {
        inertia.change.set(place, solid_velocity(work.motion[i]) - inertia.before[place]);
    });
    multiply_stiffness(-inertia_fraction * dt * velocity_dt, inertia.change, inertia);
    for_each_node_with_sums([&](std::size_t i, std::size_t place) { // but for what is resisted already
        inertia.product.x[place] -= velocity_dt * work.sums[i].inertia_force_x;
        inertia.product.y[place] -= velocity_dt * work.sums[i].inertia_force_y;
    });
    inertia.response.answer_impulses(inertia.rows, inertia.product, inertia.answer);
    for_each_node_with_sums([&](std::size_t, std::size_t place) {
        inertia.change.x[place] += inertia.answer.x[place];
        inertia.change.y[place] += inertia.answer.y[place];
    });
    multiply_stiffness(-inertia_fraction * dt, inertia.change, inertia);
    for_each_node_with_sums([&](std::size_t i, std::size_t place) {
        work.sums[i].inertia_force_x = inertia.product.x[place];
        work.sums[i].inertia_force_y = inertia.product.y[place];
    });
}

} // namespace

void set_up_inertia(const Problem& problem, double dt, double velocity_dt, SemiImplicitWorkspace& work)
{
    set_up(problem, dt, velocity_dt, work);
    Scalars porosities(work.sums.size(), 0.0);
    for_each_index(work.sums.size(), [&](std::size_t i) {
        if (work.sums[i].active()) porosities[i] = node_porosity(problem, work.sums[i]);
    });
    work.inertia->response.set_porosities(std::move(porosities));
}

void set_up_inertia(const Problem& problem, double dt, double velocity_dt, SinglePhaseWorkspace& work)
{
    set_up(problem, dt, velocity_dt, work);
}

void resist_acceleration(double dt, double velocity_dt, SemiImplicitWorkspace& work)
{
    resist(dt, velocity_dt, work);
}

void resist_acceleration(double dt, double velocity_dt, SinglePhaseWorkspace& work)
{
    resist(dt, velocity_dt, work);
}

} // namespace quicksand
