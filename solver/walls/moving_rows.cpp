#include "solver/walls/moving_rows.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <map>

namespace quicksand {

namespace {

using Velocities = std::vector<NodeVelocities>; // by the places of the rows' nodes

/// The chain's motion at every node: that of its nearest place in contact, zero where it stands. `part` is
/// the velocity of the contacts or what it has changed by.
Velocities motion_of(const BackgroundGrid& grid, std::size_t chain, const ChainsOfRows& chains,
                     const VelocityRows& rows, Vector2 WallContact::*part)
{
    Velocities motion(rows.nodes().size(), NodeVelocities::Zero());
    if (!chains.moves[chain]) return motion;
    std::vector<const WallContact*> contacts;
    for (const WallContact& contact : chains.contacts)
        if (contact.chain == chain) contacts.push_back(&contact);
    if (contacts.empty()) return motion;
    for (std::size_t k = 0; k < motion.size(); ++k) {
        const Vector2 place = grid.node_position(rows.nodes()[k]);
        const auto nearest =
            std::min_element(contacts.begin(), contacts.end(), [&](const auto* a, const auto* b) {
                return (grid.node_position(a->node) - place).squaredNorm() <
                       (grid.node_position(b->node) - place).squaredNorm();
            });
        const Vector2& velocity = (**nearest).*part;
        motion[k] << velocity.x(), velocity.y(), velocity.x(), velocity.y();
    }
    return motion;
}

/// What rows ask of one node, d . u = d . V with weight w; directions that differ by a small angle are one.
class NodeDemand {
public:
    void add(const NodeVelocities& c, const NodeVelocities& motion)
    {
        constexpr double small_angle = 0.2; // sine [-]
        const double size = c.norm(), value = c.dot(motion);
        if (!(size > 0.0)) return;
        agrees_ = agrees_ && (directions_.empty() || motion == motion_);
        motion_ = motion;
        for (Direction& known : directions_) {
            const double along = known.sum.dot(c) / known.sum.norm();
            if (size * size - along * along > small_angle * small_angle * size * size) continue;
            const double sign = along < 0.0 ? -1.0 : 1.0;
            known.sum += sign * c;
            known.value += sign * value;
            return;
        }
        directions_.push_back({c, value});
    }
    /// V where all ask for one, else least squares.
    NodeVelocities velocities() const { return agrees_ ? motion_ : least_squares(); }

private:
    struct Direction {
        NodeVelocities sum; // of w d
        double value;       // of w d . V
    };

    NodeVelocities least_squares() const
    {
        constexpr double rounding = 1e-9;
        Eigen::Matrix4d weights = Eigen::Matrix4d::Zero();
        NodeVelocities values = NodeVelocities::Zero(), u = NodeVelocities::Zero();
        for (const Direction& known : directions_) {
            weights += known.sum * known.sum.transpose() / known.sum.norm();
            values += known.sum * (known.value / known.sum.norm());
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(weights);
        for (int k = 0; k < 4; ++k) {
            const double size = eigen.eigenvalues()[k];
            if (!(size > rounding * eigen.eigenvalues()[3])) continue;
            const NodeVelocities direction = eigen.eigenvectors().col(k);
            u += direction * (direction.dot(values) / size);
        }
        return u;
    }

    bool agrees_ = true;
    NodeVelocities motion_ = NodeVelocities::Zero(); // of the last one
    std::vector<Direction> directions_;
};

/// A node, by its place, that another one follows along a direction of NodeVelocities.
struct Followed {
    int direction;
    std::size_t place;
    double weight;
};

/// What the chains' rows ask of the nodes that follow none.
std::vector<NodeDemand> demands_on_nodes(const ChainsOfRows& chains, const std::vector<Velocities>& of_chain,
                                         const VelocityRows& rows)
{
    std::vector<std::vector<Followed>> followed(rows.nodes().size());
    rows.for_each_followed([&](std::size_t follower, int direction, std::size_t node, double weight) {
        followed[rows.place(follower)].push_back({direction, rows.place(node), weight});
    });
    std::vector<NodeDemand> demands(rows.nodes().size());
    rows.for_each_coefficient([&](std::size_t row, std::size_t node, const NodeVelocities& c) {
        if (row >= chains.of_row.size()) return;
        const Velocities& motion = of_chain[chains.of_row[row]];
        const std::size_t place = rows.place(node);
        NodeVelocities own = c;
        std::map<std::size_t, NodeVelocities> parts; // by place
        for (const Followed& other : followed[place]) {
            NodeVelocities& part = parts.try_emplace(other.place, NodeVelocities::Zero()).first->second;
            part[other.direction] += other.weight * c[other.direction];
            own[other.direction] = 0.0;
        }
        for (const auto& [other, part] : parts) demands[other].add(part, motion[other]);
        demands[place].add(own, motion[place]);
    });
    return demands;
}

/// Nodes that are held along an axis do not move along it.
void hold_nodes(const std::vector<NodeInverse>& inverses, Velocities& motion)
{
    for (std::size_t k = 0; k < motion.size(); ++k)
        for (int d = 0; d < 4; ++d)
            if (inverses[k](d, d) == 0.0) motion[k][d] = 0.0;
}

std::vector<Velocities> motions_of_chains(const BackgroundGrid& grid, const ChainsOfRows& chains,
                                          const VelocityRows& rows, Vector2 WallContact::*part)
{
    std::vector<Velocities> of_chain;
    for (std::size_t chain = 0; chain < chains.moves.size(); ++chain)
        of_chain.push_back(motion_of(grid, chain, chains, rows, part));
    return of_chain;
}

/// The motion that each node is given.
Velocities agreed_motion(const ChainsOfRows& chains, const std::vector<Velocities>& of_chain,
                         const std::vector<NodeInverse>& inverses, const VelocityRows& rows)
{
    Velocities motion;
    for (const NodeDemand& demand : demands_on_nodes(chains, of_chain, rows))
        motion.push_back(demand.velocities());
    hold_nodes(inverses, motion);
    rows.extrapolate(motion);
    return motion;
}

} // namespace

std::vector<NodeVelocities> let_values_agree(const BackgroundGrid& grid, const ChainsOfRows& chains,
                                             const std::vector<NodeInverse>& inverses, VelocityRows& rows)
{
    std::vector<Velocities> of_chain = motions_of_chains(grid, chains, rows, &WallContact::velocity);
    const Velocities motion = agreed_motion(chains, of_chain, inverses, rows);
    for (Velocities& free : of_chain) rows.extrapolate(free);
    for (std::size_t r = 0; r < chains.of_row.size(); ++r)
        rows.set_value(r,
                       rows.value(r) + rows.product(r, motion) - rows.product(r, of_chain[chains.of_row[r]]));
    if (std::all_of(chains.contacts.begin(), chains.contacts.end(),
                    [](const WallContact& contact) { return contact.change.isZero(0.0); }))
        return {};
    const std::vector<Velocities> changes = motions_of_chains(grid, chains, rows, &WallContact::change);
    return agreed_motion(chains, changes, inverses, rows);
}

} // namespace quicksand
