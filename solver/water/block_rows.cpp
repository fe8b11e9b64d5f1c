#include "solver/water/block_rows.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/singles.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace quicksand {

namespace {

/// A number of G.
struct Part {
    std::size_t row; // of the block
    float value;
};

/// A row that touches a block.
struct ScaledRow {
    std::size_t number = 0;
    double scale = 0.0;      // to a diagonal of P of ones
    std::vector<Part> parts; // scaled
};

std::vector<ScaledRow> find_rows(double dt, const std::vector<HeldRow>& held, const NodeTouches& touches,
                                 const std::vector<double>& scale_of_cells)
{
    std::vector<ScaledRow> scaled;
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
        ScaledRow& scaled_row = scaled.emplace_back(r, scale);
        for (const auto& [row, value] : cells)
            scaled_row.parts.push_back({row, static_cast<float>(dt * scale * value * scale_of_cells[row])});
    }
    return scaled;
}

/// P of the rows, scaled.
Eigen::MatrixXf row_products(const std::vector<HeldRow>& held, const std::vector<ScaledRow>& rows)
{
    std::map<std::size_t, std::vector<std::pair<std::size_t, const HeldNode*>>> by_node;
    for (std::size_t k = 0; k < rows.size(); ++k)
        for (const HeldNode& node : held[rows[k].number].nodes) by_node[node.node].emplace_back(k, &node);
    const auto index = [](std::size_t k) { return static_cast<Eigen::Index>(k); };
    Eigen::MatrixXf products = Eigen::MatrixXf::Zero(index(rows.size()), index(rows.size()));
    for (const auto& [node, parts] : by_node)
        for (const auto& [a, first] : parts)
            for (const auto& [b, second] : parts)
                products(index(a), index(b)) += static_cast<float>(
                    rows[a].scale * rows[b].scale * first->coefficients.dot(second->velocities));
    for (std::size_t k = 0; k < rows.size(); ++k)
        products(index(k), index(k)) +=
            static_cast<float>(rows[k].scale * rows[k].scale * held[rows[k].number].compliance);
    return products;
}

RowResponse response_to(const BandedCholesky& factor, const std::vector<Part>& parts,
                        std::vector<float>& work)
{
    constexpr float least = 1e-5f; // of a row scaled to one: a mirrored drawing has mirrored answers
    for (const Part& part : parts) work[part.row] = part.value;
    RowResponse response;
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
void subtract_products(const std::vector<RowResponse>& responses, Eigen::MatrixXf& matrix)
{
    for (std::size_t k = 0; k < responses.size(); ++k) {
        const RowResponse& a = responses[k];
        float* column = matrix.data() + k * responses.size();
        for (std::size_t m = k; m < responses.size(); ++m) {
            const RowResponse& b = responses[m];
            const std::size_t first = std::max(a.first, b.first);
            const std::size_t last = std::min(a.first + a.y.size(), b.first + b.y.size());
            if (first < last)
                column[m] -=
                    dot(a.y.data() + (first - a.first), b.y.data() + (first - b.first), last - first);
        }
    }
}

/// Y^T vector, or vector += Y multipliers.
VECTOR_KERNEL
void project(const RowResponse* responses, std::size_t count, const float* vector, float* products)
{
    for (std::size_t k = 0; k < count; ++k)
        products[k] = dot(responses[k].y.data(), vector + responses[k].first, responses[k].y.size());
}
VECTOR_KERNEL
void add(const RowResponse* responses, std::size_t count, const float* multipliers, float* vector)
{
    for (std::size_t k = 0; k < count; ++k) {
        const float* y = responses[k].y.data();
        float* part = vector + responses[k].first;
        for (std::size_t i = 0; i < responses[k].y.size(); ++i) part[i] += multipliers[k] * y[i];
    }
}

} // namespace

void set_up_rows(double dt, const std::vector<HeldRow>& held, const NodeTouches& touches,
                 const std::vector<double>& scale, const BandedCholesky& factor, std::vector<float>& work,
                 BlockRows& rows)
{
    rows.responses.clear();
    const std::vector<ScaledRow> scaled = find_rows(dt, held, touches, scale);
    if (scaled.empty()) return;
    Eigen::MatrixXf matrix = row_products(held, scaled);
    std::fill(work.begin(), work.end(), 0.0f);
    for (const ScaledRow& row : scaled) rows.responses.push_back(response_to(factor, row.parts, work));
    subtract_products(rows.responses, matrix);
    // rows may repeat each other at corners; a preconditioner may have softer ones
    for (float softness = 1e-3f;; softness *= 10.0f) {
        matrix.diagonal().array() += softness;
        rows.factor.compute(matrix);
        if (rows.factor.info() == Eigen::Success) break;
    }
    rows.multipliers.resize(static_cast<Eigen::Index>(scaled.size()));
}

void hold_rows(BlockRows& rows, std::vector<float>& vector)
{
    const std::size_t count = rows.responses.size();
    if (count == 0) return;
    project(rows.responses.data(), count, vector.data(), rows.multipliers.data());
    rows.factor.solveInPlace(rows.multipliers);
    add(rows.responses.data(), count, rows.multipliers.data(), vector.data());
}

} // namespace quicksand
