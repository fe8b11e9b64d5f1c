#include "solver/water/block_rows.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/singles.hpp"

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
        double own = held[r].compliance;
        std::map<std::size_t, double> cells; // by row of the block
        for (const HeldNode& node : held[r].nodes) {
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
        for (const HeldNode& node : held[rows[k].first].nodes) by_node[node.node].emplace_back(k, &node);
    const auto index = [](std::size_t k) { return static_cast<Eigen::Index>(k); };
    Eigen::MatrixXf products = Eigen::MatrixXf::Zero(index(rows.size()), index(rows.size()));
    for (const auto& [node, parts] : by_node)
        for (const auto& [a, first] : parts)
            for (const auto& [b, second] : parts)
                products(index(a), index(b)) += static_cast<float>(
                    rows[a].second * rows[b].second * first->coefficients.dot(second->velocities));
    for (std::size_t k = 0; k < rows.size(); ++k)
        products(index(k), index(k)) +=
            static_cast<float>(rows[k].second * rows[k].second * held[rows[k].first].compliance);
    return products;
}

/// G of a row times values of the cells, counted from the block's first row.
float product(const std::vector<BlockRows::Part>& parts, const float* values)
{
    float sum = 0.0f;
    for (const BlockRows::Part& part : parts) sum += part.value * values[part.row];
    return sum;
}

/// y of L y = G^T for one row: numbers [first, first + y.size()); those behind are next to nothing.
struct Response {
    std::size_t first = 0;
    std::vector<float> y;
};

Response response_to(const BandedCholesky& factor, const std::vector<BlockRows::Part>& parts,
                     std::vector<float>& work)
{
    constexpr float least = 1e-5f; // of a row scaled to one: a mirrored drawing has mirrored answers
    for (const BlockRows::Part& part : parts) work[part.row] = part.value;
    Response response;
    response.first = parts.front().row / BandedCholesky::lanes * BandedCholesky::lanes;
    const std::size_t end = factor.solve_lower(parts.front().row, parts.back().row + 1, least, work.data());
    const auto first = work.begin() + static_cast<std::ptrdiff_t>(response.first),
               last = work.begin() + static_cast<std::ptrdiff_t>(end);
    response.y.assign(first, last);
    std::fill(first, last, 0.0f);
    return response;
}

/// Take G F^-1 G^T from the lower half of P; it is the products of the rows' responses.
VECTOR_KERNEL
void subtract_products(const std::vector<Response>& responses, Eigen::MatrixXf& matrix)
{
    for (std::size_t k = 0; k < responses.size(); ++k) {
        const Response& a = responses[k];
        float* column = matrix.data() + k * responses.size();
        for (std::size_t m = k; m < responses.size(); ++m) {
            const Response& b = responses[m];
            const std::size_t first = std::max(a.first, b.first);
            const std::size_t last = std::min(a.first + a.y.size(), b.first + b.y.size());
            if (first < last)
                column[m] -=
                    dot(a.y.data() + (first - a.first), b.y.data() + (first - b.first), last - first);
        }
    }
}

} // namespace

void set_up_rows(double dt, const std::vector<HeldRow>& held, const NodeTouches& touches,
                 const std::vector<double>& scale, const BandedCholesky& factor, std::vector<float>& solution,
                 BlockRows& rows)
{
    const ScaledRows scaled = find_rows(dt, held, touches, scale, rows);
    if (scaled.empty()) return;
    Eigen::MatrixXf matrix = row_products(held, scaled);
    std::fill(solution.begin(), solution.end(), 0.0f);
    std::vector<Response> responses;
    for (const std::vector<BlockRows::Part>& parts : rows.parts)
        responses.push_back(response_to(factor, parts, solution));
    subtract_products(responses, matrix);
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
    for (std::size_t k = 0; k < rows.parts.size(); ++k)
        rows.multipliers[static_cast<Eigen::Index>(k)] = product(rows.parts[k], solution.data());
    rows.factor.solveInPlace(rows.multipliers);
    solution = given;
    for (std::size_t k = 0; k < rows.parts.size(); ++k)
        for (const BlockRows::Part& part : rows.parts[k])
            solution[part.row] += part.value * rows.multipliers[static_cast<Eigen::Index>(k)];
    factor.solve(solution.data());
}

} // namespace quicksand
