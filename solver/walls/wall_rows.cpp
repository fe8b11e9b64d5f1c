#include "solver/walls/wall_rows.hpp"

#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/node_response.hpp"
#include "solver/walls/moving_rows.hpp"
#include "solver/walls/wall_parts.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace quicksand {

namespace {

/// Of a cell, beyond a grid line: what reaches over it by rounding makes no follower [-].
constexpr double least_overlap = 1e-9;

/// The same of the mass of a node with a good cell: weights of corners go with the overlap, those of boxes
/// with its square. Their stiffness does, too, so that the step would be too long for such a node alone [-].
double least_mass(Interpolation interpolation)
{
    const bool is_box = interpolation == Interpolation::gimp || interpolation == Interpolation::cpgimp;
    return is_box ? least_overlap * least_overlap : least_overlap;
}
constexpr double least_row = 1e-6; // sum of a row's parts below which no soil touches the wall there [-]

/// What a row holds of each node.
enum class Held { grains, water, water_against_grains };

/// A node's part in a hat of a chain.
struct HatPart {
    const WallPart* wall;
    double value; // psi_m g_i / h, times the porosity in rows of water [-]
};
using ChainHats = std::vector<std::vector<HatPart>>;

std::vector<ChainHats> by_hats(const Problem& problem, const WallRows& walls,
                               const std::vector<WallPart>& parts)
{
    std::vector<ChainHats> chains;
    for (const WallChain& chain : walls.edges.chains) chains.emplace_back(chain.hats);
    for (const WallPart& part : parts) {
        const std::size_t c = part.contact->chain;
        for_each_hat(walls.edges.chains[c], part.contact->s, [&](std::size_t m, double psi) {
            if (psi > 0.0) chains[c][m].push_back({&part, psi * part.length / problem.grid.cell_size});
        });
    }
    return chains;
}

NodeVelocities coefficients(Held held, const Vector2& c)
{
    NodeVelocities result = NodeVelocities::Zero();
    if (held != Held::water) result.head<2>() = held == Held::grains ? c : Vector2(-c);
    if (held != Held::grains) result.tail<2>() = c;
    return result;
}

/// The rows of a chain's hats, along the normal or across it.
void add_rows(const ChainHats& hats, Held held, bool across, VelocityRows& rows)
{
    for (const std::vector<HatPart>& hat : hats) {
        double sum = 0.0, value = 0.0;
        const auto direction = [&](const HatPart& hat_part) {
            const Vector2& n = hat_part.wall->direction;
            return across ? Vector2(-n.y(), n.x()) : n;
        };
        for (const HatPart& hat_part : hat) {
            sum += hat_part.value;
            value += hat_part.value * hat_part.wall->contact->velocity.dot(direction(hat_part));
        }
        if (sum < least_row) continue;
        rows.begin_row(held == Held::water_against_grains ? 0.0 : value);
        for (const HatPart& hat_part : hat)
            rows.add(hat_part.wall->contact->node, coefficients(held, hat_part.value * direction(hat_part)));
    }
}

void add_grain_rows(const Problem& problem, WallRows& walls)
{
    walls.chain_of_row.clear();
    const std::vector<WallPart> parts =
        divide_normals(problem.grid.cell_size, walls.edges, walls.contacts, walls.active_nodes, walls.normal);
    const std::vector<ChainHats> hats = by_hats(problem, walls, parts);
    for (std::size_t c = 0; c < hats.size(); ++c) {
        const GrainHold hold = walls.edges.chains[c].hold.grains;
        if (hold != GrainHold::none) add_rows(hats[c], Held::grains, false, walls.rows);
        if (hold == GrainHold::all) add_rows(hats[c], Held::grains, true, walls.rows);
        walls.chain_of_row.resize(walls.rows.size(), c);
    }
}

/// Nothing but the flux of the grains passes a sealed wall: sum_i psi_m g_i n_i n . (v_w,i - v_s,i) = 0, n_i
/// being the porosity of the node's flux. With the row of the grains the force of a constant pressure p,
/// (1-n_i) p a_i on the grains and n_i p a_i on the water, then is one of the multipliers' wherever layers of
/// unlike porosity meet the wall. Where the wall does not hold the grains the row is that of the water alone.
void add_water_rows(const Problem& problem, const NodeConditions& conditions,
                    const std::vector<TwoPhaseSums>& sums, WallRows& walls)
{
    const Vectors& normal = walls.divides_water ? walls.wet_normal : walls.normal;
    const std::vector<WallPart> parts =
        divide_normals(problem.grid.cell_size, walls.edges, walls.contacts, walls.active_nodes, normal);
    std::vector<ChainHats> hats = by_hats(problem, walls, parts);
    for (ChainHats& chain : hats) {
        // where all water of a row moves with the grains, their row holds it
        std::erase_if(chain, [&](const std::vector<HatPart>& hat) {
            return std::all_of(hat.begin(), hat.end(), [&](const HatPart& part) {
                return is_sealed(conditions.of_node[part.wall->contact->node]);
            });
        });
        for (std::vector<HatPart>& hat : chain)
            for (HatPart& part : hat) part.value *= node_porosity(problem, sums[part.wall->contact->node]);
    }
    for (std::size_t c = 0; c < hats.size(); ++c) {
        const WallHold& hold = walls.edges.chains[c].hold;
        const bool alone = hold.water == WaterHold::sealed && hold.grains == GrainHold::none;
        if (hold.water != WaterHold::none)
            add_rows(hats[c], alone ? Held::water : Held::water_against_grains, false, walls.rows);
        walls.chain_of_row.resize(walls.rows.size(), c);
    }
}

double water_of_node(const TwoPhaseSums& node)
{
    return node.mass_fluid;
}

double water_of_node(const SinglePhaseSums&)
{
    return 0.0;
}

/// The rows v_k - sum w_m v_m = 0 of a node for the directions that no wall holds at the node itself: those
/// of the grains are 0 and 1, those of the water 2 and 3, unless it moves with the grains. Where both follow
/// the same nodes, the water's have its velocity against the grains: drag over a long step makes an impulse
/// on either phase move both, so that a row of the water alone would nearly repeat that of the grains.
void add_follower(const NodeConditions& conditions, std::size_t k, const std::vector<FollowedNode>& followed,
                  int first_direction, int end_direction, VelocityRows& rows)
{
    for (int direction = first_direction; direction < end_direction; ++direction) {
        const int axis = direction % 2;
        if (direction >= 2 && is_sealed(conditions.of_node[k])) continue;
        if (conditions.of_node[k] & (direction < 2 ? solid_fixed[axis] : fluid_fixed[axis])) continue;
        NodeVelocities part = NodeVelocities::Unit(direction);
        const bool grains_follow = first_direction == 0 && !(conditions.of_node[k] & solid_fixed[axis]);
        if (direction >= 2 && grains_follow) part[axis] = -1.0;
        rows.begin_row(0.0);
        rows.add(k, part);
        for (const FollowedNode& other : followed)
            rows.add(conditions.master[other.node], -other.weight * part);
    }
}

/// Call add(node, what it follows) for the followers that carry more than rounding of what they are
/// followers of: mass(sums of a node).
template <class Sums, class Mass, class Add>
void for_each_follower(const Problem& problem, const NodeConditions& conditions, const CellRoots& roots,
                       const std::vector<Sums>& sums, Mass&& mass, Add&& add)
{
    std::vector<FollowedNode> followed;
    for (const std::size_t k : roots.followers) {
        if (!sums[k].active()) continue;
        follow(problem.grid, roots, k, followed);
        if (followed.empty()) continue;
        const double least =
            least_mass(problem.interpolation) * mass(sums[conditions.master[followed[0].node]]);
        if (mass(sums[k]) > 0.0 && mass(sums[k]) >= least) add(k, followed);
    }
}

/// The rows of the nodes without a good cell, grains and water alike; with roots of its own the water follows
/// these.
template <class Sums>
void add_followers(const Problem& problem, const NodeConditions& conditions, const std::vector<Sums>& sums,
                   WallRows& walls)
{
    walls.rows.begin_followers();
    const auto has_water = [&](std::size_t node) {
        return water_of_node(sums[conditions.master[node]]) > 0.0;
    };
    const auto add = [&](std::size_t k, const std::vector<FollowedNode>& followed) {
        const bool water = !walls.aggregates_water && has_water(k) &&
                           std::all_of(followed.begin(), followed.end(),
                                       [&](const FollowedNode& other) { return has_water(other.node); });
        add_follower(conditions, k, followed, 0, water ? 4 : 2, walls.rows);
    };
    for_each_follower(
        problem, conditions, walls.roots, sums, [](const Sums& node) { return mass_of(node); }, add);
    if (!walls.aggregates_water) return;
    for_each_follower(
        problem, conditions, walls.wet_roots, sums, [](const Sums& node) { return water_of_node(node); },
        [&](std::size_t k, const std::vector<FollowedNode>& followed) {
            add_follower(conditions, k, followed, 2, 4, walls.rows);
        });
}

template <class Sums>
NodeInverse inverse_of(const Sums& node, std::uint8_t held, double dt)
{
    const NodeResponses r = responses(node, dt, held);
    return (NodeInverse() << r.solid, r.exchange, r.exchange, r.fluid).finished();
}

/// What a dashpot takes off a node's response: R - R E H (1 + E^T R E H)^-1 E^T R, E the grains, H = dt C
/// / 2.
void brake(const Dashpot& dashpot, double dt, NodeInverse& inverse)
{
    Eigen::Matrix2d half;
    half << dashpot.xx, dashpot.xy, dashpot.xy, dashpot.yy;
    half *= 0.5 * dt;
    const Eigen::Matrix2d solid = inverse.topLeftCorner<2, 2>();
    const Eigen::Matrix2d kernel = half * (Eigen::Matrix2d::Identity() + solid * half).inverse();
    const Eigen::Matrix<double, 4, 2> columns = inverse.leftCols<2>();
    inverse -= columns * kernel * columns.transpose();
}

template <class Sums>
void factorise(const Problem& problem, const NodeConditions& conditions, double dt,
               const std::vector<Dashpot>& dashpots, const std::vector<Sums>& sums, WallRows& walls)
{
    VelocityRows& rows = walls.rows;
    std::vector<NodeInverse> inverses;
    inverses.reserve(rows.nodes().size());
    for (const std::size_t i : rows.nodes()) {
        inverses.push_back(inverse_of(sums[i], conditions.of_node[i], dt));
        const auto dashpot =
            std::lower_bound(dashpots.begin(), dashpots.end(), i,
                             [](const Dashpot& d, std::size_t node) { return d.node < node; });
        if (dashpot != dashpots.end() && dashpot->node == i) brake(*dashpot, dt, inverses.back());
    }
    if (walls.moves)
        walls.changes = let_values_agree(
            problem.grid, {walls.chain_moves, walls.chain_of_row, walls.contacts.walls}, inverses, rows);
    rows.factorise(std::move(inverses));
}

/// Which nodes in contact with walls have soil; nothing of the others.
template <class Sums>
void find_active(const std::vector<Sums>& sums, WallRows& walls)
{
    walls.active_nodes.resize(sums.size());
    for (const WallContact& contact : walls.contacts.walls)
        walls.active_nodes[contact.node] = sums[contact.node].active() ? 1 : 0;
}

NodeVelocities velocities_of(const TwoPhaseMotion& motion)
{
    return {motion.solid_x, motion.solid_y, motion.fluid_x, motion.fluid_y};
}

NodeVelocities velocities_of(const SinglePhaseMotion& motion)
{
    return {motion.x, motion.y, 0.0, 0.0};
}

/// Multipliers of the rows that keep the forces on the nodes from accelerating them [N].
Scalars force_multipliers(const Problem& problem, double acceleration, const VelocityRows& rows,
                          const std::vector<SinglePhaseSums>& sums)
{
    std::vector<NodeVelocities> gained; // in a unit of time
    for (std::size_t k = 0; k < rows.nodes().size(); ++k) {
        const SinglePhaseSums& node = sums[rows.nodes()[k]];
        const NodeVelocities force(node.stress_force_x - node.mass * acceleration,
                                   node.stress_force_y - node.weight * problem.gravity, 0.0, 0.0);
        gained.push_back(rows.inverse(k) * force);
    }
    return rows.project(gained);
}

/// meet(velocities) makes those at rows.nodes() meet the rows.
template <class Motion, class Meet>
void change(const VelocityRows& rows, Meet&& meet, std::vector<Motion>& motion)
{
    std::vector<NodeVelocities> velocities;
    velocities.reserve(rows.nodes().size());
    for (const std::size_t i : rows.nodes()) velocities.push_back(velocities_of(motion[i]));
    meet(velocities);
    for (std::size_t k = 0; k < velocities.size(); ++k) {
        Motion& node = motion[rows.nodes()[k]];
        const NodeVelocities change = velocities[k] - velocities_of(node);
        add_velocity(node, change.head<2>(), change.tail<2>());
    }
}

template <class Motion>
void hold(const VelocityRows& rows, std::vector<Motion>& motion)
{
    change(
        rows, [&](std::vector<NodeVelocities>& velocities) { rows.hold(velocities); }, motion);
}

template <class Motion>
void rest(const VelocityRows& rows, std::vector<Motion>& motion)
{
    change(
        rows, [&](std::vector<NodeVelocities>& velocities) { rows.project(velocities); }, motion);
}

} // namespace

void assemble_wall_rows(const Problem& problem, const NodeConditions& conditions, double dt,
                        const std::vector<Dashpot>& dashpots, const std::vector<TwoPhaseSums>& sums,
                        WallRows& walls)
{
    if (!walls.any) return;
    walls.rows.clear(sums.size());
    find_active(sums, walls);
    add_grain_rows(problem, walls);
    add_water_rows(problem, conditions, sums, walls);
    add_followers(problem, conditions, sums, walls);
    factorise(problem, conditions, dt, dashpots, sums, walls);
}

void assemble_wall_rows(const Problem& problem, const NodeConditions& conditions, double dt,
                        const std::vector<Dashpot>& dashpots, const std::vector<SinglePhaseSums>& sums,
                        WallRows& walls)
{
    if (!walls.any) return;
    walls.rows.clear(sums.size());
    find_active(sums, walls);
    add_grain_rows(problem, walls);
    add_followers(problem, conditions, sums, walls);
    factorise(problem, conditions, dt, dashpots, sums, walls);
}

void hold_at_walls(const Problem& problem, const std::vector<TwoPhaseSums>& sums, const WallRows& walls,
                   std::vector<TwoPhaseMotion>& motion)
{
    if (walls.rows.empty()) return;
    hold(walls.rows, motion);
    for (const std::size_t i : walls.rows.nodes()) set_flux(problem, sums[i], motion[i]);
}

void hold_at_walls(const WallRows& walls, std::vector<SinglePhaseMotion>& motion)
{
    if (!walls.rows.empty()) hold(walls.rows, motion);
}

void rest_at_walls(const Problem& problem, const std::vector<TwoPhaseSums>& sums, const WallRows& walls,
                   std::vector<TwoPhaseMotion>& motion)
{
    if (walls.rows.empty()) return;
    rest(walls.rows, motion);
    for (const std::size_t i : walls.rows.nodes()) set_flux(problem, sums[i], motion[i]);
}

void rest_at_walls(const WallRows& walls, std::vector<SinglePhaseMotion>& motion)
{
    if (!walls.rows.empty()) rest(walls.rows, motion);
}

void leave_unbalanced_forces(const Problem& problem, double acceleration, const WallRows& walls,
                             std::vector<SinglePhaseSums>& sums)
{
    const VelocityRows& rows = walls.rows;
    if (rows.empty()) return;
    const std::vector<NodeVelocities> impulses =
        rows.impulses(force_multipliers(problem, acceleration, rows, sums));
    for (std::size_t k = 0; k < rows.nodes().size(); ++k) {
        sums[rows.nodes()[k]].stress_force_x += impulses[k].x();
        sums[rows.nodes()[k]].stress_force_y += impulses[k].y();
    }
}

std::vector<Vector2> resting_reactions(const Problem& problem, const WallRows& walls,
                                       const std::vector<SinglePhaseSums>& sums,
                                       const std::function<bool(const WallChain&)>& chosen)
{
    if (walls.rows.empty()) return {};
    Scalars multipliers = force_multipliers(problem, 0.0, walls.rows, sums);
    for (std::size_t r = 0; r < multipliers.size(); ++r) {
        const bool of_chain = r < walls.chain_of_row.size();
        if (!of_chain || !chosen(walls.edges.chains[walls.chain_of_row[r]])) multipliers[r] = 0.0;
    }
    std::vector<Vector2> reactions;
    for (const NodeVelocities& impulse : walls.rows.impulses(multipliers))
        reactions.push_back(impulse.head<2>());
    return reactions;
}

} // namespace quicksand
