#include "solver/measure/balances.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/threads.hpp"
#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/layer_axes.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/water/pore_pressure.hpp"

#include <array>
#include <cmath>

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

/// The wall's reaction works with the wall's velocity; that it stops nodes is a loss.
void enter_reaction(const Vector2& reaction, const PhaseStep& phase, StepEntries& entries)
{
    const double at_wall = reaction.dot(phase.end);
    entries.boundary += at_wall;
    entries.wall_loss += at_wall - reaction.dot(phase.working);
    entries.impulse += reaction;
}

void enter_node(const Problem& problem, double dt, double acceleration, WorkingVelocity working,
                NodeKind kind, const TwoPhaseSums& node, const OuterForce& outer,
                const TwoPhaseMotion& motion, StepEntries& entries)
{
    const PhaseStep solid = phase_step(working, node.mass_solid, motion.solid_x, motion.solid_y,
                                       motion.solid_change_x, motion.solid_change_y);
    const PhaseStep fluid = phase_step(working, node.mass_fluid, motion.fluid_x, motion.fluid_y,
                                       motion.fluid_change_x, motion.fluid_change_y);

    const double density = problem.water->density;
    const double porosity = node_porosity(problem, node);
    const Vector2 stress = dt * Vector2(node.stress_force_x, node.stress_force_y);
    const Vector2 pressure = dt * Vector2(node.pressure_force_x, node.pressure_force_y);
    const Vector2 base_solid(-dt * node.mass_solid * acceleration, 0.0);
    const Vector2 base_fluid(-dt * node.mass_fluid * acceleration, 0.0);
    const Vector2 weight(0.0,
                         -dt * problem.gravity * (node.mass_solid + node.mass_fluid - density * node.volume));
    const Vector2 risen(0.0, -dt * outer.risen_weight);
    const Vector2 load(dt * outer.load_x, dt * outer.load_y);
    const Vector2 water(dt * outer.water_x, dt * outer.water_y);
    const Vector2 flux = (1.0 - porosity) * solid.working + porosity * fluid.working;
    const Vector2 drag =
        dt * (drag_tensor(node) * (fluid.end - solid.end) + Vector2(node.drag_force_x, node.drag_force_y));
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
    const Vector2 known_solid = stress + (1.0 - porosity) * pressure + base_solid + weight + drag + inertia;
    const Vector2 known_fluid = porosity * pressure + base_fluid - drag;
    enter_reaction(solid.impulse - known_solid, solid, entries);
    enter_reaction(fluid.impulse - known_fluid, fluid, entries);
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
    if (kind == wall_node) enter_reaction(body.impulse - (stress + weight + base + inertia), body, entries);
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

/// sum value(p) over the particles, four sums side by side: one alone would wait for each addition.
template <class Value>
double sum_particles(std::size_t count, Value&& value)
{
    return ordered_sum(count, 0.0, [&](std::size_t first, std::size_t last) {
        std::array<double, 4> lanes{};
        for (; first + 4 <= last; first += 4)
            for (std::size_t k = 0; k < 4; ++k) lanes[k] += value(first + k);
        for (; first < last; ++first) lanes[0] += value(first);
        return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
    });
}

/// Sum over the particles [first, last) of the growth of their volume in the step times the velocity of their
/// water [m4/(m s)].
VECTOR_KERNEL
Vector2 momentum_of_growth(double dt, const Scalars& volume, const Particles& particles, std::size_t first,
                           std::size_t last)
{
    const Gradients& L = particles.velocity_gradient_solid;
    const Vectors& water =
        particles.velocity_fluid.x.empty() ? particles.velocity_solid : particles.velocity_fluid;
    const auto growth = [dt](const auto& V, const auto& xx, const auto& xy, const auto& yx, const auto& yy) {
        return V * (dt * (xx + yy) + dt * dt * (xx * yy - xy * yx));
    };
    Lanes x = all_lanes(0.0), y = x;
    std::size_t p = first;
    for (; p + 4 <= last; p += 4) {
        const Lanes dV = growth(load_lanes(&volume[p]), load_lanes(&L.xx[p]), load_lanes(&L.xy[p]),
                                load_lanes(&L.yx[p]), load_lanes(&L.yy[p]));
        x += dV * load_lanes(&water.x[p]);
        y += dV * load_lanes(&water.y[p]);
    }
    for (; p < last; ++p) {
        const double dV = growth(volume[p], L.xx[p], L.xy[p], L.yx[p], L.yy[p]);
        x[0] += dV * water.x[p];
        y[0] += dV * water.y[p];
    }
    return {(x[0] + x[1]) + (x[2] + x[3]), (y[0] + y[1]) + (y[2] + y[3])};
}

/// Whether a particle is wet, a function of its number; materials are looked up only where there are both
/// kinds.
auto wetness(const Problem& problem, const Particles& particles)
{
    return [&, all_wet = !is_partly_wet(problem)](std::size_t p) {
        return all_wet || is_wet(problem.materials[static_cast<std::size_t>(particles.material[p])]);
    };
}

/// With the kinetic energy that a sum over the particles has found.
EnergyBalance balance_energy(const Problem& problem, const State& state, double kinetic_energy)
{
    const BalanceTerms& terms = *state.balance_terms;
    EnergyBalance result;
    result.kinetic = kinetic_energy;
    const double kinetic = kinetic_energy - terms.opening_kinetic_energy;
    result.numerical_loss = terms.kinetic_change - kinetic + terms.wall_loss;
    const double outside = terms.gravity_work + terms.base_work + terms.boundary_work;
    double stored = 0.0, storage = 0.0;
    if (problem.water) {
        storage = storage_energy(problem, state.particles);
        // undrained, the skeleton's work is that of the total stress and includes the water's part
        if (water_flow(problem) == WaterFlow::coupled)
            stored = storage - terms.late_pressure_work - terms.opening_storage_energy;
    }
    result.residual = kinetic + result.numerical_loss + terms.skeleton_work + stored + terms.inertia_work +
                      terms.drag_dissipation - outside;
    result.turnover = kinetic_energy + terms.opening_kinetic_energy + std::abs(terms.skeleton_work) +
                      storage + std::abs(terms.opening_storage_energy) + std::abs(terms.inertia_work) +
                      std::abs(terms.drag_dissipation) + std::abs(terms.gravity_work) +
                      std::abs(terms.base_work) + std::abs(terms.boundary_work);
    return result;
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

void open_balances(const Problem& problem, State& state)
{
    const Monitors sums = monitor(problem, state, {});
    BalanceTerms terms;
    terms.opening_kinetic_energy = sums.kinetic_energy;
    terms.opening_momentum_x = sums.momentum_x;
    terms.opening_momentum_y = sums.momentum_y;
    if (problem.water) {
        terms.opening_storage_energy = storage_energy(problem, state.particles);
        terms.opening_water_content = water_content(problem, state.particles);
    }
    state.balance_terms = terms;
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

double stress_power(const Particles& particles)
{
    const Gradients& L = particles.velocity_gradient_solid;
    const SymmetricTensors& stress = particles.stress;
    return sum_particles(particles.size(), [&](std::size_t p) {
        return particles.volume[p] *
               (stress.xx[p] * L.xx[p] + stress.yy[p] * L.yy[p] + stress.xy[p] * (L.xy[p] + L.yx[p]));
    });
}

void enter_skeleton_work(double work, double work_of_nodes, BalanceTerms& terms)
{
    terms.skeleton_work += work - work_of_nodes;
    terms.inertia_work -= work - work_of_nodes;
}

void enter_outflow(const Problem& problem, double dt, const Particles& particles,
                   const Scalars& flux_divergence, BalanceTerms& terms)
{
    const Gradients& L = particles.velocity_gradient_solid;
    const auto is_wet = wetness(problem, particles);
    const auto outflow = [&](std::size_t p) {
        if (!is_wet(p)) return 0.0;
        return particles.volume[p] * (flux_divergence[p] - (L.xx[p] + L.yy[p]));
    };
    terms.outflow += dt * sum_particles(particles.size(), outflow);
}

void enter_exchange(const Problem& problem, double dt, const Particles& particles, BalanceTerms& terms)
{
    const bool pores_are_constant = problem.strain == StrainForm::small;
    if (!problem.water || pores_are_constant || water_flow(problem) == WaterFlow::undrained) return;
    Scalars wet;
    if (is_partly_wet(problem)) set_wet_volumes(problem, particles, wet);
    const Scalars& volume = wet.empty() ? particles.volume : wet;
    const Vector2 sum =
        ordered_sum<Vector2>(particles.size(), Vector2::Zero(), [&](std::size_t first, std::size_t last) {
            return momentum_of_growth(dt, volume, particles, first, last);
        });
    terms.exchange_x += problem.water->density * sum.x();
    terms.exchange_y += problem.water->density * sum.y();
}

BalanceErrors balance(const Problem& problem, const State& state)
{
    BalanceErrors result;
    if (!state.balance_terms) return result;
    const BalanceTerms& terms = *state.balance_terms;
    const Monitors sums = monitor(problem, state, {});
    const EnergyBalance energy = balance_energy(problem, state, sums.kinetic_energy);
    result.numerical_loss = energy.numerical_loss;
    result.energy_error = energy.error();
    // drained water comes and goes uncounted
    if (problem.water && water_flow(problem) != WaterFlow::drained && terms.opening_water_content > 0.0)
        result.water_error =
            (water_content(problem, state.particles) + terms.outflow - terms.opening_water_content) /
            terms.opening_water_content;
    result.momentum_error_x = sums.momentum_x - terms.opening_momentum_x - terms.impulse_x - terms.exchange_x;
    result.momentum_error_y = sums.momentum_y - terms.opening_momentum_y - terms.impulse_y - terms.exchange_y;
    return result;
}

EnergyBalance energy_balance(const Problem& problem, const State& state)
{
    if (!state.balance_terms) return {};
    return balance_energy(problem, state, kinetic_energy(problem, state.particles));
}

double energy_put_in(const BalanceTerms& terms)
{
    return terms.opening_kinetic_energy + std::abs(terms.opening_storage_energy) +
           std::abs(terms.gravity_work) + std::abs(terms.base_work) + std::abs(terms.boundary_work);
}

double storage_energy(const Problem& problem, const Particles& particles)
{
    double sum = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double pressure = excess_pore_pressure(particles, p);
        // cavities have opened against the tension of the limit
        const double missing = particles.tension_deficit.empty() ? 0.0 : particles.tension_deficit[p];
        sum += particles.porosity[p] * particles.volume[p] * pressure * (0.5 * pressure + missing);
    }
    return sum / problem.water->bulk_modulus;
}

double water_content(const Problem& problem, const Particles& particles)
{
    const bool fixed = problem.strain == StrainForm::small;
    const auto is_wet = wetness(problem, particles);
    const Scalars& heights = fixed ? particles.reference_position.y : particles.position.y;
    double sum = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!is_wet(p)) continue;
        // cavities have the volume that belongs to the missing tension
        const double cavities = particles.tension_deficit.empty() ? 0.0 : particles.tension_deficit[p];
        const double pressure =
            excess_pore_pressure(particles, p) + cavities + static_water_pressure(problem, heights[p]);
        sum += particles.porosity[p] * particles.volume[p] * (1.0 + pressure / problem.water->bulk_modulus);
        if (fixed) sum += particles.volume[p] * (deformation_gradient(particles, p).trace() - 2.0);
    }
    return sum;
}

} // namespace quicksand
