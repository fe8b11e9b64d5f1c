#include "solver/inertia/nodal_inertia.hpp"

#include "solver/boundaries/node_response.hpp"
#include "solver/inertia/node_masses.hpp"

#include <Eigen/LU>

namespace quicksand {

namespace {

/// A dashpot resists as a mass of dt C / 2 does.
void add_dashpots(const std::vector<Dashpot>& dashpots, double dt, InertiaSolve& solve)
{
    for (const Dashpot& dashpot : dashpots) {
        const std::size_t i = solve.rows.place(dashpot.node);
        Eigen::Matrix2d mass = solve.mass.at(i);
        const bool moves[2] = {mass(0, 0) > 0.0, mass(1, 1) > 0.0};
        mass += half_braking(dashpots, dashpot.node, dt);
        for (int axis = 0; axis < 2; ++axis)
            if (!moves[axis]) mass.row(axis).setZero(), mass.col(axis).setZero();
        solve.mass.set(i, mass);
        if (moves[0] && moves[1]) {
            solve.response.set(i, mass.inverse());
        } else {
            for (int axis = 0; axis < 2; ++axis)
                mass(axis, axis) = moves[axis] ? 1.0 / mass(axis, axis) : 0.0;
            solve.response.set(i, mass);
        }
    }
}

/// A and A^-1 of the grains at the nodes without rows, and the change that they want.
template <class Sums, class Motion>
void set_nodes(const NodeConditions& conditions, double dt, const std::vector<Sums>& sums,
               const std::vector<Motion>& motion, const std::vector<Motion>& before, InertiaSolve& solve)
{
    solve.mass.assign(solve.rows.size());
    solve.response.assign(solve.rows.size());
    for (Scalars* part : {&solve.wanted.x, &solve.wanted.y}) part->assign(solve.rows.size(), 0.0);
    for_each_index(sums.size(), [&](std::size_t i) {
        if (!sums[i].active() || conditions.master[i] != i) return;
        const std::size_t place = solve.rows.place(i);
        const double x = response(sums[i], dt, conditions.of_node[i], 0).solid,
                     y = response(sums[i], dt, conditions.of_node[i], 1).solid;
        solve.response.xx[place] = x;
        solve.response.yy[place] = y;
        solve.mass.xx[place] = x > 0.0 ? 1.0 / x : 0.0;
        solve.mass.yy[place] = y > 0.0 ? 1.0 / y : 0.0;
        const Vector2 change = solid_velocity(motion[i]) - solid_velocity(before[i]);
        solve.wanted.x[place] = change.x();
        solve.wanted.y[place] = change.y();
    });
}

template <class Sums, class Motion>
void set_row_nodes(double dt, const std::vector<Dashpot>& dashpots, const VelocityRows& rows,
                   const std::vector<Sums>& sums, const std::vector<Motion>& motion,
                   const std::vector<Motion>& before, InertiaSolve& solve)
{
    solve.held = rows.empty() ? nullptr : &rows;
    solve.row_nodes.clear();
    if (rows.empty()) return;
    for (const std::size_t i : rows.nodes()) {
        RowNode& node = solve.row_nodes.emplace_back();
        node.place = solve.rows.place(i);
        node.mass = mass_matrix(sums[i], dt);
        node.mass.topLeftCorner<2, 2>() += half_braking(dashpots, i, dt);
        node.wanted << solid_velocity(motion[i]) - solid_velocity(before[i]),
            fluid_velocity(motion[i]) - fluid_velocity(before[i]);
        solve.mass.set(node.place, Eigen::Matrix2d::Zero());
        solve.response.set(node.place, Eigen::Matrix2d::Zero());
    }
}

template <class Sums, class Motion>
bool resist(const Problem& problem, const NodeConditions& conditions, double dt, double velocity_dt,
            const std::vector<Dashpot>& dashpots, const WallRows& walls, const std::vector<Motion>& motion,
            std::vector<Sums>& sums, InertiaSolve& solve)
{
    set_up_stiffness([&](std::size_t i) { return sums[i].active(); }, solve);
    const std::vector<Motion> before = velocities_before(problem, conditions, walls, sums);
    set_nodes(conditions, velocity_dt, sums, motion, before, solve);
    add_dashpots(dashpots, velocity_dt, solve);
    set_row_nodes(velocity_dt, dashpots, walls.rows, sums, motion, before, solve);
    if (!solve_change(inertia_fraction * dt * velocity_dt, {}, solve)) return false;
    multiply_change(-inertia_fraction * dt, solve);
    for_each_index(sums.size(), [&](std::size_t i) {
        if (!sums[i].active()) return;
        const std::size_t place = solve.rows.place(i);
        sums[i].inertia_force_x = solve.product.x[place];
        sums[i].inertia_force_y = solve.product.y[place];
    });
    return true;
}

} // namespace

bool resist_acceleration(const Problem& problem, const NodeConditions& conditions, double dt,
                         double velocity_dt, const std::vector<Dashpot>& dashpots, const WallRows& walls,
                         const std::vector<TwoPhaseMotion>& motion, std::vector<TwoPhaseSums>& sums,
                         InertiaSolve& solve)
{
    return resist(problem, conditions, dt, velocity_dt, dashpots, walls, motion, sums, solve);
}

bool resist_acceleration(const Problem& problem, const NodeConditions& conditions, double dt,
                         double velocity_dt, const std::vector<Dashpot>& dashpots, const WallRows& walls,
                         const std::vector<SinglePhaseMotion>& motion, std::vector<SinglePhaseSums>& sums,
                         InertiaSolve& solve)
{
    return resist(problem, conditions, dt, velocity_dt, dashpots, walls, motion, sums, solve);
}

} // namespace quicksand
