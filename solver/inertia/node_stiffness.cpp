#include "solver/inertia/node_stiffness.hpp"

#include "solver/base/lanes.hpp"

#include <array>
#include <utility>

namespace quicksand {

namespace {

constexpr std::size_t lanes = NodeStiffness::lanes, entries = NodeStiffness::entries,
                      per_node = NodeStiffness::per_node;

// integrals over [0, 1] of the functions 1 - t and t of the ends 0 and 1: products, of derivatives, and of
// the derivative of the first with the second
constexpr double products[2][2] = {{1.0 / 3.0, 1.0 / 6.0}, {1.0 / 6.0, 1.0 / 3.0}};
constexpr double slopes[2][2] = {{1.0, -1.0}, {-1.0, 1.0}};
constexpr double mixed[2][2] = {{-0.5, -0.5}, {0.5, 0.5}};

/// What M and G of a cell give to the entries of the block of its nodes a and b.
struct Coefficients {
    std::array<double, entries> of_constrained, of_shear;
};

constexpr Coefficients coefficients_of(std::size_t ax, std::size_t ay, std::size_t bx, std::size_t by)
{
    const double x_x = slopes[ax][bx] * products[ay][by], y_y = products[ax][bx] * slopes[ay][by],
                 x_y = mixed[ax][bx] * mixed[by][ay], y_x = mixed[bx][ax] * mixed[ay][by];
    return {{x_x, x_y, y_x, y_y}, {y_y, y_x - 2.0 * x_y, x_y - 2.0 * y_x, x_x}};
}

/// Rows of four nodes, from the cells to the lower left and right and the upper left and right of each.
VECTOR_KERNEL
void assemble_span(std::size_t stride, const double* M, const double* G, std::size_t first, std::size_t last,
                   double* blocks)
{
    for (std::size_t i = first; i < last; i += lanes) {
        Lanes sums[per_node];
        for (Lanes& sum : sums) sum = all_lanes(0.0);
        for (std::size_t ay = 0; ay < 2; ++ay) {
            for (std::size_t ax = 0; ax < 2; ++ax) {
                const std::size_t cell = i - ay * stride - ax; // whose corner (ax, ay) the node is
                const Lanes constrained = load_lanes(M + cell), shear = load_lanes(G + cell);
                for (std::size_t by = 0; by < 2; ++by) {
                    for (std::size_t bx = 0; bx < 2; ++bx) {
                        const Coefficients c = coefficients_of(ax, ay, bx, by);
                        Lanes* block = sums + ((1 + by - ay) * 3 + (1 + bx - ax)) * entries;
                        for (std::size_t e = 0; e < entries; ++e)
                            block[e] += c.of_constrained[e] * constrained + c.of_shear[e] * shear;
                    }
                }
            }
        }
        for (std::size_t e = 0; e < per_node; ++e) store_lanes(sums[e], blocks + i * per_node + e * lanes);
    }
}

VECTOR_KERNEL
void multiply_span(std::size_t stride, const double* blocks, std::size_t first, std::size_t last,
                   double factor, const double* x, const double* y, double* force_x, double* force_y)
{
    const Lanes factors = all_lanes(factor);
    for (std::size_t i = first; i < last; i += lanes) {
        Lanes sum_x = all_lanes(0.0), sum_y = sum_x;
        const double* block = blocks + i * per_node;
        for (std::size_t b = 0; b < 3; ++b) {
            const std::size_t row = i + b * stride - stride - 1;
            for (std::size_t a = 0; a < 3; ++a, block += entries * lanes) {
                const Lanes v_x = load_lanes(x + row + a), v_y = load_lanes(y + row + a);
                sum_x += load_lanes(block) * v_x + load_lanes(block + lanes) * v_y;
                sum_y += load_lanes(block + 2 * lanes) * v_x + load_lanes(block + 3 * lanes) * v_y;
            }
        }
        sum_x *= factors;
        sum_y *= factors;
        store_lanes(sum_x, force_x + i);
        store_lanes(sum_y, force_y + i);
    }
}

} // namespace

void NodeStiffness::assemble(const NodeRows& rows, const CellModuli& cells,
                             const std::vector<ThreeNodeCell>& with_three_nodes, std::vector<NodeSpan> spans)
{
    rows_ = rows;
    spans_ = std::move(spans);
    blocks_.resize(rows.size() * per_node);
    for_each_span(spans_, [&](std::size_t k) {
        assemble_span(rows_.stride, cells.constrained.data(), cells.shear.data(), spans_[k].first,
                      spans_[k].last, blocks_.data());
    });
    for (const ThreeNodeCell& cell : with_three_nodes) add(cell);
}

/// With o the corner opposite to the missing one, the strains are those of the linear function of its nodes:
/// u,x = s_x (u_x - u_o), u,y = s_y (u_y - u_o), u_x and u_y being those of the other nodes of its two sides.
void NodeStiffness::add(const ThreeNodeCell& cell)
{
    const std::size_t opposite = 3 - cell.missing;
    const double s_x = opposite % 2 == 0 ? 1.0 : -1.0, s_y = opposite / 2 == 0 ? 1.0 : -1.0;
    struct {
        std::size_t corner;
        double x, y; // the derivatives of its function [1/cell]
    } const nodes[] = {{opposite, -s_x, -s_y}, {opposite ^ 1U, s_x, 0.0}, {opposite ^ 2U, 0.0, s_y}};
    const double M = cell.constrained, G = cell.shear, lambda = M - 2.0 * G;
    for (const auto& a : nodes) {
        const std::size_t place = cell.place + a.corner % 2 + a.corner / 2 * rows_.stride;
        for (const auto& b : nodes) {
            const std::size_t neighbour =
                (1 + b.corner / 2 - a.corner / 2) * 3 + 1 + b.corner % 2 - a.corner % 2;
            const double block[] = {M * a.x * b.x + G * a.y * b.y, lambda * a.x * b.y + G * a.y * b.x,
                                    lambda * a.y * b.x + G * a.x * b.y, M * a.y * b.y + G * a.x * b.x};
            for (std::size_t e = 0; e < entries; ++e)
                blocks_[index_of(place, neighbour, e / 2, e % 2)] += block[e];
        }
    }
}

Eigen::Matrix2d NodeStiffness::block(std::size_t place, std::size_t a, std::size_t b) const
{
    const std::size_t k = b * 3 + a;
    return (Eigen::Matrix2d() << entry(place, k, 0, 0), entry(place, k, 0, 1), entry(place, k, 1, 0),
            entry(place, k, 1, 1))
        .finished();
}

void NodeStiffness::multiply(double factor, const Vectors& velocity, Vectors& force) const
{
    for_each_span(spans_, [&](std::size_t k) {
        multiply_span(rows_.stride, blocks_.data(), spans_[k].first, spans_[k].last, factor,
                      velocity.x.data(), velocity.y.data(), force.x.data(), force.y.data());
    });
}

} // namespace quicksand
