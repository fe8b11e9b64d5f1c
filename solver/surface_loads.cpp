#include "solver/surface_loads.hpp"

namespace quicksand {

namespace {

/// Force of a load at its full value on a piece of its curve.
Vector2 full_force(const SurfaceLoad& load, const BoundaryPiece& piece, const PresentPiece& present)
{
    return piece.length * load.traction - load.pressure * present.outward();
}

template <class Sums>
void scatter(const Problem& problem, double time, const Particles& particles, ParticlePlaces& places,
             std::vector<Sums>& sums)
{
    for (const Boundary& boundary : problem.boundaries) {
        if (!boundary.load) continue;
        const double factor = history_value(boundary.load->history, time);
        for (const BoundaryPiece& piece : boundary.pieces) {
            const std::size_t p = places.find(particles, piece.identifier);
            const PresentPiece present = present_piece(problem, particles, piece, p);
            const Vector2 force = factor * full_force(*boundary.load, piece, present);
            for_each_loaded_node(problem.grid, present, [&](std::size_t i, double share) {
                sums[i].stress_force_x += share * force.x();
                sums[i].stress_force_y += share * force.y();
            });
        }
    }
}

} // namespace

void scatter_surface_loads(const Problem& problem, double time, const Particles& particles,
                           ParticlePlaces& places, std::vector<TwoPhaseSums>& sums)
{
    scatter(problem, time, particles, places, sums);
}

void scatter_surface_loads(const Problem& problem, double time, const Particles& particles,
                           ParticlePlaces& places, std::vector<SinglePhaseSums>& sums)
{
    scatter(problem, time, particles, places, sums);
}

void scatter_outer_water(const Problem& problem, double time, const Particles& particles,
                         ParticlePlaces& places, std::vector<TwoPhaseSums>& sums)
{
    for (const Boundary& boundary : problem.boundaries) {
        if (!boundary.outer_water) continue;
        const double factor = history_value(boundary.outer_water->history, time);
        for (const BoundaryPiece& piece : boundary.pieces) {
            const std::size_t p = places.find(particles, piece.identifier);
            const PresentPiece present = present_piece(problem, particles, piece, p);
            const double excess =
                factor * outer_excess_pressure(problem, *boundary.outer_water, present.middle().y());
            const Vector2 force = -excess * present.outward();
            for_each_loaded_node(problem.grid, present, [&](std::size_t i, double share) {
                sums[i].pressure_force_x += share * force.x();
                sums[i].pressure_force_y += share * force.y();
            });
        }
    }
}

double load_time(const State& state, double dt)
{
    return state.stage == Stage::relaxation ? 0.0 : state.time + 0.5 * dt;
}

Vector2 full_load(const Problem& problem, const State& state, const Boundary& boundary)
{
    Vector2 force = Vector2::Zero();
    if (!boundary.load) return force;
    ParticlePlaces places;
    for (const BoundaryPiece& piece : boundary.pieces) {
        const std::size_t p = places.find(state.particles, piece.identifier);
        force += full_force(*boundary.load, piece, present_piece(problem, state.particles, piece, p));
    }
    return force;
}

std::vector<BoundaryForce> total_load(const Problem& problem, const State& state, double time)
{
    std::vector<BoundaryForce> forces;
    for (const Boundary& boundary : problem.boundaries) {
        if (!boundary.load) continue;
        const double factor = history_value(boundary.load->history, time);
        forces.push_back({boundary.name, factor * full_load(problem, state, boundary)});
    }
    return forces;
}

} // namespace quicksand
