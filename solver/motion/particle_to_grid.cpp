#include "solver/motion/particle_to_grid.hpp"

#include "solver/base/failure.hpp"
#include "solver/base/lanes.hpp"
#include "solver/interpolation/cpdi.hpp"
#include "solver/interpolation/cpdi2.hpp"
#include "solver/interpolation/gimp.hpp"
#include "solver/interpolation/linear_interpolation.hpp"
#include "solver/interpolation/stencil_walk.hpp"
#include "solver/problem/buoyancy.hpp"
#include "solver/problem/problem.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// What a particle carries to its nodes: linear about the particle.
struct CarriedField {
    Lanes at_particle;
    Lanes slope_x, slope_y; // d/dx and d/dy of it
};

/// What a particle gives to its nodes: with weight phi and offset d from the particle, node sums grow by
///   phi amounts,  phi (momentum + its derivatives times d),  grad_x flow_x + grad_y flow_y
/// for the masses, momenta and forces in the order of TwoPhaseSums.
struct TwoPhaseContribution {
    Lanes amounts;         // m_s, m_w, V_w of saturated soil, C V_w
    CarriedField momentum; // m_s v_s and m_w v_w
    Lanes flow_x, flow_y;  // -V sigma' of the grains and V p, columns x and y
};

inline TwoPhaseContribution contribution_of(const Problem& problem, const Particles& particles, std::size_t p)
{
    const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
    const Gradients &Cs = particles.affine_velocity_solid, &Cw = particles.affine_velocity_fluid;
    const double V = particles.volume[p], n = particles.porosity[p];
    const double V_w = material.saturated ? V : 0.0;
    const double m_s = particles.mass_solid[p], m_w = n * problem.water->density * V_w;
    const double drag = // solids seal instead, see solid_seals.hpp
        material.has_pores ? V_w * drag_coefficient(material, *problem.water, particles, p) : 0.0;
    const double xx = particles.stress.xx[p], yy = particles.stress.yy[p], xy = particles.stress.xy[p];
    const double pressure = particles.pore_pressure[p];
    const Lanes masses = {m_s, m_s, m_w, m_w};
    TwoPhaseContribution contribution;
    contribution.amounts = Lanes{m_s, m_w, V_w, drag};
    contribution.momentum.at_particle =
        masses * Lanes{particles.velocity_solid.x[p], particles.velocity_solid.y[p],
                       particles.velocity_fluid.x[p], particles.velocity_fluid.y[p]};
    contribution.momentum.slope_x = masses * Lanes{Cs.xx[p], Cs.yx[p], Cw.xx[p], Cw.yx[p]};
    contribution.momentum.slope_y = masses * Lanes{Cs.xy[p], Cs.yy[p], Cw.xy[p], Cw.yy[p]};
    const Lanes volumes = {-V, -V, V, V};
    contribution.flow_x = volumes * Lanes{xx, xy, pressure, 0.0};
    contribution.flow_y = volumes * Lanes{xy, yy, 0.0, pressure};
    return contribution;
}

inline void add_to(double* target, const Lanes& increment)
{
    store_lanes(load_lanes(target) + increment, target);
}

/// Rows of the grid's nodes.
struct NodeRows {
    double rim_x, rim_y; // corner of its lower left node [m]
    double h;            // between nodes [m]
    std::int32_t nodes_x;
};

inline NodeRows rows_of(const BackgroundGrid& grid)
{
    const Vector2 rim = grid.rim_origin();
    return {rim.x(), rim.y(), grid.cell_size, grid.nodes_x()};
}

/// Call add(node, phi, d phi/dx, d phi/dy, the field at the node) for the nodes of the stencil of a particle
/// at (x, y).
template <class Node, class Add>
inline void carry_to_nodes(const CarriedField& field, double x, double y, const NodeRows& rows,
                           const StoredStencil& stencil, const StencilStore& store, Node* nodes, Add&& add)
{
    const double h = rows.h;
    const Lanes node_step = h * field.slope_x, row_step = h * field.slope_y; // from one to the next
    const double dx = rows.rim_x + stencil.column * h - x, dy = rows.rim_y + stencil.row * h - y;
    Lanes at_row = field.at_particle + dx * field.slope_x + dy * field.slope_y; // at its first node
    Lanes at_node;
    walk_stencil(
        stencil, store, rows.nodes_x, nodes,
        [&] {
            at_node = at_row;
            at_row += row_step;
        },
        [&](Node& node, double phi, double grad_x, double grad_y) {
            add(node, phi, grad_x, grad_y, at_node);
            at_node += node_step;
        },
        [] {});
}

template <NodeInterpolation Member>
std::int64_t evaluate_tile(const BackgroundGrid& grid, const Particles& particles, const CellLists& lists,
                           const Tile& tile, StencilStore& store)
{
    store.clear_for(lists.last_entry(tile) - lists.first_entry(tile));
    std::int64_t limited = 0;
    NodeStencil stencil;
    const std::size_t first = lists.first_entry(tile);
    for (std::size_t k = first; k < lists.last_entry(tile); ++k) {
        limited += Member::evaluate(grid, particles, static_cast<std::size_t>(lists.order[k]), stencil);
        store.put(k - first, stencil);
    }
    return limited;
}

/// What a particle of a body that moves as one gives to its nodes, as TwoPhaseContribution: lanes mass,
/// weight and momentum, and the force's flows -V sigma.
struct SinglePhaseContribution {
    CarriedField carried;
    double flow_xx, flow_yy, flow_xy; // [N m/m]
};

/// `pressure` acts besides the effective stress [Pa].
inline SinglePhaseContribution contribution_of(const Particles& particles, const CarriedMasses& masses,
                                               std::size_t p, double pressure)
{
    const Gradients& C = particles.affine_velocity_solid;
    const double V = particles.volume[p], m = masses.inertia[p];
    SinglePhaseContribution contribution;
    contribution.carried.at_particle =
        Lanes{m, masses.weight[p], m * particles.velocity_solid.x[p], m * particles.velocity_solid.y[p]};
    contribution.carried.slope_x = Lanes{0.0, 0.0, m * C.xx[p], m * C.yx[p]};
    contribution.carried.slope_y = Lanes{0.0, 0.0, m * C.xy[p], m * C.yy[p]};
    contribution.flow_xx = -V * (particles.stress.xx[p] - pressure);
    contribution.flow_yy = -V * (particles.stress.yy[p] - pressure);
    contribution.flow_xy = -V * particles.stress.xy[p];
    return contribution;
}

/// `pressure(p)` acts besides the effective stress [Pa].
template <class Pressure>
inline void scatter_one_velocity(const Problem& problem, const Particles& particles,
                                 const CarriedMasses& masses, const CellLists& lists, const Tile& tile,
                                 const StencilStore& store, std::vector<SinglePhaseSums>& sums,
                                 Pressure&& pressure)
{
    const Vectors& place = place_in_equations(problem, particles);
    const NodeRows rows = rows_of(problem.grid);
    const StoredStencil* stencil = store.stencils.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++stencil) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const SinglePhaseContribution contribution = contribution_of(particles, masses, p, pressure(p));
        carry_to_nodes(
            contribution.carried, place.x[p], place.y[p], rows, *stencil, store, sums.data(),
            [&](SinglePhaseSums& node, double phi, double grad_x, double grad_y, const Lanes& carried) {
                add_to(&node.mass, phi * carried);
                node.stress_force_x += contribution.flow_xx * grad_x + contribution.flow_xy * grad_y;
                node.stress_force_y += contribution.flow_xy * grad_x + contribution.flow_yy * grad_y;
            });
    }
}

} // namespace

void compute_carried_masses(const Problem& problem, const State& state, CarriedMasses& masses)
{
    const Particles& particles = state.particles;
    masses.inertia = particles.mass_solid;
    masses.weight = particles.mass_solid;
    if (!problem.water) return;
    const bool kept = state.stage == Stage::shaking && problem.water->flow == WaterFlow::undrained;
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p) {
            if (!problem.materials[static_cast<std::size_t>(particles.material[p])].saturated) continue;
            const double V = particles.volume[p];
            const double water = kept ? particles.water_volume[p] : particles.porosity[p] * V;
            masses.inertia[p] += problem.water->density * water;
            masses.weight[p] = masses.inertia[p];
            masses.weight[p] -= submerged_part(problem, particles, p) * problem.water->density * V;
        }
    });
}

std::int64_t evaluate_weights(const Problem& problem, const Particles& particles, const CellLists& lists,
                              const Tile& tile, StencilStore& store)
{
    const BackgroundGrid& grid = problem.grid;
    switch (problem.interpolation) {
    case Interpolation::linear:
        return evaluate_tile<LinearInterpolation>(grid, particles, lists, tile, store);
    case Interpolation::gimp:
        return evaluate_tile<UniformGimp>(grid, particles, lists, tile, store);
    case Interpolation::cpgimp:
        return evaluate_tile<ContiguousGimp>(grid, particles, lists, tile, store);
    case Interpolation::cpdi: {
        const std::int64_t limited = weigh_parallelograms(grid, particles, lists, tile, store);
        if (problem.cut_domains.shapes.empty()) return limited;
        return limited + weigh_cut_domains(problem.grid, problem.cut_domains, particles, lists, tile, store);
    }
    case Interpolation::cpdi2:
        return evaluate_tile<Cpdi2>(grid, particles, lists, tile, store);
    }
    ENSURE(false);
}

VECTOR_KERNEL
void scatter_two_phase(const Problem& problem, const Particles& particles, const CellLists& lists,
                       const Tile& tile, const StencilStore& store, std::vector<TwoPhaseSums>& sums)
{
    const Vectors& place = place_in_equations(problem, particles);
    const NodeRows rows = rows_of(problem.grid);
    const StoredStencil* stencil = store.stencils.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++stencil) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const TwoPhaseContribution contribution = contribution_of(problem, particles, p);
        carry_to_nodes(
            contribution.momentum, place.x[p], place.y[p], rows, *stencil, store, sums.data(),
            [&](TwoPhaseSums& node, double phi, double grad_x, double grad_y, const Lanes& momentum) {
                add_to(&node.mass_solid, phi * contribution.amounts);
                add_to(&node.momentum_solid_x, phi * momentum);
                add_to(&node.stress_force_x, grad_x * contribution.flow_x + grad_y * contribution.flow_y);
            });
    }
}

VECTOR_KERNEL
void scatter_single_phase(const Problem& problem, const Particles& particles, const CarriedMasses& masses,
                          const CellLists& lists, const Tile& tile, const StencilStore& store,
                          std::vector<SinglePhaseSums>& sums)
{
    scatter_one_velocity(problem, particles, masses, lists, tile, store, sums,
                         [](std::size_t) { return 0.0; });
}

VECTOR_KERNEL
void scatter_total_stress(const Problem& problem, const Particles& particles, const CarriedMasses& masses,
                          const CellLists& lists, const Tile& tile, const StencilStore& store,
                          std::vector<SinglePhaseSums>& sums)
{
    scatter_one_velocity(problem, particles, masses, lists, tile, store, sums,
                         [&](std::size_t p) { return particles.pore_pressure[p]; });
}

void scatter_risen_water(const Problem& problem, const Particles& particles, const CellLists& lists,
                         const Tile& tile, const StencilStore& store, std::vector<TwoPhaseSums>& sums,
                         std::vector<OuterForce>& outer)
{
    const StoredStencil* stencil = store.stencils.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++stencil) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
        const double risen = material.saturated ? 1.0 - submerged_part(problem, particles, p) : 0.0;
        if (risen == 0.0) continue;
        const double lift = risen * problem.water->density * problem.gravity * particles.volume[p];
        for_each_node(*stencil, store, problem.grid.nodes_x(), [&](std::size_t i, const NodeWeight& w) {
            sums[i].pressure_force_y -= w.value * lift;
            outer[i].risen_weight += w.value * lift;
        });
    }
}

bool has_pressure(const Particles& particles)
{
    return std::any_of(particles.pore_pressure.begin(), particles.pore_pressure.end(),
                       [](double pressure) { return pressure != 0.0; });
}

void scatter_body_force(const Problem& problem, double time, const Particles& particles,
                        const CarriedMasses& masses, const CellLists& lists, const Tile& tile,
                        const StencilStore& store, std::vector<SinglePhaseSums>& sums)
{
    const StoredStencil* stencil = store.stencils.data();
    for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k, ++stencil) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const Vector2 force =
            masses.inertia[p] * problem.body_acceleration(particles.reference_position[p], time);
        for_each_node(*stencil, store, problem.grid.nodes_x(), [&](std::size_t i, const NodeWeight& w) {
            sums[i].stress_force_x += w.value * force.x();
            sums[i].stress_force_y += w.value * force.y();
        });
    }
}

} // namespace quicksand
