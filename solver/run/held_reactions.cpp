// The forces that held a curve at rest until it lets go, as forces on its pieces. What these cannot carry
// where the curve cuts cells goes to points of the domains near it, the holders, whose L_k is 1.
#include "solver/run/held_reactions.hpp"

#include "solver/boundaries/free_field.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "solver/boundaries/wall_nodes.hpp"
#include "solver/step/free_field_rows.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/walls/piece_forces.hpp"

#include <algorithm>
#include <utility>

namespace quicksand {

namespace {

std::vector<PieceWeights> weights_of_pieces(const Problem& problem, const State& state,
                                            const NodeConditions& conditions)
{
    std::vector<PieceWeights> all;
    ParticlePlaces places;
    const Boundary* curve = nullptr; // whose pieces come one after the other
    bool on_line = false;
    for_each_held_piece(problem, [&](const Boundary& boundary, const BoundaryPiece& piece) {
        if (&boundary != curve)
            on_line =
                std::all_of(boundary.segments.begin(), boundary.segments.end(),
                            [&](const Segment& segment) { return holds_nodes(problem, boundary, segment); });
        curve = &boundary;
        const std::size_t p = places.find(state.particles, piece.identifier);
        PieceWeights weights{piece.length, on_line, {}};
        for_each_loaded_node(problem.grid, present_piece(problem, state.particles, piece, p),
                             [&](std::size_t i, double fraction) {
                                 if (fraction != 0.0)
                                     weights.fractions.emplace_back(conditions.master[i], fraction);
                             });
        all.push_back(std::move(weights));
    });
    return all;
}

/// What the pieces cannot carry, carried by the holders, so that every node near the curve is in balance
/// which nothing else holds.
Scalars spread_on_holders(std::vector<PieceWeights> pieces, const std::vector<SinglePhaseSums>& nodes,
                          const NodeConditions& free, std::uint8_t fixed, Scalars wanted,
                          const Scalars& of_pieces)
{
    constexpr double negligible = 1e-9; // of the largest reaction
    std::vector<std::uint8_t> near(nodes.size(), 0);
    for (const PieceWeights& piece : pieces)
        for (const auto& [node, fraction] : piece.fractions)
            if (nodes[node].active() && (free.of_node[node] & fixed) == 0) near[node] = 1;
    const Scalars carried = sums_at_nodes(pieces, near, of_pieces);
    double largest = 0.0, left = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        largest = std::max(largest, std::abs(wanted[i]));
        wanted[i] = near[i] ? wanted[i] - carried[i] : 0.0;
        left = std::max(left, std::abs(wanted[i]));
    }
    if (left <= negligible * largest) return Scalars(pieces.size(), 0.0);
    for (PieceWeights& piece : pieces) piece.length = piece.length == 0.0 ? 1.0 : 0.0; // holders alone
    return spread_on_pieces(pieces, near, wanted);
}

/// Where a side that slides meets a base that does not, a node of the side has no reaction along it: the
/// pieces beside the corner may not put what the base bears on it.
void add_free_nodes(const std::vector<PieceWeights>& pieces, const std::vector<SinglePhaseSums>& nodes,
                    const NodeConditions& free, std::uint8_t fixed, std::vector<std::uint8_t>& released)
{
    for (const PieceWeights& piece : pieces) {
        if (!piece.on_line) continue;
        for (const auto& [node, fraction] : piece.fractions)
            if (nodes[node].active() && (free.of_node[node] & fixed) == 0) released[node] = 1;
    }
}

/// The nodes of the state at rest, with all forces, the pressure of the water included, and the rows of the
/// walls; `held` becomes the state in the order of the workspace.
SinglePhaseWorkspace nodes_at_rest(const Problem& problem, const State& state, State& held)
{
    held = state;
    held.stage = Stage::relaxation;
    held.reactions = {};
    SinglePhaseWorkspace work = make_single_phase_workspace(problem, Stage::relaxation);
    locate_particles(problem, 0.0, held, work);
    scatter_to_nodes(problem, 0.0, held, work);
    constexpr double unit_time = 1.0; // forces stand for impulses
    assemble_walls(problem, unit_time, work.sums, work);
    return work;
}

/// The forces of the ground beyond free-field sides, at rest, at the nodes that carry them. Sets the rows of
/// the state's free fields.
std::vector<Vector2> resting_ground(const Problem& problem, const NodeConditions& conditions, State& state)
{
    std::vector<Vector2> forces(problem.grid.node_count(), Vector2::Zero());
    for (std::size_t k = 0; k < state.free_fields.size(); ++k) {
        const Problem& column = problem.free_fields[k].column;
        FreeFieldState& field = state.free_fields[k];
        hold_reactions(column, field.column);
        State held;
        const SinglePhaseWorkspace rest = nodes_at_rest(column, field.column, held);
        const SectionStress stress = section_stress(column, held.particles);
        find_section_forces(
            column, rest, held.particles, stress, [](std::size_t) { return 0.0; }, field.rows);
        field.rows.velocity.x.assign(field.rows.height.size(), 0.0);
        field.rows.velocity.y.assign(field.rows.height.size(), 0.0);
    }
    ParticlePlaces places;
    std::vector<NodalForce> ground;
    add_free_fields(problem, state, places, ground);
    for (const NodalForce& force : ground)
        forces[conditions.master[force.node]] += force.grains + force.mixture;
    return forces;
}

/// The nodes that a curve has held in a direction and lets go, and the forces that it had on them [N/m].
struct ReleasedNodes {
    std::vector<std::uint8_t> released;
    Scalars wanted;
};

/// Those that conditions of their own have held, which took all that was left of the other forces.
ReleasedNodes released_by_nodes(const Problem& problem, const SinglePhaseWorkspace& rest,
                                const std::vector<Vector2>& ground, const NodeConditions& held,
                                const NodeConditions& free, const FollowingNodes& following,
                                std::uint8_t fixed)
{
    const std::vector<SinglePhaseSums>& nodes = rest.sums;
    Scalars forces(nodes.size(), 0.0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].active()) continue;
        forces[i] = fixed == solid_x_fixed
                        ? nodes[i].stress_force_x + ground[i].x()
                        : nodes[i].stress_force_y + ground[i].y() - nodes[i].weight * problem.gravity;
    }
    following.pass_on(forces);
    ReleasedNodes all{std::vector<std::uint8_t>(nodes.size(), 0), Scalars(nodes.size(), 0.0)};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].active() || held.master[i] != i || following.contains(i)) continue;
        all.released[i] = (held.of_node[i] & ~free.of_node[i] & fixed) != 0;
        if (all.released[i]) all.wanted[i] = -forces[i];
    }
    return all;
}

/// The forces at rest of the rows of curves that let go, and of those that stay, on the nodes of the rows
/// [N/m].
struct RowForces {
    std::vector<Vector2> gone, staying;
};

RowForces forces_of_rows(const Problem& problem, const SinglePhaseWorkspace& rest)
{
    const auto of_chains = [&](bool letting_go) {
        return resting_reactions(problem, rest.walls, rest.sums, [&](const WallChain& chain) {
            return lets_go(problem.boundaries[chain.edges.front().boundary].soil) == letting_go;
        });
    };
    return {of_chains(true), of_chains(false)};
}

/// Add those that rows of curves have held which let go. Rows of the walls that stay go on taking their part
/// at nodes that conditions had held.
void add_released_by_rows(const RowForces& rows, const std::vector<std::size_t>& nodes_of_rows,
                          const NodeConditions& held, const FollowingNodes& following, std::uint8_t fixed,
                          ReleasedNodes& nodes)
{
    const Eigen::Index axis = fixed == solid_x_fixed ? 0 : 1;
    const std::size_t count = nodes.wanted.size();
    Scalars gone(count, 0.0), staying(count, 0.0), touched(count, 0.0);
    for (std::size_t k = 0; k < rows.gone.size(); ++k) {
        const std::size_t i = nodes_of_rows[k];
        gone[i] = rows.gone[k][axis];
        staying[i] = rows.staying[k][axis];
        touched[i] = rows.gone[k].norm();
    }
    for (Scalars* forces : {&gone, &staying, &touched}) following.pass_on(*forces);
    for (std::size_t i = 0; i < count; ++i) {
        if (held.of_node[i] & fixed) {
            if (nodes.released[i]) nodes.wanted[i] -= staying[i];
        } else if (touched[i] != 0.0) {
            nodes.released[i] = 1;
            nodes.wanted[i] += gone[i];
        }
    }
}

} // namespace

void hold_reactions(const Problem& problem, State& state)
{
    state.reactions = {};
    const auto releases = [](const Boundary& boundary) { return lets_go(boundary.soil); };
    if (std::none_of(problem.boundaries.begin(), problem.boundaries.end(), releases)) return;
    const NodeConditions held = node_conditions(problem, Stage::relaxation),
                         free = node_conditions(problem, Stage::shaking);
    const std::vector<PieceWeights> all_pieces = weights_of_pieces(problem, state, held);
    State at_rest;
    const SinglePhaseWorkspace rest = nodes_at_rest(problem, state, at_rest);
    const std::vector<Vector2> ground = resting_ground(problem, held, state);
    const RowForces rows = forces_of_rows(problem, rest);
    for (const std::uint8_t fixed : {std::uint8_t{solid_x_fixed}, std::uint8_t{solid_y_fixed}}) {
        const FollowingNodes following(rest.walls.rows, fixed == solid_x_fixed ? 0 : 1);
        const std::vector<PieceWeights> pieces = following.passed_on(all_pieces);
        ReleasedNodes nodes = released_by_nodes(problem, rest, ground, held, free, following, fixed);
        add_released_by_rows(rows, rest.walls.rows.nodes(), held, following, fixed, nodes);
        add_free_nodes(pieces, rest.sums, free, fixed, nodes.released);
        Scalars forces = spread_on_pieces(pieces, nodes.released, nodes.wanted);
        const Scalars by_holders = spread_on_holders(pieces, rest.sums, free, fixed, nodes.wanted, forces);
        for (std::size_t k = 0; k < forces.size(); ++k) forces[k] += by_holders[k];
        (fixed == solid_x_fixed ? state.reactions.x : state.reactions.y) = std::move(forces);
    }
}

} // namespace quicksand
