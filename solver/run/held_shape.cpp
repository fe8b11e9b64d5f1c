#include "solver/run/held_shape.hpp"

#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/outer_forces.hpp"
#include "solver/boundaries/surface_loads.hpp"
#include "solver/cell_strain/cell_stress.hpp"
#include "solver/motion/particle_order.hpp"
#include "solver/motion/particle_to_grid.hpp"
#include "solver/run/unbalanced_forces.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// Call visit(particle, stencil, store) for the particles of a tile.
template <class Visit>
void for_each_particle(const HeldShape& shape, const Tile& tile, Visit&& visit)
{
    const StencilStore& store = shape.stencils[static_cast<std::size_t>(tile.number)];
    const StoredStencil* stencil = store.stencils.data();
    for (std::size_t k = shape.lists.first_entry(tile); k < shape.lists.last_entry(tile); ++k, ++stencil)
        visit(static_cast<std::size_t>(shape.lists.order[k]), *stencil, store);
}

void scatter_forces(const Problem& problem, const Particles& particles, const Tile& tile, HeldShape& shape)
{
    for_each_particle(
        shape, tile, [&](std::size_t p, const StoredStencil& stencil, const StencilStore& store) {
            const double V = particles.volume[p];
            const double pressure = excess_pore_pressure(particles, p);
            const double sxx = V * (particles.stress.xx[p] - pressure),
                         syy = V * (particles.stress.yy[p] - pressure), sxy = V * particles.stress.xy[p];
            for_each_node(stencil, store, problem.grid.nodes_x(), [&](std::size_t i, const NodeWeight& w) {
                shape.sums[i].stress_force_x -= sxx * w.gradient_x + sxy * w.gradient_y;
                shape.sums[i].stress_force_y -= sxy * w.gradient_x + syy * w.gradient_y;
            });
        });
}

void gather_gradients(const Problem& problem, const HeldShape& shape, const Tile& tile, Particles& particles)
{
    Gradients& L = particles.velocity_gradient_solid;
    for_each_particle(
        shape, tile, [&](std::size_t p, const StoredStencil& stencil, const StencilStore& store) {
            double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;
            for_each_node(stencil, store, problem.grid.nodes_x(), [&](std::size_t i, const NodeWeight& w) {
                const SinglePhaseMotion& node = shape.motion[i];
                xx += w.gradient_x * node.x;
                xy += w.gradient_y * node.x;
                yx += w.gradient_x * node.y;
                yy += w.gradient_y * node.y;
            });
            L.xx[p] = xx;
            L.xy[p] = xy;
            L.yx[p] = yx;
            L.yy[p] = yy;
        });
}

/// The rows of the walls; masses do not change, so that they hold for all steps.
void hold_walls_of(const Problem& problem, const State& state, HeldShape& shape)
{
    if (!shape.walls.any) return;
    find_roots(problem, shape.conditions, shape.lists, state.particles, {}, shape.walls.roots);
    aggregate_cells(shape.lists, shape.walls.roots.aggregated, shape.aggregated_lists);
    State resting = state;
    resting.stage = Stage::relaxation;
    place_wall_rows(problem, 0.0, resting, shape.conditions, shape.lists, shape.stencils, shape.walls);
    std::vector<SinglePhaseSums> gathered = shape.rest;
    gather_tied_sums(shape.conditions, gathered);
    constexpr double unit_time = 1.0; // of a body of one phase nothing depends on it
    assemble_wall_rows(problem, shape.conditions, unit_time, {}, gathered, shape.walls);
}

} // namespace

HeldShape hold_shape(const Problem& moving, State& state)
{
    Problem problem = moving;
    problem.grid.line_tolerance = BackgroundGrid::line_tolerance_of_still_shapes;
    HeldShape shape;
    shape.lists = make_cell_lists(problem.grid);
    shape.conditions = node_conditions(problem, Stage::relaxation);
    set_up_wall_rows(problem, Stage::relaxation, shape.walls);
    shape.stencils.resize(shape.lists.tiles.size());
    sort_particles(problem.grid, 0.0, state, shape.lists);
    CarriedMasses masses;
    compute_carried_masses(problem, state, masses);
    Particles resting = state.particles; // their momenta and forces are none of the shape's
    for_each_array(resting, [](std::string_view name, Scalars& values) {
        if (name.find("velocity") != name.npos || name.starts_with("stress"))
            std::fill(values.begin(), values.end(), 0.0);
    });
    shape.rest.assign(problem.grid.node_count(), SinglePhaseSums{});
    for_each_tile_by_colour(shape.lists, [&](const Tile& tile) {
        StencilStore& store = shape.stencils[static_cast<std::size_t>(tile.number)];
        evaluate_weights(problem, resting, shape.lists, tile, store);
        scatter_single_phase(problem, resting, masses, shape.lists, tile, store, shape.rest);
        if (!problem.body_acceleration) return;
        scatter_body_force(problem, state.time, resting, masses, shape.lists, tile, store, shape.rest);
    });
    ParticlePlaces places;
    std::vector<NodalForce> forces;
    add_surface_loads(problem, state.time, resting, places, forces);
    // without pore pressures the grains alone would carry the water beyond curves
    if (has_pressure(resting)) add_outer_water(problem, state.time, resting, places, forces);
    add_outer_forces(forces, shape.rest);
    shape.sums = shape.rest;
    hold_walls_of(problem, state, shape);
    shape.strain = make_cell_strain(problem, state.stage);
    shape.motion.resize(problem.grid.node_count());
    shape.displacement.x.resize(problem.grid.node_count());
    shape.displacement.y.resize(problem.grid.node_count());
    return shape;
}

void advance_held_shape(const Problem& problem, double dt, double damping, double acceleration,
                        Particles& particles, HeldShape& shape)
{
    for (std::size_t i = 0; i < shape.rest.size(); ++i) {
        shape.sums[i] = shape.rest[i];
        shape.sums[i].momentum_x = shape.rest[i].mass * shape.motion[i].x;
        shape.sums[i].momentum_y = shape.rest[i].mass * shape.motion[i].y;
    }
    const CellLists& volume_lists = shape.walls.any ? shape.aggregated_lists.lists : shape.lists;
    {
        const StressOnNodes stress(problem, volume_lists, shape.strain, particles);
        for_each_tile_by_colour(shape.lists,
                                [&](const Tile& tile) { scatter_forces(problem, particles, tile, shape); });
    }
    gather_tied_sums(shape.conditions, shape.sums);
    leave_unbalanced_forces(problem, acceleration, shape.walls, shape.sums);
    solve_single_phase_momentum(problem, shape.conditions, dt, acceleration, damping, shape.sums,
                                shape.motion);
    hold_at_walls(shape.walls, shape.motion);
    spread_tied_motion(shape.conditions, shape.motion);
    for (std::size_t i = 0; i < shape.motion.size(); ++i) {
        shape.displacement.x[i] += dt * shape.motion[i].x;
        shape.displacement.y[i] += dt * shape.motion[i].y;
    }
    for_each_tile(shape.lists, [&](const Tile& tile) { gather_gradients(problem, shape, tile, particles); });
    update_stress_of_cells(problem, dt, volume_lists, particles, shape.strain);
}

void set_at_rest(HeldShape& shape)
{
    std::fill(shape.motion.begin(), shape.motion.end(), SinglePhaseMotion{});
}

void reset_displacement(HeldShape& shape)
{
    std::fill(shape.displacement.x.begin(), shape.displacement.x.end(), 0.0);
    std::fill(shape.displacement.y.begin(), shape.displacement.y.end(), 0.0);
}

double out_of_balance(const Problem& problem, double acceleration, const HeldShape& shape)
{
    return unbalanced_forces(problem, acceleration, shape.conditions, shape.walls, shape.sums).of_weight;
}

double largest_displacement(const Problem& problem, const HeldShape& shape)
{
    double largest = 0.0;
    for (const Tile& tile : shape.lists.tiles) {
        for_each_particle(shape, tile,
                          [&](std::size_t, const StoredStencil& stencil, const StencilStore& store) {
                              Vector2 u = Vector2::Zero();
                              for_each_node(stencil, store, problem.grid.nodes_x(),
                                            [&](std::size_t i, const NodeWeight& w) {
                                                u += w.value * shape.displacement[i];
                                            });
                              largest = std::max(largest, u.norm());
                          });
    }
    return largest;
}

void displace(const Problem& problem, const HeldShape& shape, Particles& particles)
{
    for_each_tile(shape.lists, [&](const Tile& tile) {
        for_each_particle(
            shape, tile, [&](std::size_t p, const StoredStencil& stencil, const StencilStore& store) {
                Vector2 u = Vector2::Zero();
                Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
                for_each_node(
                    stencil, store, problem.grid.nodes_x(), [&](std::size_t i, const NodeWeight& w) {
                        u += w.value * shape.displacement[i];
                        gradient += shape.displacement[i] * Vector2(w.gradient_x, w.gradient_y).transpose();
                    });
                particles.position.set(p, particles.position[p] + u);
                for (Vectors* edge : {&particles.half_edge_1, &particles.half_edge_2})
                    edge->set(p, (*edge)[p] + gradient * (*edge)[p]);
            });
    });
}

} // namespace quicksand
