#include "solver/block_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace quicksand {

namespace {

/// Rows that touch a block: their numbers, and what scales them to a diagonal of P of ones.
using ScaledRows = std::vector<std::pair<std::size_t, double>>;

ScaledRows find_rows(double dt, const std::vector<HeldRow>& held, const NodeTouches& touches,
                     const std::vector<double>& scale_of_cells, BlockRows& rows)
{
    ScaledRows scaled;
    rows.parts.clear();
    for (std::size_t r = 0; r < held.size(); ++r) {
        double own = 0.0;
        std::map<std::size_t, double> cells; // by row of the block
        for (const HeldNode& node : held[r]) {
            own += node.coefficients.dot(node.velocities);
            for (const Touch& touch : touches.of(node.node))
                cells.try_emplace(touch.row, 0.0).first->second +=
                    touch.x * node.flux.x() + touch.y * node.flux.y();
        }
        if (cells.empty() || own <= 0.0) continue;
        const double scale = 1.0 / std::sqrt(own);
        scaled.emplace_back(r, scale);
        std::vector<BlockRows::Part>& parts = rows.parts.emplace_back();
        for (const auto& [row, value] : cells)
            parts.push_back({row, static_cast<float>(dt * scale * value * scale_of_cells[row])});
    }
    return scaled;
}

/// P of the rows, scaled.
Eigen::MatrixXf row_products(const std::vector<HeldRow>& held, const ScaledRows& rows)
{
    std::map<std::size_t, std::vector<std::pair<std::size_t, const HeldNode*>>> by_node;
    for (std::size_t k = 0; k < rows.size(); ++k)
        for (const HeldNode& node : held[rows[k].first]) by_node[node.node].emplace_back(k, &node);
    const auto index = [](std::size_t k) { return static_cast<Eigen::Index>(k); };
    Eigen::MatrixXf products = Eigen::MatrixXf::Zero(index(rows.size()), index(rows.size()));
    for (const auto& [node, parts] : by_node)
        for (const auto& [a, first] : parts)
            for (const auto& [b, second] : parts)
                products(index(a), index(b)) += static_cast<float>(
                    rows[a].second * rows[b].second * first->coefficients.dot(second->velocities));
    return products;
}

/// G of a row times values of the cells, counted from the block's first row.
float product(const std::vector<BlockRows::Part>& parts, const float* values)
{
    float sum = 0.0f;
    for (const BlockRows::Part& part : parts) sum += part.value * values[part.row];
    return sum;
}

} // namespace

void set_up_rows(double dt, const std::vector<HeldRow>& held, const NodeTouches& touches,
                 const std::vector<double>& scale, const BandedCholesky& factor, std::vector<float>& solution,
                 BlockRows& rows)
{
    const ScaledRows scaled = find_rows(dt, held, touches, scale, rows);
    if (scaled.empty()) return;
    Eigen::MatrixXf matrix = row_products(held, scaled);
    for (std::size_t k = 0; k < scaled.size(); ++k) {
        std::fill(solution.begin(), solution.end(), 0.0f);
        for (const BlockRows::Part& part : rows.parts[k]) solution[factor.band() + part.row] = part.value;
        factor.solve(solution.data());
        for (std::size_t m = 0; m < scaled.size(); ++m)
            matrix(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(k)) -=
                product(rows.parts[m], solution.data() + factor.band());
    }
    matrix = 0.5f * (matrix + matrix.transpose()).eval();
    // rows may repeat each other at corners; a preconditioner may have softer ones
    for (float softness = 1e-3f;; softness *= 10.0f) {
        matrix.diagonal().array() += softness;
        rows.factor.compute(matrix);
        if (rows.factor.info() == Eigen::Success) break;
    }
    rows.multipliers.resize(static_cast<Eigen::Index>(scaled.size()));
}

void hold_rows(const BandedCholesky& factor, const std::vector<float>& given, BlockRows& rows,
               std::vector<float>& solution)
{
    const std::size_t band = factor.band();
    for (std::size_t k = 0; k < rows.parts.size(); ++k)
        rows.multipliers[static_cast<Eigen::Index>(k)] = product(rows.parts[k], solution.data() + band);
    rows.factor.solveInPlace(rows.multipliers);
    solution = given;
    for (std::size_t k = 0; k < rows.parts.size(); ++k)
        for (const BlockRows::Part& part : rows.parts[k])
            solution[band + part.row] += part.value * rows.multipliers[static_cast<Eigen::Index>(k)];
    factor.solve(solution.data());
}

} // namespace quicksand
