#include "solver/boundaries/surface_loads.hpp"

#include "solver/boundaries/free_field.hpp"
#include "solver/boundaries/viscous_boundary.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// Call add(node, force) for every nodal part of the forces force_of(carried piece) on a curve.
template <class ForceOf, class Add>
void distribute(const Problem& problem, const Boundary& boundary, const Particles& particles,
                ParticlePlaces& places, ForceOf&& force_of, Add&& add)
{
    for (const BoundaryPiece& piece : boundary.pieces) {
        const std::size_t p = places.find(particles, piece.identifier);
        const PresentPiece present = present_piece(problem, particles, piece, p);
        const Vector2 force = force_of(CarriedPiece{piece, present, particles, p});
        for_each_loaded_node(problem.grid, present,
                             [&](std::size_t i, double fraction) { add(i, fraction * force); });
    }
}

template <class Add>
void for_each_nodal_load(const Problem& problem, double time, const Particles& particles,
                         ParticlePlaces& places, Add&& add)
{
    for (const Boundary& boundary : problem.boundaries) {
        if (!presses(boundary.soil)) continue;
        const auto force = [&](const CarriedPiece& carried) {
            return force_on(boundary.soil, carried, time);
        };
        distribute(problem, boundary, particles, places, force, add);
    }
}

/// The excess pressure of the water beyond curves.
template <class Add>
void for_each_nodal_water(const Problem& problem, double time, const Particles& particles,
                          ParticlePlaces& places, Add&& add)
{
    for (const Boundary& boundary : problem.boundaries) {
        if (!has_outer_water(boundary.water)) continue;
        const double factor = outer_factor(boundary.water, time);
        const auto force = [&](const CarriedPiece& carried) -> Vector2 {
            const PresentPiece& present = carried.present;
            const double excess = outer_excess_pressure(problem, boundary, present.middle(), factor);
            return -excess * present.outward();
        };
        distribute(problem, boundary, particles, places, force, add);
    }
}

template <class Sums>
void scatter_nodal_loads(const Problem& problem, double time, const Particles& particles,
                         ParticlePlaces& places, std::vector<Sums>& sums)
{
    for_each_nodal_load(problem, time, particles, places, [&](std::size_t i, const Vector2& force) {
        sums[i].stress_force_x += force.x();
        sums[i].stress_force_y += force.y();
    });
}

} // namespace

void scatter_surface_loads(const Problem& problem, double time, const Particles& particles,
                           ParticlePlaces& places, std::vector<TwoPhaseSums>& sums)
{
    scatter_nodal_loads(problem, time, particles, places, sums);
}

void scatter_surface_loads(const Problem& problem, double time, const Particles& particles,
                           ParticlePlaces& places, std::vector<SinglePhaseSums>& sums)
{
    scatter_nodal_loads(problem, time, particles, places, sums);
}

void scatter_outer_water(const Problem& problem, double time, const Particles& particles,
                         ParticlePlaces& places, std::vector<TwoPhaseSums>& sums)
{
    for_each_nodal_water(problem, time, particles, places, [&](std::size_t i, const Vector2& force) {
        sums[i].pressure_force_x += force.x();
        sums[i].pressure_force_y += force.y();
    });
}

void scatter_outer_water(const Problem& problem, double time, const Particles& particles,
                         ParticlePlaces& places, std::vector<SinglePhaseSums>& sums)
{
    for_each_nodal_water(problem, time, particles, places, [&](std::size_t i, const Vector2& force) {
        sums[i].stress_force_x += force.x();
        sums[i].stress_force_y += force.y();
    });
}

bool has_outer_forces(const Problem& problem)
{
    return std::any_of(problem.boundaries.begin(), problem.boundaries.end(), acts_on_soil);
}

void note_outer_forces(const Problem& problem, double time, const State& state, ParticlePlaces& places,
                       std::vector<OuterForce>& outer)
{
    const auto add_load = [&](std::size_t i, const Vector2& force) {
        outer[i].load_x += force.x();
        outer[i].load_y += force.y();
    };
    for_each_nodal_load(problem, time, state.particles, places, add_load);
    for_each_nodal_reaction(problem, state, places, add_load);
    if (state.stage == Stage::shaking)
        for (const GroundForce& ground : free_field_forces(problem, state, places)) {
            add_load(ground.node, ground.grains);
            outer[ground.node].water_x += ground.mixture_x;
        }
    for_each_nodal_water(problem, time, state.particles, places, [&](std::size_t i, const Vector2& force) {
        outer[i].water_x += force.x();
        outer[i].water_y += force.y();
    });
}

double load_time(const State& state)
{
    return state.stage == Stage::relaxation ? 0.0 : state.time;
}

Vector2 full_load(const Problem& problem, const State& state, const Boundary& boundary)
{
    Vector2 force = Vector2::Zero();
    const SurfaceLoad* load = load_of(boundary.soil);
    if (load == nullptr) return force;
    ParticlePlaces places;
    for (const BoundaryPiece& piece : boundary.pieces) {
        const std::size_t p = places.find(state.particles, piece.identifier);
        force += full_force(*load, piece, present_piece(problem, state.particles, piece, p));
    }
    return force;
}

} // namespace quicksand
