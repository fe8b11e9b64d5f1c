#include "solver/boundaries/free_field.hpp"

#include "solver/boundaries/viscous_boundary.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// What the nodes carry of the sides along one free field.
struct SideNodes {
    std::vector<NodalForce> dashpots;                    // their part with the velocity of the ground [N/m]
    std::vector<std::pair<std::size_t, double>> lengths; // of the side, node by node [m]
    Scalars row_lengths;                                 // the same by rows of nodes [m]
};

std::size_t row_of(const BackgroundGrid& grid, std::size_t node)
{
    return node / static_cast<std::size_t>(grid.nodes_x());
}

/// Add the pieces of a boundary that lie on the side of a free field.
void add_side(const Problem& problem, const State& state, const Boundary& boundary, std::size_t field,
              ParticlePlaces& places, SideNodes& side)
{
    const FreeFieldRows& rows = state.free_fields[field].rows;
    const Particles& particles = state.particles;
    for (const BoundaryPiece& piece : boundary.pieces) {
        const std::size_t p = places.find(particles, piece.identifier);
        const PresentPiece present = present_piece(problem, particles, piece, p);
        if (free_field_beyond(problem, {present.start, present.end}) != field) continue;
        const Dashpot whole = dashpot_of(problem, boundary, {piece, present, particles, p});
        const double height = std::abs(present.end.y() - present.start.y());
        for_each_loaded_node(problem.grid, braking_piece(present), [&](std::size_t i, double fraction) {
            if (fraction == 0.0) return;
            const std::size_t row = row_of(problem.grid, i);
            const Vector2 v = rows.velocity[row];
            const Vector2 drive(whole.xx * v.x() + whole.xy * v.y(), whole.xy * v.x() + whole.yy * v.y());
            if (absorbs_waves(boundary.soil)) side.dashpots.push_back({i, fraction * drive, Vector2::Zero()});
            side.lengths.emplace_back(i, fraction * height);
            side.row_lengths[row] += fraction * height;
        });
    }
}

void add_forces(const BackgroundGrid& grid, double outward, const FreeFieldRows& rows, const SideNodes& side,
                std::vector<NodalForce>& forces)
{
    forces.insert(forces.end(), side.dashpots.begin(), side.dashpots.end());
    for (const auto& [node, length] : side.lengths) {
        const std::size_t row = row_of(grid, node);
        // where the body is lower than the ground, the part of the force on its height
        const double share = length / std::max(side.row_lengths[row], rows.height[row]);
        const Vector2 force = rows.force[row];
        forces.push_back({node, outward * share * force, {-outward * share * rows.pressure[row], 0.0}});
    }
}

} // namespace

std::optional<std::size_t> free_field_beyond(const Problem& problem, const Segment& part)
{
    std::optional<std::size_t> nearest;
    const double x = 0.5 * (part.start.x() + part.end.x());
    const auto distance = [&](std::size_t k) { return std::abs(problem.free_fields[k].x - x); };
    for (std::size_t k = 0; k < problem.free_fields.size(); ++k)
        if (!nearest || distance(k) < distance(*nearest)) nearest = k;
    return nearest;
}

void add_free_fields(const Problem& problem, const State& state, ParticlePlaces& places,
                     std::vector<NodalForce>& forces)
{
    for (std::size_t k = 0; k < state.free_fields.size(); ++k) {
        SideNodes side;
        side.row_lengths.assign(static_cast<std::size_t>(problem.grid.nodes_y()), 0.0);
        for (const Boundary& boundary : problem.boundaries)
            if (std::holds_alternative<FreeFieldSide>(boundary.soil))
                add_side(problem, state, boundary, k, places, side);
        add_forces(problem.grid, problem.free_fields[k].outward, state.free_fields[k].rows, side, forces);
    }
}

} // namespace quicksand
