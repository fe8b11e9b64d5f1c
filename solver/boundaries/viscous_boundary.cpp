#include "solver/boundaries/viscous_boundary.hpp"

#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/node_response.hpp"
#include "solver/problem/wave_speeds.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace quicksand {

namespace {

/// M of unloading of a particle at its present state, at the frequencies at which the damping of its law
/// leaves the stiffness as it is [Pa].
double unloading_modulus(const Material& material, const Particles& particles, std::size_t p)
{
    return std::visit(
        [&](const auto& law) { return particle_moduli(undamped(law), p, p + 1, particles).mean; },
        material.law);
}

/// Sort by node and add up what lies on the same node, in the order in which it came.
void merge(std::vector<Dashpot>& dashpots)
{
    std::stable_sort(dashpots.begin(), dashpots.end(),
                     [](const Dashpot& a, const Dashpot& b) { return a.node < b.node; });
    std::size_t count = 0;
    for (const Dashpot& dashpot : dashpots) {
        if (count > 0 && dashpots[count - 1].node == dashpot.node) {
            dashpots[count - 1].xx += dashpot.xx;
            dashpots[count - 1].xy += dashpot.xy;
            dashpots[count - 1].yy += dashpot.yy;
        } else {
            dashpots[count++] = dashpot;
        }
    }
    dashpots.resize(count);
}

/// The grains are braked, with the water drawn along. The mean of the velocities
/// before and after the step stands at the time of the forces; the velocity after it alone would come half a
/// step late, which at 20 cells a wavelength sends 5 per cent of a wave back.
template <class Sums, class Motion>
void brake(const NodeConditions& conditions, double dt, const std::vector<Dashpot>& dashpots,
           const std::vector<Sums>& sums, std::vector<Motion>& motion)
{
    for (const Dashpot& dashpot : dashpots) {
        const std::size_t i = dashpot.node;
        if (!sums[i].active()) continue;
        const NodeResponses r = responses(sums[i], dt, conditions.of_node[i]);
        const Braking braking = braking_of(dashpot, dt, r);
        const Vector2 before = velocity_before(motion[i]), unbraked = solid_velocity(motion[i]);
        const Vector2 braked = braking.left * (unbraked - braking.factor * before);
        const Vector2 impulse = -braking.half * (before + braked);
        add_velocity(motion[i], r.solid * impulse, r.exchange * impulse);
    }
}

} // namespace

Braking braking_of(const Dashpot& dashpot, double dt, const NodeResponses& responses)
{
    Braking braking;
    braking.half << dashpot.xx, dashpot.xy, dashpot.xy, dashpot.yy;
    braking.half *= 0.5 * dt;
    braking.factor = responses.solid * braking.half;
    braking.left = (Eigen::Matrix2d::Identity() + braking.factor).inverse();
    return braking;
}

Impedance impedance(const Problem& problem, const Boundary& boundary, const Particles& particles,
                    std::size_t p)
{
    if (const std::optional<Impedance> of_rock = impedance_beyond(boundary.soil)) return *of_rock;
    const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
    const double n = material.porosity;
    const std::optional<Water>& water = water_of(problem, material);
    const WaveSpeeds speeds = wave_speeds(material, unloading_modulus(material, particles, p), water, n);
    const double density = (1.0 - n) * material.grain_density + (water ? n * water->density : 0.0);
    // beyond a free field water and grains go on together, though water passes
    const bool sealed = water && (std::holds_alternative<Impervious>(boundary.water) ||
                                  std::holds_alternative<FreeFieldSide>(boundary.soil));
    return {density * (sealed ? speeds.undrained : speeds.skeleton), density * speeds.shear};
}

PresentPiece braking_piece(PresentPiece piece)
{
    double sum = 0.0;
    for (double& fraction : piece.fractions) {
        fraction = std::max(fraction, 0.0);
        sum += fraction;
    }
    for (double& fraction : piece.fractions) fraction /= sum;
    return piece;
}

Dashpot dashpot_of(const Problem& problem, const Boundary& boundary, const CarriedPiece& carried)
{
    const Impedance beyond = impedance(problem, boundary, carried.particles, carried.p);
    const Vector2 n = carried.present.outward().normalized();
    // rho V_p n n^T + rho V_s (I - n n^T)
    const double length = carried.piece.length, shear = length * beyond.shear,
                 extra = length * (beyond.normal - beyond.shear);
    return {0, shear + extra * n.x() * n.x(), extra * n.x() * n.y(), shear + extra * n.y() * n.y()};
}

void gather_dashpots(const Problem& problem, const Particles& particles, const NodeConditions& conditions,
                     ParticlePlaces& places, std::vector<Dashpot>& dashpots)
{
    dashpots.clear();
    for (const Boundary& boundary : problem.boundaries) {
        if (!absorbs_waves(boundary.soil)) continue;
        for (const BoundaryPiece& piece : boundary.pieces) {
            const std::size_t p = places.find(particles, piece.identifier);
            const PresentPiece present = present_piece(problem, particles, piece, p);
            const Dashpot whole = dashpot_of(problem, boundary, {piece, present, particles, p});
            for_each_loaded_node(problem.grid, braking_piece(present), [&](std::size_t i, double fraction) {
                if (fraction != 0.0)
                    dashpots.push_back({conditions.master[i], fraction * whole.xx, fraction * whole.xy,
                                        fraction * whole.yy});
            });
        }
    }
    merge(dashpots);
}

void brake_by_dashpots(const Problem& problem, const NodeConditions& conditions, double dt,
                       const std::vector<Dashpot>& dashpots, const std::vector<TwoPhaseSums>& sums,
                       std::vector<TwoPhaseMotion>& motion)
{
    brake(conditions, dt, dashpots, sums, motion);
    for (const Dashpot& dashpot : dashpots) {
        if (sums[dashpot.node].active()) set_flux(problem, sums[dashpot.node], motion[dashpot.node]);
    }
}

void brake_by_dashpots(const NodeConditions& conditions, double dt, const std::vector<Dashpot>& dashpots,
                       const std::vector<SinglePhaseSums>& sums, std::vector<SinglePhaseMotion>& motion)
{
    brake(conditions, dt, dashpots, sums, motion);
}

void add_held_reactions(const Problem& problem, const State& state, ParticlePlaces& places,
                        std::vector<NodalForce>& forces)
{
    if (state.reactions.x.empty() || state.stage != Stage::shaking) return;
    std::size_t k = 0;
    for_each_held_piece(problem, [&](const Boundary&, const BoundaryPiece& piece) {
        const Vector2 force = state.reactions[k++];
        if (force == Vector2::Zero()) return;
        const std::size_t p = places.find(state.particles, piece.identifier);
        for_each_loaded_node(problem.grid, present_piece(problem, state.particles, piece, p),
                             [&](std::size_t i, double fraction) {
                                 forces.push_back({i, fraction * force, Vector2::Zero()});
                             });
    });
}

} // namespace quicksand
