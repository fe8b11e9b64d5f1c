// The forces that held a curve at rest until it lets go, as forces on its pieces: F_k = L_k sum_i w_ki y_i
// with multipliers y of the nodes, such that sum_k w_ki F_k = R_i in the least squares, by conjugate
// gradients. The matrix is symmetric, that of a mass along the curve.
#include "solver/run/held_reactions.hpp"

#include "solver/boundaries/free_field.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "solver/boundaries/wall_nodes.hpp"
#include "solver/step/free_field_rows.hpp"
#include "solver/step/single_phase_step.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// Where the force of one piece goes, and its length.
struct PieceWeights {
    double length = 0.0;  // [m]
    bool on_line = false; // of the grid, with the whole curve
    std::vector<std::pair<std::size_t, double>> fractions;
};

std::vector<PieceWeights> weights_of_pieces(const Problem& problem, const State& state,
                                            const NodeConditions& conditions)
{
    std::vector<PieceWeights> all;
    ParticlePlaces places;
    for (const Boundary& boundary : problem.boundaries) {
        if (!lets_go(boundary.soil)) continue;
        const bool on_line =
            std::all_of(boundary.segments.begin(), boundary.segments.end(),
                        [&](const Segment& segment) { return holds_nodes(problem, boundary, segment); });
        for (const BoundaryPiece& piece : boundary.pieces) {
            const std::size_t p = places.find(state.particles, piece.identifier);
            PieceWeights weights{piece.length, on_line, {}};
            for_each_loaded_node(problem.grid, present_piece(problem, state.particles, piece, p),
                                 [&](std::size_t i, double fraction) {
                                     if (fraction != 0.0)
                                         weights.fractions.emplace_back(conditions.master[i], fraction);
                                 });
            all.push_back(std::move(weights));
        }
    }
    return all;
}

/// F_k = L_k sum_i w_ki y_i over the released nodes.
Scalars forces_of(const std::vector<PieceWeights>& pieces, const Scalars& multiplier)
{
    Scalars forces;
    for (const PieceWeights& piece : pieces) {
        double sum = 0.0;
        for (const auto& [node, fraction] : piece.fractions) sum += fraction * multiplier[node];
        forces.push_back(piece.length * sum);
    }
    return forces;
}

/// sum_k w_ki F_k at the released nodes.
Scalars sums_at_nodes(const std::vector<PieceWeights>& pieces, const std::vector<std::uint8_t>& released,
                      const Scalars& forces)
{
    Scalars sums(released.size(), 0.0);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        for (const auto& [node, fraction] : pieces[k].fractions) {
            if (released[node]) sums[node] += fraction * forces[k];
        }
    }
    return sums;
}

double dot(const Scalars& a, const Scalars& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// Forces of the pieces whose sums at the released nodes are nearest to `wanted` in the least squares: where
/// the curve cuts cells the pieces cannot carry all of it.
Scalars spread_on_pieces(const std::vector<PieceWeights>& pieces, const std::vector<std::uint8_t>& released,
                         const Scalars& wanted)
{
    constexpr int most_iterations = 2000;
    constexpr double tolerance = 1e-30; // of the squared gradient
    const auto sums_of = [&](const Scalars& multiplier) {
        return sums_at_nodes(pieces, released, forces_of(pieces, multiplier));
    };
    Scalars solution(wanted.size(), 0.0), residual = wanted, gradient = sums_of(wanted), direction = gradient;
    double square = dot(gradient, gradient);
    const double enough = tolerance * square;
    for (int k = 0; k < most_iterations && square > enough; ++k) {
        const Scalars image = sums_of(direction);
        const double step = square / dot(image, image);
        for (std::size_t i = 0; i < solution.size(); ++i) {
            solution[i] += step * direction[i];
            residual[i] -= step * image[i];
        }
        gradient = sums_of(residual);
        const double next = dot(gradient, gradient);
        for (std::size_t i = 0; i < solution.size(); ++i)
            direction[i] = gradient[i] + next / square * direction[i];
        square = next;
    }
    return forces_of(pieces, solution);
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
    for (const GroundForce& ground : free_field_forces(problem, state, places))
        forces[conditions.master[ground.node]] += ground.grains + Vector2(ground.mixture_x, 0.0);
    return forces;
}

} // namespace

void hold_reactions(const Problem& problem, State& state)
{
    state.reactions = {};
    const auto releases = [](const Boundary& boundary) { return lets_go(boundary.soil); };
    if (std::none_of(problem.boundaries.begin(), problem.boundaries.end(), releases)) return;
    const NodeConditions held = node_conditions(problem, Stage::relaxation),
                         free = node_conditions(problem, Stage::shaking);
    const std::vector<PieceWeights> pieces = weights_of_pieces(problem, state, held);
    State at_rest;
    const SinglePhaseWorkspace rest = nodes_at_rest(problem, state, at_rest);
    const std::vector<Vector2> ground = resting_ground(problem, held, state);
    const std::vector<SinglePhaseSums>& nodes = rest.sums;
    const std::vector<Vector2> by_rows =
        resting_reactions(problem, rest.walls, nodes, [&](const WallChain& chain) {
            return releases(problem.boundaries[chain.edges.front().boundary]);
        });
    for (const std::uint8_t fixed : {std::uint8_t{solid_x_fixed}, std::uint8_t{solid_y_fixed}}) {
        std::vector<std::uint8_t> released(nodes.size(), 0);
        Scalars wanted(nodes.size(), 0.0);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (!nodes[i].active() || held.master[i] != i) continue;
            released[i] = (held.of_node[i] & ~free.of_node[i] & fixed) != 0;
            if (!released[i]) continue;
            wanted[i] = fixed == solid_x_fixed
                            ? -nodes[i].stress_force_x - ground[i].x()
                            : nodes[i].weight * problem.gravity - nodes[i].stress_force_y - ground[i].y();
        }
        for (std::size_t k = 0; k < by_rows.size(); ++k) {
            const std::size_t i = rest.walls.rows.nodes()[k];
            if (by_rows[k].squaredNorm() == 0.0) continue;
            released[i] = 1;
            wanted[i] += fixed == solid_x_fixed ? by_rows[k].x() : by_rows[k].y();
        }
        add_free_nodes(pieces, nodes, free, fixed, released);
        (fixed == solid_x_fixed ? state.reactions.x : state.reactions.y) =
            spread_on_pieces(pieces, released, wanted);
    }
}

} // namespace quicksand
