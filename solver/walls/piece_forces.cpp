#include "solver/walls/piece_forces.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// F_k = L_k sum_i w_ki y_i over the nodes.
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

double dot(const Scalars& a, const Scalars& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// The largest diagonal number of B.
double largest_diagonal(const std::vector<PieceWeights>& pieces, const std::vector<std::uint8_t>& chosen)
{
    Scalars diagonal(chosen.size(), 0.0);
    for (const PieceWeights& piece : pieces)
        for (const auto& [node, fraction] : piece.fractions)
            if (chosen[node]) diagonal[node] += piece.length * fraction * fraction;
    return *std::max_element(diagonal.begin(), diagonal.end());
}

/// x of (B + ridge) x = b by conjugate gradients.
template <class Matrix>
Scalars solve_with_ridge(Matrix&& multiply, double ridge, const Scalars& b)
{
    constexpr int most_iterations = 2000;
    constexpr double tolerance = 1e-28; // of the squared right-hand side
    Scalars solution(b.size(), 0.0), residual = b, direction = b;
    double square = dot(b, b);
    const double enough = tolerance * square;
    for (int k = 0; k < most_iterations && square > enough; ++k) {
        Scalars image = multiply(direction);
        for (std::size_t i = 0; i < b.size(); ++i) image[i] += ridge * direction[i];
        const double step = square / dot(direction, image);
        for (std::size_t i = 0; i < b.size(); ++i) {
            solution[i] += step * direction[i];
            residual[i] -= step * image[i];
        }
        const double next = dot(residual, residual);
        for (std::size_t i = 0; i < b.size(); ++i) direction[i] = residual[i] + next / square * direction[i];
        square = next;
    }
    return solution;
}

} // namespace

Scalars sums_at_nodes(const std::vector<PieceWeights>& pieces, const std::vector<std::uint8_t>& chosen,
                      const Scalars& forces)
{
    Scalars sums(chosen.size(), 0.0);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        for (const auto& [node, fraction] : pieces[k].fractions) {
            if (chosen[node]) sums[node] += fraction * forces[k];
        }
    }
    return sums;
}

Scalars spread_on_pieces(const std::vector<PieceWeights>& pieces, const std::vector<std::uint8_t>& chosen,
                         const Scalars& wanted)
{
    constexpr double ridge = 1e-4; // of the largest diagonal number
    constexpr int rounds = 12;
    constexpr double rounding = 1e-30; // of the squared forces wanted
    const auto sums_of = [&](const Scalars& multiplier) {
        return sums_at_nodes(pieces, chosen, forces_of(pieces, multiplier));
    };
    const double scale = largest_diagonal(pieces, chosen);
    if (!(scale > 0.0)) return Scalars(pieces.size(), 0.0); // no piece reaches a chosen node
    Scalars solution(wanted.size(), 0.0), residual = wanted;
    const double enough = rounding * dot(wanted, wanted);
    for (int round = 0; round < rounds && dot(residual, residual) > enough; ++round) {
        const Scalars change = solve_with_ridge(sums_of, ridge * scale, residual);
        for (std::size_t i = 0; i < solution.size(); ++i) solution[i] += change[i];
        residual = sums_of(solution);
        for (std::size_t i = 0; i < residual.size(); ++i) residual[i] = wanted[i] - residual[i];
    }
    return forces_of(pieces, solution);
}

FollowingNodes::FollowingNodes(const VelocityRows& rows, int axis)
{
    rows.for_each_followed([&](std::size_t follower, int direction, std::size_t node, double weight) {
        if (direction == axis) parts_[follower].emplace_back(node, weight);
    });
}

void FollowingNodes::pass_on(Scalars& forces) const
{
    for (const auto& [follower, followed] : parts_)
        for (const auto& [node, weight] : followed) forces[node] += weight * forces[follower];
    for (const auto& [follower, followed] : parts_) forces[follower] = 0.0;
}

std::vector<PieceWeights> FollowingNodes::passed_on(std::vector<PieceWeights> pieces) const
{
    for (PieceWeights& piece : pieces) {
        std::vector<std::pair<std::size_t, double>> fractions;
        for (const auto& [node, fraction] : piece.fractions) {
            const auto follower = parts_.find(node);
            if (follower == parts_.end()) {
                fractions.emplace_back(node, fraction);
                continue;
            }
            for (const auto& [followed, weight] : follower->second)
                fractions.emplace_back(followed, weight * fraction);
        }
        piece.fractions = std::move(fractions);
    }
    return pieces;
}

} // namespace quicksand
