#include "solver/boundaries/outer_forces.hpp"

#include "solver/boundaries/free_field.hpp"
#include "solver/boundaries/surface_loads.hpp"
#include "solver/boundaries/viscous_boundary.hpp"

#include <algorithm>

namespace quicksand {

bool has_outer_forces(const Problem& problem)
{
    return std::any_of(problem.boundaries.begin(), problem.boundaries.end(), acts_on_soil);
}

void gather_outer_forces(const Problem& problem, double time, const State& state, ParticlePlaces& places,
                         std::vector<NodalForce>& forces)
{
    forces.clear();
    add_surface_loads(problem, time, state.particles, places, forces);
    add_outer_water(problem, time, state.particles, places, forces);
    add_held_reactions(problem, state, places, forces);
    if (state.stage == Stage::shaking) add_free_fields(problem, state, places, forces);
}

void add_outer_forces(const std::vector<NodalForce>& forces, std::vector<TwoPhaseSums>& sums)
{
    for (const NodalForce& force : forces) {
        sums[force.node].stress_force_x += force.grains.x();
        sums[force.node].stress_force_y += force.grains.y();
        sums[force.node].pressure_force_x += force.mixture.x();
        sums[force.node].pressure_force_y += force.mixture.y();
    }
}

void add_outer_forces(const std::vector<NodalForce>& forces, std::vector<SinglePhaseSums>& sums)
{
    for (const NodalForce& force : forces) {
        sums[force.node].stress_force_x += force.grains.x() + force.mixture.x();
        sums[force.node].stress_force_y += force.grains.y() + force.mixture.y();
    }
}

void note_outer_forces(const std::vector<NodalForce>& forces, std::vector<OuterForce>& outer)
{
    for (const NodalForce& force : forces) {
        outer[force.node].load_x += force.grains.x();
        outer[force.node].load_y += force.grains.y();
        outer[force.node].water_x += force.mixture.x();
        outer[force.node].water_y += force.mixture.y();
    }
}

} // namespace quicksand
