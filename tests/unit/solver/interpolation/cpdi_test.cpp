#include "solver/interpolation/cpdi.hpp"
#include "tests/fixtures/node_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace quicksand {
namespace {

using fixtures::sample_grid;
using fixtures::sum_over_nodes;

TEST(Cpdi, GradientIsTheMeanGradientOfTheInterpolantOverTheDomain)
{
    // On its domain the interpolant of a nodal field is bilinear in the domain's own coordinates (s, t); the
    // mean of its gradient follows from central differences of the corner values, with J = [2 r1, 2 r2].
    const ParallelogramDomain domain{{0.1, 0.5}, {0.05, 0.01}, {0.03, 0.05}};
    NodeStencil stencil;
    evaluate_cpdi(sample_grid, domain, stencil);
    const auto field = [](const Vector2& x) { return std::sin(9.0 * x.x()) * std::cos(7.0 * x.y()); };
    const auto bilinear = [&](const Vector2& x) {
        const Vector2 cells = (x - sample_grid.rim_origin()) / sample_grid.cell_size;
        const int i = static_cast<int>(cells.x()), j = static_cast<int>(cells.y());
        const double xi = cells.x() - i, eta = cells.y() - j;
        return (1 - xi) * (1 - eta) * field(sample_grid.node_position(i, j)) +
               xi * (1 - eta) * field(sample_grid.node_position(i + 1, j)) +
               (1 - xi) * eta * field(sample_grid.node_position(i, j + 1)) +
               xi * eta * field(sample_grid.node_position(i + 1, j + 1));
    };
    const Vector2 r1 = domain.half_edge_1, r2 = domain.half_edge_2, c = domain.centre;
    const double f1 = bilinear(c - r1 - r2), f2 = bilinear(c + r1 - r2), f3 = bilinear(c + r1 + r2),
                 f4 = bilinear(c - r1 + r2);
    Eigen::Matrix2d J;
    J << 2.0 * r1, 2.0 * r2;
    const Vector2 slopes(0.5 * (f2 + f3 - f1 - f4), 0.5 * (f3 + f4 - f1 - f2));
    const double det = J(0, 0) * J(1, 1) - J(0, 1) * J(1, 0);
    const Vector2 expected((J(1, 1) * slopes.x() - J(1, 0) * slopes.y()) / det,
                           (J(0, 0) * slopes.y() - J(0, 1) * slopes.x()) / det);

    EXPECT_NEAR(sum_over_nodes(
                    stencil, [&](const NodeWeight& w, const Vector2& x) { return w.gradient_x * field(x); }),
                expected.x(), 1e-11);
    EXPECT_NEAR(sum_over_nodes(
                    stencil, [&](const NodeWeight& w, const Vector2& x) { return w.gradient_y * field(x); }),
                expected.y(), 1e-11);
}

TEST(Cpdi, ADomainThatReachesTooFarIsScaledAndOthersAreKept)
{
    ParallelogramDomain domain{{0.0, 0.4}, {0.25, 0.03}, {0.15, 0.02}};
    EXPECT_TRUE(limit_domain(sample_grid.cell_size, domain)); // 0.40 m where 0.25 m are allowed
    EXPECT_LT((domain.half_edge_1 - 0.625 * Vector2(0.25, 0.03)).norm(), 1e-15);
    EXPECT_LT((domain.half_edge_2 - 0.625 * Vector2(0.15, 0.02)).norm(), 1e-15);
    ParallelogramDomain small{{0.0, 0.4}, {0.1, 0.03}, {0.1, 0.02}};
    EXPECT_FALSE(limit_domain(sample_grid.cell_size, small));
    EXPECT_EQ(small.half_edge_1, Vector2(0.1, 0.03));
}

} // namespace
} // namespace quicksand
