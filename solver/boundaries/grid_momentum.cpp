#include "solver/boundaries/grid_momentum.hpp"

#include "solver/base/threads.hpp"
#include "solver/boundaries/node_response.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace quicksand {

namespace {

/// One direction of a node's balance: impulses b = momentum + dt force.
struct Balance {
    double mass_solid, mass_fluid, dt_drag; // [kg/m]
    double impulse_solid, impulse_fluid;    // [N s/m]
};

/// Solve with the conditions of one direction inside: a held solid still drags the water.
PhaseVelocities solve_direction(const Balance& balance, bool solid_fixed, bool fluid_fixed, bool seal)
{
    if (solid_fixed) {
        const double fluid = fluid_fixed || seal || balance.mass_fluid == 0.0
                                 ? 0.0
                                 : balance.impulse_fluid / (balance.mass_fluid + balance.dt_drag);
        return {0.0, fluid};
    }
    if (seal) {
        const double both =
            (balance.impulse_solid + balance.impulse_fluid) / (balance.mass_solid + balance.mass_fluid);
        return {both, both};
    }
    return solve_drag(balance.mass_solid, balance.mass_fluid, balance.dt_drag, balance.impulse_solid,
                      balance.impulse_fluid);
}

Balance balance_along(const TwoPhaseSums& node, const NodeImpulses& impulses, double dt, int axis)
{
    return {node.mass_solid, node.mass_fluid, dt * drag_along(node, axis), impulses.solid[axis],
            impulses.fluid[axis]};
}

/// Take the part that is known before the step from the drag along one of its axes; returns that part.
double take_known_drag(double dt, double strong, const TwoPhaseSums& node, double& drag)
{
    const double rate = dt * drag * (1.0 / node.mass_solid + 1.0 / node.mass_fluid);
    const double known = std::min(0.5, strong / rate) * drag;
    drag -= known;
    return known;
}

void set_flux_and_change(const Problem& problem, const TwoPhaseSums& node, TwoPhaseMotion& motion)
{
    set_flux(problem, node, motion);
    motion.solid_change_x = motion.solid_x - node.momentum_solid_x / node.mass_solid;
    motion.solid_change_y = motion.solid_y - node.momentum_solid_y / node.mass_solid;
    if (node.mass_fluid == 0.0) return; // and the change of no water is zero
    motion.fluid_change_x = motion.fluid_x - node.momentum_fluid_x / node.mass_fluid;
    motion.fluid_change_y = motion.fluid_y - node.momentum_fluid_y / node.mass_fluid;
}

void set_change(const SinglePhaseSums& node, SinglePhaseMotion& motion)
{
    motion.change_x = motion.x - node.momentum_x / node.mass;
    motion.change_y = motion.y - node.momentum_y / node.mass;
}

TwoPhaseMotion solve_along_axes(const TwoPhaseSums& node, const NodeImpulses& impulses, double dt,
                                std::uint8_t held)
{
    const PhaseVelocities x = solve_direction(balance_along(node, impulses, dt, 0), held & solid_x_fixed,
                                              held & fluid_x_fixed, held & seal_x);
    const PhaseVelocities y = solve_direction(balance_along(node, impulses, dt, 1), held & solid_y_fixed,
                                              held & fluid_y_fixed, held & seal_y);
    return {.solid_x = x.solid, .solid_y = y.solid, .fluid_x = x.fluid, .fluid_y = y.fluid};
}

TwoPhaseMotion solve_node(const TwoPhaseSums& node, const NodeImpulses& impulses, double dt,
                          std::uint8_t held)
{
    if (!is_slanted(node)) return solve_along_axes(node, impulses, dt, held);
    const TwoPhaseMotion turned = solve_along_axes(
        node, {along_layers(node, impulses.solid), along_layers(node, impulses.fluid)}, dt, held);
    const Vector2 solid = along_grid(node, {turned.solid_x, turned.solid_y}),
                  fluid = along_grid(node, {turned.fluid_x, turned.fluid_y});
    return {.solid_x = solid.x(), .solid_y = solid.y(), .fluid_x = fluid.x(), .fluid_y = fluid.y()};
}

/// Impulses of a force of the pressure over a unit of time, on grains and water.
NodeImpulses unit_pressure_impulses(double porosity, const Vector2& force)
{
    return {(1.0 - porosity) * force, porosity * force};
}

Vector2 flux_of(double porosity, const TwoPhaseMotion& motion)
{
    return {(1.0 - porosity) * motion.solid_x + porosity * motion.fluid_x,
            (1.0 - porosity) * motion.solid_y + porosity * motion.fluid_y};
}

template <class Sums, class Add>
void add_tied(const NodeConditions& conditions, std::vector<Sums>& sums, Add&& add)
{
    for (const TiedNodes& tie : conditions.tied) add(sums[tie.master], sums[tie.node]);
}

} // namespace

double node_porosity(const Problem& problem, const TwoPhaseSums& node)
{
    return node.mass_fluid > 0.0 ? node.mass_fluid / (problem.water->density * node.volume) : 0.0;
}

void set_flux(const Problem& problem, const TwoPhaseSums& node, TwoPhaseMotion& motion)
{
    const Vector2 flux = flux_of(node_porosity(problem, node), motion);
    motion.flux_x = flux.x();
    motion.flux_y = flux.y();
}

void set_velocities(const Problem& problem, const TwoPhaseSums& node, const Vector2& solid,
                    const Vector2& fluid, TwoPhaseMotion& motion)
{
    motion.solid_x = solid.x();
    motion.solid_y = solid.y();
    motion.fluid_x = fluid.x();
    motion.fluid_y = fluid.y();
    set_flux_and_change(problem, node, motion);
}

void set_velocity(const SinglePhaseSums& node, const Vector2& velocity, SinglePhaseMotion& motion)
{
    motion.x = velocity.x();
    motion.y = velocity.y();
    set_change(node, motion);
}

NodeImpulses two_phase_impulses(const Problem& problem, double dt, double acceleration,
                                const TwoPhaseSums& node)
{
    // the porosity of the node stands outside the sum of F^p: a constant pressure across a porosity jump
    // then gives no force between the phases
    const double fluid_density = problem.water->density;
    const double porosity = node_porosity(problem, node);
    const double buoyant_mass = node.mass_solid + node.mass_fluid - fluid_density * node.volume;
    const Vector2 pressure_force(node.pressure_force_x, node.pressure_force_y);
    const Vector2 stress_force(node.stress_force_x, node.stress_force_y);
    const Vector2 base(acceleration, 0.0);

    const Vector2 drag(node.drag_force_x, node.drag_force_y);
    const Vector2 inertia(node.inertia_force_x, node.inertia_force_y);

    const Vector2 force_fluid = porosity * pressure_force - node.mass_fluid * base - drag;
    const Vector2 force_solid = stress_force + (1.0 - porosity) * pressure_force - node.mass_solid * base -
                                Vector2(0.0, buoyant_mass * problem.gravity) + drag + inertia;
    return {Vector2(node.momentum_solid_x, node.momentum_solid_y) + dt * force_solid,
            Vector2(node.momentum_fluid_x, node.momentum_fluid_y) + dt * force_fluid};
}

double local_damping(double damping, double dt, double force, double momentum)
{
    constexpr double turning = 0.25; // of the force's impulse, below which the sense fades [-]
    const double size = std::abs(momentum) + turning * dt * std::abs(force);
    return size > 0.0 ? -damping * std::abs(force) * (momentum / size) : 0.0;
}

Vector2 single_phase_impulse(const Problem& problem, double dt, double acceleration, double damping,
                             const SinglePhaseSums& node)
{
    const auto damped = [&](double force, double momentum) {
        return force + local_damping(damping, dt, force, momentum);
    };
    const double force_x = damped(node.stress_force_x - node.mass * acceleration, node.momentum_x);
    const double force_y = damped(node.stress_force_y - node.weight * problem.gravity, node.momentum_y);
    return {node.momentum_x + dt * (force_x + node.inertia_force_x),
            node.momentum_y + dt * (force_y + node.inertia_force_y)};
}

void gather_tied_sums(const NodeConditions& conditions, std::vector<TwoPhaseSums>& sums)
{
    add_tied(conditions, sums, [](TwoPhaseSums& master, const TwoPhaseSums& node) {
        master.mass_solid += node.mass_solid;
        master.mass_fluid += node.mass_fluid;
        master.volume += node.volume;
        master.drag += node.drag;
        master.momentum_solid_x += node.momentum_solid_x;
        master.momentum_solid_y += node.momentum_solid_y;
        master.momentum_fluid_x += node.momentum_fluid_x;
        master.momentum_fluid_y += node.momentum_fluid_y;
        master.stress_force_x += node.stress_force_x;
        master.stress_force_y += node.stress_force_y;
        master.pressure_force_x += node.pressure_force_x;
        master.pressure_force_y += node.pressure_force_y;
    });
}

void gather_tied_sums(const NodeConditions& conditions, std::vector<SinglePhaseSums>& sums)
{
    add_tied(conditions, sums, [](SinglePhaseSums& master, const SinglePhaseSums& node) {
        master.mass += node.mass;
        master.momentum_x += node.momentum_x;
        master.momentum_y += node.momentum_y;
        master.weight += node.weight;
        master.stress_force_x += node.stress_force_x;
        master.stress_force_y += node.stress_force_y;
    });
}

void gather_tied_sums(const NodeConditions& conditions, std::vector<OuterForce>& outer)
{
    if (outer.empty()) return;
    add_tied(conditions, outer, [](OuterForce& master, const OuterForce& node) {
        master.load_x += node.load_x;
        master.load_y += node.load_y;
        master.water_x += node.water_x;
        master.water_y += node.water_y;
        master.risen_weight += node.risen_weight;
    });
}

void centre_drag(double dt, double strong, std::vector<TwoPhaseSums>& sums)
{
    for_each_index(sums.size(), [&](std::size_t i) {
        TwoPhaseSums& node = sums[i];
        if (!node.active() || !(node.drag > 0.0)) return;
        const double known_1 = take_known_drag(dt, strong, node, node.drag_1),
                     known_2 = take_known_drag(dt, strong, node, node.drag_2);
        const Vector2 relative(
            node.momentum_fluid_x / node.mass_fluid - node.momentum_solid_x / node.mass_solid,
            node.momentum_fluid_y / node.mass_fluid - node.momentum_solid_y / node.mass_solid);
        const Vector2 force = tensor_along_grid(node, known_1, known_2) * relative;
        node.drag_force_x = force.x();
        node.drag_force_y = force.y();
    });
}

PhaseVelocities solve_drag(double mass_solid, double mass_fluid, double dt_drag, double impulse_solid,
                           double impulse_fluid)
{
    if (mass_fluid == 0.0) return {impulse_solid / mass_solid, impulse_solid / mass_solid};
    // relative velocity r and velocity of the mixture
    const double mixture = (impulse_solid + impulse_fluid) / (mass_solid + mass_fluid);
    const double relative = (impulse_fluid / mass_fluid - impulse_solid / mass_solid) /
                            (1.0 + dt_drag * (1.0 / mass_solid + 1.0 / mass_fluid));
    const double fluid_fraction = mass_fluid / (mass_solid + mass_fluid);
    return {mixture - fluid_fraction * relative, mixture + (1.0 - fluid_fraction) * relative};
}

void solve_two_phase_momentum(const Problem& problem, const NodeConditions& conditions, double dt,
                              double acceleration, const std::vector<TwoPhaseSums>& sums,
                              std::vector<TwoPhaseMotion>& motion)
{
    for_each_index(sums.size(), [&](std::size_t i) {
        if (!sums[i].active()) {
            motion[i] = {};
            return;
        }
        const NodeImpulses impulses = two_phase_impulses(problem, dt, acceleration, sums[i]);
        motion[i] = solve_node(sums[i], impulses, dt, conditions.of_node[i]);
        set_flux_and_change(problem, sums[i], motion[i]);
    });
}

void set_pressure_compliances(const Problem& problem, const NodeConditions& conditions, double dt,
                              const std::vector<TwoPhaseSums>& sums, NodeCompliances& compliances)
{
    for (Scalars* part : {&compliances.xx, &compliances.xy, &compliances.yy}) part->resize(sums.size());
    for_each_index(sums.size(), [&](std::size_t i) {
        compliances.xx[i] = compliances.xy[i] = compliances.yy[i] = 0.0;
        if (!sums[i].active()) return;
        // along its axes the drag does not mix directions, so that one force in both of them tells both
        const double n = node_porosity(problem, sums[i]);
        const Vector2 flux = flux_of(
            n, solve_along_axes(sums[i], unit_pressure_impulses(n, {1.0, 1.0}), dt, conditions.of_node[i]));
        const Eigen::Matrix2d compliance = tensor_along_grid(sums[i], flux.x(), flux.y());
        compliances.xx[i] = compliance(0, 0);
        compliances.xy[i] = compliance(0, 1);
        compliances.yy[i] = compliance(1, 1);
    });
}

void solve_single_phase_momentum(const Problem& problem, const NodeConditions& conditions, double dt,
                                 double acceleration, double damping,
                                 const std::vector<SinglePhaseSums>& sums,
                                 std::vector<SinglePhaseMotion>& motion)
{
    for_each_index(sums.size(), [&](std::size_t i) {
        const SinglePhaseSums& node = sums[i];
        if (!node.active()) {
            motion[i] = {};
            return;
        }
        const std::uint8_t held = conditions.of_node[i];
        const Vector2 impulse = single_phase_impulse(problem, dt, acceleration, damping, node);
        motion[i].x = held & solid_x_fixed ? 0.0 : impulse.x() / node.mass;
        motion[i].y = held & solid_y_fixed ? 0.0 : impulse.y() / node.mass;
        set_change(node, motion[i]);
    });
}

} // namespace quicksand
