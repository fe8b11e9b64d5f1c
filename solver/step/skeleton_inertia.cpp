// The force with which the skeleton's stiffness resists accelerations, - beta dt K (v' - v), in a step that
// is under way (inertia_solve.hpp).
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/node_response.hpp"
#include "solver/boundaries/nodes.hpp"
#include "solver/inertia/node_masses.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step/two_phase_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace quicksand {

namespace {

template <class Sums>
Vector2 inertia_force(const Sums& node)
{
    return {node.inertia_force_x, node.inertia_force_y};
}

/// Whether each node takes part in the solution: those with stiffness, and all others of the rows that hold
/// one of them. A row would hold its other nodes where one that moves is left out.
template <class Sums>
std::vector<std::uint8_t> nodes_in_solution(const InertiaSolve& inertia, const VelocityRows& rows,
                                            const std::vector<Sums>& sums)
{
    std::vector<std::uint8_t> nodes(sums.size(), 0);
    for_each_index(sums.size(),
                   [&](std::size_t i) { nodes[i] = sums[i].active() && is_resisted(inertia, i) ? 1 : 0; });
    std::vector<std::uint8_t> reached(rows.size(), 0);
    for (bool grows = true; grows;) {
        grows = false;
        rows.for_each_coefficient([&](std::size_t row, std::size_t node, const NodeVelocities&) {
            if (nodes[node] == 0 || reached[row] != 0) return;
            reached[row] = 1;
            grows = true;
        });
        rows.for_each_coefficient([&](std::size_t row, std::size_t node, const NodeVelocities&) {
            if (reached[row] != 0 && sums[node].active()) nodes[node] = 1;
        });
    }
    return nodes;
}

template <class Workspace>
void set_up(const Problem& problem, double dt, double velocity_dt, Workspace& work)
{
    InertiaSolve& inertia = *work.inertia;
    const bool all =
        std::all_of(inertia.resists.begin(), inertia.resists.end(), [](auto r) { return r != 0; });
    std::vector<std::uint8_t> nodes;
    if (!all) nodes = nodes_in_solution(inertia, work.walls.rows, work.sums);
    const auto is_active = [&](std::size_t i) { return all ? work.sums[i].active() : nodes[i] != 0; };
    set_up_stiffness(is_active, inertia);
    inertia.response.set_shares(work.conditions, velocity_dt, work.sums, is_active);
    inertia.response.factorise(work.conditions, velocity_dt, inertia.resistance * dt * velocity_dt,
                               work.dashpots, work.walls.rows, inertia.rows, inertia.stiffness);
    const auto before = velocities_before(problem, work.conditions, work.walls, work.sums);
    inertia.before.x.assign(inertia.rows.size(), 0.0);
    inertia.before.y.assign(inertia.rows.size(), 0.0);
    for_each_index(before.size(), [&](std::size_t i) {
        inertia.before.set(inertia.places[i], inertia.kept * solid_velocity(before[i]));
    });
}

/// Spread over the nodes that move what light ones leave of zero in the sum of the forces.
template <class Sums>
void balance_forces(const NodeConditions& conditions, const StiffResponse& response, std::vector<Sums>& sums)
{
    const auto balance = [&](std::size_t axis, double Sums::*force) {
        double sum = 0.0, mass = 0.0;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            if (conditions.master[i] != i || !sums[i].active()) continue;
            sum += sums[i].*force;
            if (response.moves(i, axis)) mass += mass_of(sums[i]);
        }
        for (std::size_t i = 0; i < sums.size(); ++i)
            if (response.moves(i, axis)) sums[i].*force -= mass_of(sums[i]) / mass * sum;
    };
    balance(0, &Sums::inertia_force_x);
    balance(1, &Sums::inertia_force_y);
}

template <class Workspace, class Visit>
void for_each_node_with_sums(const Workspace& work, Visit&& visit)
{
    for_each_index(work.sums.size(), [&](std::size_t i) {
        if (work.conditions.master[i] == i && work.sums[i].active()) visit(i, work.inertia->places[i]);
    });
}

template <class Workspace>
void set_change(Workspace& work)
{
    InertiaSolve& inertia = *work.inertia;
    for_each_node_with_sums(work, [&](std::size_t i, std::size_t place) {
        inertia.change.set(place, solid_velocity(work.motion[i]) - inertia.before[place]);
    });
}

/// Correct the force by that of the present change of velocity.
template <class Workspace>
void resist(double dt, double velocity_dt, Workspace& work)
{
    InertiaSolve& inertia = *work.inertia;
    set_change(work);
    multiply_stiffness(-inertia.resistance * dt * velocity_dt, inertia.change, inertia);
    for_each_node_with_sums(work, [&](std::size_t i, std::size_t place) { // but for what is resisted already
        inertia.moving.set(place, velocity_dt * inertia_force(work.sums[i]));
        inertia.product.set(place, inertia.product[place] - inertia.moving[place]);
    });
    inertia.response.answer_impulses(inertia.rows, velocity_dt, work.dashpots, inertia.product,
                                     inertia.answer, inertia.moving);
    for_each_node_with_sums(work, [&](std::size_t, std::size_t place) {
        inertia.change.set(place, inertia.change[place] + inertia.answer[place]);
    });
    multiply_stiffness(-inertia.resistance * dt, inertia.change, inertia);
    for_each_node_with_sums(work, [&](std::size_t i, std::size_t place) {
        const auto force = [&](std::size_t axis, const Scalars& moving, const Scalars& product) {
            return inertia.response.is_light(i, axis) ? moving[place] / velocity_dt : product[place];
        };
        work.sums[i].inertia_force_x = force(0, inertia.moving.x, inertia.product.x);
        work.sums[i].inertia_force_y = force(1, inertia.moving.y, inertia.product.y);
    });
    balance_forces(work.conditions, inertia.response, work.sums);
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

double missing_inertia(double dt, SemiImplicitWorkspace& work)
{
    InertiaSolve& inertia = *work.inertia;
    set_change(work);
    multiply_stiffness(-inertia.resistance * dt, inertia.change, inertia);
    double missing = 0.0, largest = 0.0;
    for (const std::size_t axis : {0U, 1U}) {
        const auto d = static_cast<int>(axis);
        const auto lacking = [&](std::size_t i) {
            return inertia.product[inertia.places[i]][d] - inertia_force(work.sums[i])[d];
        };
        const auto for_each_moved = [&](auto&& visit) {
            for (std::size_t i = 0; i < work.sums.size(); ++i)
                if (work.conditions.master[i] == i && work.sums[i].active() &&
                    inertia.response.moves(i, axis) && !inertia.response.is_light(i, axis))
                    visit(i);
        };
        double sum = 0.0, mass = 0.0; // balance_forces() has spread what light nodes leave
        for_each_moved([&](std::size_t i) {
            sum += lacking(i);
            mass += mass_of(work.sums[i]);
        });
        for_each_moved([&](std::size_t i) {
            missing = std::max(missing, dt * std::abs(lacking(i) / mass_of(work.sums[i]) - sum / mass));
            largest = std::max(largest, std::abs(inertia.change[inertia.places[i]][d]));
        });
    }
    return largest > 0.0 ? missing / largest : 0.0;
}

} // namespace quicksand
