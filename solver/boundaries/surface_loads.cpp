#include "solver/boundaries/surface_loads.hpp"

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

} // namespace

void add_surface_loads(const Problem& problem, double time, const Particles& particles,
                       ParticlePlaces& places, std::vector<NodalForce>& forces)
{
    for (const Boundary& boundary : problem.boundaries) {
        if (!presses(boundary.soil)) continue;
        const auto force = [&](const CarriedPiece& carried) {
            return force_on(boundary.soil, carried, time);
        };
        distribute(problem, boundary, particles, places, force, [&](std::size_t i, const Vector2& part) {
            forces.push_back({i, part, Vector2::Zero()});
        });
    }
}

void add_outer_water(const Problem& problem, double time, const Particles& particles, ParticlePlaces& places,
                     std::vector<NodalForce>& forces)
{
    for (const Boundary& boundary : problem.boundaries) {
        if (!has_outer_water(boundary.water)) continue;
        const double factor = outer_factor(boundary.water, time);
        const auto force = [&](const CarriedPiece& carried) -> Vector2 {
            const PresentPiece& present = carried.present;
            const double excess = outer_excess_pressure(problem, boundary, present.middle(), factor);
            return -excess * present.outward();
        };
        distribute(problem, boundary, particles, places, force, [&](std::size_t i, const Vector2& part) {
            forces.push_back({i, Vector2::Zero(), part});
        });
    }
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
