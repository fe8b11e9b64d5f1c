#include "solver/run/patch_test.hpp"

#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/wall_nodes.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/walls/wall_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace quicksand {

namespace {

/// A pressure by place [Pa].
using PressureField = std::function<double(const Vector2&)>;

bool is_free(const Boundary& boundary)
{
    return std::holds_alternative<FreeFace>(boundary.soil);
}

/// The problem with pieces on every curve that is no wall and where soil ends, dry, of the density 1 and
/// without loads of its own.
Problem bare_problem(const Problem& problem, const Particles& particles)
{
    Problem bare = problem;
    bare.water.reset();
    bare.body_acceleration = {};
    for (Material& material : bare.materials) material.grain_density = 1.0 / (1.0 - material.porosity);
    Boundary rest;
    rest.segments = unnamed_edges(problem);
    if (!rest.segments.empty()) bare.boundaries.push_back(rest);
    for (Boundary& boundary : bare.boundaries) {
        boundary.water = Drained{};
        if (!is_free(boundary)) continue;
        boundary.soil = FreeFace{SurfaceLoad{}};
        std::erase_if(boundary.segments, [&](const Segment& part) { return !lies_on_rim(problem, part); });
    }
    attach_boundaries(bare, particles);
    return bare;
}

/// Particles at rest under the pressure, of the density 1 where they have weight.
State state_under(const PressureField& pressure, const State& state)
{
    State pressed = state;
    pressed.stage = Stage::relaxation;
    pressed.reactions = {};
    pressed.balance_terms.reset();
    Particles& particles = pressed.particles;
    for_each_array(particles, [](std::string_view name, Scalars& values) {
        if (name.find("velocity") != name.npos || name.starts_with("pore_pressure"))
            std::fill(values.begin(), values.end(), 0.0);
    });
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double stress = -pressure(particles.position[p]);
        particles.stress.xx[p] = particles.stress.yy[p] = stress;
        particles.stress.xy[p] = 0.0;
        particles.mass_solid[p] = particles.volume[p];
    }
    return pressed;
}

void add_outer_pressure(const Problem& problem, const PressureField& pressure, const Particles& particles,
                        SinglePhaseWorkspace& work)
{
    ParticlePlaces places;
    for (const Boundary& boundary : problem.boundaries) {
        if (!is_free(boundary)) continue;
        for (const BoundaryPiece& piece : boundary.pieces) {
            const std::size_t p = places.find(particles, piece.identifier);
            const PresentPiece present = present_piece(problem, particles, piece, p);
            const Vector2 force = -pressure(present.middle()) * present.outward();
            for_each_loaded_node(problem.grid, present, [&](std::size_t i, double fraction) {
                SinglePhaseSums& node = work.sums[work.conditions.master[i]];
                node.stress_force_x += fraction * force.x();
                node.stress_force_y += fraction * force.y();
            });
        }
    }
}

/// The size of the force that each node leaves unbalanced [N/m].
Scalars unbalanced_by_node(const Problem& bare, const PressureField& pressure, const State& state)
{
    State pressed = state_under(pressure, state);
    SinglePhaseWorkspace work = make_single_phase_workspace(bare, Stage::relaxation);
    locate_particles(bare, 0.0, pressed, work);
    scatter_to_nodes(bare, 0.0, pressed, work);
    add_outer_pressure(bare, pressure, pressed.particles, work);
    constexpr double unit_time = 1.0; // forces stand for impulses
    assemble_walls(bare, unit_time, work.sums, work);
    leave_unbalanced_forces(bare, 0.0, work.walls, work.sums);
    Scalars residual(work.sums.size(), 0.0);
    for (std::size_t i = 0; i < residual.size(); ++i) {
        const SinglePhaseSums& node = work.sums[i];
        if (!node.active() || work.conditions.master[i] != i) continue;
        const std::uint8_t held = work.conditions.of_node[i];
        const double x = held & solid_x_fixed ? 0.0 : node.stress_force_x;
        const double y = held & solid_y_fixed ? 0.0 : node.stress_force_y - node.weight * bare.gravity;
        residual[i] = std::hypot(x, y);
    }
    return residual;
}

/// Residual at the nodes along each boundary, over its length.
Scalars along_boundaries(const Problem& bare, const Scalars& residual)
{
    Scalars all(residual.size(), 0.0); // length of all curves under each node's function [m]
    const auto visit = [&](const Boundary& boundary, auto&& add) {
        for (const Segment& segment : boundary.segments)
            for (const NodeLength& part : lengths_along(bare.grid, segment)) add(part);
    };
    for (const Boundary& boundary : bare.boundaries)
        visit(boundary, [&](const NodeLength& part) { all[part.node] += part.length; });
    Scalars result;
    for (const Boundary& boundary : bare.boundaries) {
        double sum = 0.0, length = 0.0;
        visit(boundary, [&](const NodeLength& part) {
            length += part.length;
            if (part.length > 0.0) sum += residual[part.node] * part.length / all[part.node];
        });
        result.push_back(length > 0.0 ? sum / length : 0.0);
    }
    return result;
}

} // namespace

std::vector<PatchTest> test_patches(const Problem& problem, const State& state)
{
    Problem bare = bare_problem(problem, state.particles);
    const Scalars& y = state.particles.position.y;
    const auto [lowest, highest] = std::minmax_element(y.begin(), y.end());
    const double top = *highest + bare.grid.cell_size, height = top - *lowest;

    bare.gravity = 0.0;
    const Scalars constant = along_boundaries(bare, unbalanced_by_node(
                                                        bare, [](const Vector2&) { return 1.0; }, state));
    bare.gravity = 1.0;
    const Scalars geostatic =
        along_boundaries(bare, unbalanced_by_node(
                                   bare, [&](const Vector2& x) { return top - x.y(); }, state));
    std::vector<PatchTest> tests;
    for (std::size_t b = 0; b < bare.boundaries.size(); ++b)
        tests.push_back({bare.boundaries[b].name, constant[b], geostatic[b] / height});
    return tests;
}

} // namespace quicksand
