#include "solver/measure/node_works.hpp"

#include "solver/base/threads.hpp"
#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/layer_axes.hpp"

namespace quicksand {

namespace {

enum NodeKind : std::uint8_t { stands_for_nobody, free_node, wall_node };

/// The entries of one step, nodes summed up.
struct StepEntries {
    double kinetic = 0.0, works = 0.0, skeleton = 0.0, late_pressure = 0.0; // [J/m]
    double inertia = 0.0, drag = 0.0, gravity = 0.0, base = 0.0, boundary = 0.0, wall_loss = 0.0;
    Vector2 impulse = Vector2::Zero(); // [N s/m]

    StepEntries& operator+=(const StepEntries& other)
    {
        kinetic += other.kinetic;
        works += other.works;
        skeleton += other.skeleton;
        late_pressure += other.late_pressure;
        inertia += other.inertia;
        drag += other.drag;
        gravity += other.gravity;
        base += other.base;
        boundary += other.boundary;
        wall_loss += other.wall_loss;
        impulse += other.impulse;
        return *this;
    }
};

/// One phase's motion at a node over the step.
struct PhaseStep {
    Vector2 end, mean, working, impulse; // v_1, (v_0 + v_1)/2, v of the works [m/s] and m (v_1 - v_0) [N s/m]
    double kinetic() const { return impulse.dot(mean); }  // what its energy gains [J/m]
    double works() const { return impulse.dot(working); } // of all forces, with the velocity of the works
};

PhaseStep phase_step(WorkingVelocity working, double mass, double x, double y, double change_x,
                     double change_y)
{
    const Vector2 end(x, y), change(change_x, change_y), mean = end - 0.5 * change;
    return {end, mean, working == WorkingVelocity::mean ? mean : end, mass * change};
}

/// The wall's reaction works with the wall's velocity, that after the step if it does not change; that it
/// stops nodes is a loss.
void enter_reaction(const Vector2& reaction, const PhaseStep& phase, StepEntries& entries)
{
    const double at_wall = reaction.dot(phase.end);
    entries.boundary += at_wall;
    entries.wall_loss += at_wall - reaction.dot(phase.working);
    entries.impulse += reaction;
}

/// Impulse of the drag on the grains [N s/m].
Vector2 drag_impulse(double dt, const TwoPhaseSums& node, const TwoPhaseMotion& motion)
{
    const Vector2 against_grains(motion.fluid_x - motion.solid_x, motion.fluid_y - motion.solid_y);
    return dt * (drag_tensor(node) * against_grains + Vector2(node.drag_force_x, node.drag_force_y));
}

/// Weight less the water's buoyancy, which the pressure's force has [N s/m].
Vector2 weight_impulse(const Problem& problem, double dt, const TwoPhaseSums& node)
{
    return {0.0, -dt * problem.gravity *
                     (node.mass_solid + node.mass_fluid - problem.water->density * node.volume)};
}

/// What the impulse of the known forces is short of the change of momentum, on grains and water [N s/m].
NodeVelocities reaction_on(const Problem& problem, double dt, double acceleration, const TwoPhaseSums& node,
                           const TwoPhaseMotion& motion)
{
    const double porosity = node_porosity(problem, node);
    const Vector2 pressure = dt * Vector2(node.pressure_force_x, node.pressure_force_y);
    const Vector2 drag = drag_impulse(dt, node, motion);
    const Vector2 known_solid =
        dt * Vector2(node.stress_force_x + node.inertia_force_x - node.mass_solid * acceleration,
                     node.stress_force_y + node.inertia_force_y) +
        (1.0 - porosity) * pressure + weight_impulse(problem, dt, node) + drag;
    const Vector2 known_fluid =
        porosity * pressure - Vector2(dt * node.mass_fluid * acceleration, 0.0) - drag;
    NodeVelocities reaction;
    reaction << node.mass_solid * Vector2(motion.solid_change_x, motion.solid_change_y) - known_solid,
        node.mass_fluid * Vector2(motion.fluid_change_x, motion.fluid_change_y) - known_fluid;
    return reaction;
}

NodeVelocities reaction_on(const Problem& problem, double dt, double acceleration,
                           const SinglePhaseSums& node, const SinglePhaseMotion& motion)
{
    const Vector2 known =
        dt * Vector2(node.stress_force_x + node.inertia_force_x - node.mass * acceleration,
                     node.stress_force_y + node.inertia_force_y - node.weight * problem.gravity);
    NodeVelocities reaction = NodeVelocities::Zero();
    reaction.head<2>() = node.mass * Vector2(motion.change_x, motion.change_y) - known;
    return reaction;
}

void enter_node(const Problem& problem, double dt, double acceleration, WorkingVelocity working,
                NodeKind kind, const TwoPhaseSums& node, const OuterForce& outer,
                const TwoPhaseMotion& motion, StepEntries& entries)
{
    const PhaseStep solid = phase_step(working, node.mass_solid, motion.solid_x, motion.solid_y,
                                       motion.solid_change_x, motion.solid_change_y);
    const PhaseStep fluid = phase_step(working, node.mass_fluid, motion.fluid_x, motion.fluid_y,
                                       motion.fluid_change_x, motion.fluid_change_y);

    const double porosity = node_porosity(problem, node);
    const Vector2 stress = dt * Vector2(node.stress_force_x, node.stress_force_y);
    const Vector2 pressure = dt * Vector2(node.pressure_force_x, node.pressure_force_y);
    const Vector2 base_solid(-dt * node.mass_solid * acceleration, 0.0);
    const Vector2 base_fluid(-dt * node.mass_fluid * acceleration, 0.0);
    const Vector2 weight = weight_impulse(problem, dt, node);
    const Vector2 risen(0.0, -dt * outer.risen_weight);
    const Vector2 load(dt * outer.load_x, dt * outer.load_y);
    const Vector2 water(dt * outer.water_x, dt * outer.water_y);
    const Vector2 flux = (1.0 - porosity) * solid.working + porosity * fluid.working;
    const Vector2 drag = drag_impulse(dt, node, motion);
    const Vector2 inertia = dt * Vector2(node.inertia_force_x, node.inertia_force_y);

    entries.kinetic += solid.kinetic() + fluid.kinetic();
    entries.works += solid.works() + fluid.works();
    entries.skeleton -= (stress - load).dot(solid.working);
    entries.boundary += load.dot(solid.working) + water.dot(flux);
    entries.late_pressure -=
        0.5 * (pressure - risen - water).dot((1.0 - porosity) * solid.end + porosity * fluid.end);
    entries.inertia -= inertia.dot(solid.working);
    entries.drag += drag.dot(fluid.working - solid.working);
    entries.gravity += weight.dot(solid.working) + risen.dot(flux);
    entries.base += base_solid.dot(solid.working) + base_fluid.dot(fluid.working);
    entries.impulse += weight + risen + load + water + base_solid + base_fluid;
    if (kind != wall_node) return;
    const NodeVelocities reaction = reaction_on(problem, dt, acceleration, node, motion);
    enter_reaction(reaction.head<2>(), solid, entries);
    enter_reaction(reaction.tail<2>(), fluid, entries);
}

void enter_node(const Problem& problem, double dt, double acceleration, WorkingVelocity working,
                NodeKind kind, const SinglePhaseSums& node, const OuterForce& outer,
                const SinglePhaseMotion& motion, StepEntries& entries)
{
    const PhaseStep body =
        phase_step(working, node.mass, motion.x, motion.y, motion.change_x, motion.change_y);
    const Vector2 stress = dt * Vector2(node.stress_force_x, node.stress_force_y);
    const Vector2 base(-dt * node.mass * acceleration, 0.0), weight(0.0, -dt * node.weight * problem.gravity);
    const Vector2 load(dt * (outer.load_x + outer.water_x), dt * (outer.load_y + outer.water_y));
    const Vector2 inertia = dt * Vector2(node.inertia_force_x, node.inertia_force_y);
    entries.kinetic += body.kinetic();
    entries.works += body.works();
    entries.skeleton -= (stress - load).dot(body.working);
    entries.boundary += load.dot(body.working);
    entries.inertia -= inertia.dot(body.working);
    entries.gravity += weight.dot(body.working);
    entries.base += base.dot(body.working);
    entries.impulse += weight + load + base;
    if (kind == wall_node)
        enter_reaction(reaction_on(problem, dt, acceleration, node, motion).head<2>(), body, entries);
}

/// Add a step's sums to the terms; returns the skeleton's work. Where the pressure works with the velocities
/// after the step it is not ahead of them: what counts for stored then does not change with the half step.
/// All forces together do more work on those velocities than the kinetic energy takes: the difference is
/// lost.
double enter_step(const StepEntries& step, const Working& working, BalanceTerms& terms)
{
    if (working.velocity == WorkingVelocity::last)
        terms.opening_storage_energy += terms.late_pressure_work - step.late_pressure;
    const double share = working.share;
    terms.kinetic_change += step.kinetic;
    terms.skeleton_work += share * step.skeleton;
    terms.late_pressure_work = step.late_pressure;
    terms.inertia_work += share * (step.inertia + step.works) - step.kinetic;
    terms.drag_dissipation += share * step.drag;
    terms.gravity_work += share * step.gravity;
    terms.base_work += share * step.base;
    terms.boundary_work += share * step.boundary;
    terms.wall_loss += share * step.wall_loss;
    terms.impulse_x += step.impulse.x();
    terms.impulse_y += step.impulse.y();
    return share * step.skeleton;
}

template <class Sums, class Motion>
double enter_all_nodes(const Problem& problem, const std::vector<std::uint8_t>& nodes, double dt,
                       double acceleration, const Working& working, const std::vector<Sums>& sums,
                       const std::vector<OuterForce>& outer, const std::vector<Motion>& motion,
                       BalanceTerms& terms)
{
    const auto step = ordered_sum<StepEntries>(sums.size(), {}, [&](std::size_t first, std::size_t last) {
        StepEntries entries;
        for (std::size_t i = first; i < last; ++i) {
            if (nodes[i] == stands_for_nobody || !sums[i].active()) continue;
            enter_node(problem, dt, acceleration, working.velocity, static_cast<NodeKind>(nodes[i]), sums[i],
                       outer.empty() ? OuterForce{} : outer[i], motion[i], entries);
        }
        return entries;
    });
    return enter_step(step, working, terms);
}

/// The reactions have been entered with the walls' velocities after the step.
template <class Sums, class Motion>
void enter_changes(const Problem& problem, double dt, double acceleration, const Working& working,
                   const std::vector<Sums>& sums, const std::vector<Motion>& motion, const VelocityRows& rows,
                   const std::vector<NodeVelocities>& changes, BalanceTerms& terms)
{
    if (working.velocity == WorkingVelocity::last) return;
    double work = 0.0;
    for (std::size_t k = 0; k < changes.size(); ++k) {
        const std::size_t i = rows.nodes()[k];
        if (sums[i].active())
            work -= 0.5 * changes[k].dot(reaction_on(problem, dt, acceleration, sums[i], motion[i]));
    }
    terms.boundary_work += working.share * work;
    terms.wall_loss += working.share * work;
}

} // namespace

std::vector<std::uint8_t> balance_nodes(const NodeConditions& conditions)
{
    std::vector<std::uint8_t> kinds(conditions.of_node.size(), free_node);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (conditions.of_node[i] != 0) kinds[i] = wall_node;
    }
    for (const TiedNodes& tie : conditions.tied) kinds[tie.node] = stands_for_nobody;
    return kinds;
}

void count_reaction(std::size_t node, std::vector<std::uint8_t>& kinds)
{
    kinds[node] = wall_node;
}

double enter_nodes(const Problem& problem, const std::vector<std::uint8_t>& nodes, double dt,
                   double acceleration, const Working& working, const std::vector<TwoPhaseSums>& sums,
                   const std::vector<OuterForce>& outer, const std::vector<TwoPhaseMotion>& motion,
                   BalanceTerms& terms)
{
    return enter_all_nodes(problem, nodes, dt, acceleration, working, sums, outer, motion, terms);
}

double enter_nodes(const Problem& problem, const std::vector<std::uint8_t>& nodes, double dt,
                   double acceleration, const Working& working, const std::vector<SinglePhaseSums>& sums,
                   const std::vector<OuterForce>& outer, const std::vector<SinglePhaseMotion>& motion,
                   BalanceTerms& terms)
{
    return enter_all_nodes(problem, nodes, dt, acceleration, working, sums, outer, motion, terms);
}

void enter_moving_walls(const Problem& problem, double dt, double acceleration, const Working& working,
                        const std::vector<TwoPhaseSums>& sums, const std::vector<TwoPhaseMotion>& motion,
                        const VelocityRows& rows, const std::vector<NodeVelocities>& changes,
                        BalanceTerms& terms)
{
    enter_changes(problem, dt, acceleration, working, sums, motion, rows, changes, terms);
}

void enter_moving_walls(const Problem& problem, double dt, double acceleration, const Working& working,
                        const std::vector<SinglePhaseSums>& sums,
                        const std::vector<SinglePhaseMotion>& motion, const VelocityRows& rows,
                        const std::vector<NodeVelocities>& changes, BalanceTerms& terms)
{
    enter_changes(problem, dt, acceleration, working, sums, motion, rows, changes, terms);
}

} // namespace quicksand
