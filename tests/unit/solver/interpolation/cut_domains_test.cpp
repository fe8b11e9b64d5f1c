#include "solver/base/cross_product.hpp"
#include "solver/interpolation/cpdi.hpp"
#include "solver/interpolation/cut_domains.hpp"
#include "solver/motion/particle_to_grid.hpp"
#include "solver/particles/cell_lists.hpp"
#include "tests/fixtures/node_sums.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace quicksand {
namespace {

using fixtures::sample_grid;
using fixtures::sum_over_nodes;

Vector2 centroid_of(const std::vector<Vector2>& corners)
{
    double area = 0.0;
    Vector2 moment = Vector2::Zero();
    for (std::size_t c = 1; c + 1 < corners.size(); ++c) {
        const double triangle = cross(corners[c] - corners[0], corners[c + 1] - corners[0]);
        area += triangle;
        moment += triangle / 3.0 * (corners[0] + corners[c] + corners[c + 1]);
    }
    return moment / area;
}

/// A convex polygon about its centroid: points of an ellipse in any direction, three to eight of them.
std::vector<Vector2> random_polygon(std::mt19937& random, double size)
{
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const auto count = static_cast<std::size_t>(3 + 6 * uniform(random));
    std::vector<double> angles;
    while (angles.size() < count) {
        const double angle = 2.0 * std::numbers::pi * uniform(random);
        const bool apart = std::all_of(angles.begin(), angles.end(),
                                       [&](double other) { return std::abs(other - angle) > 0.2; });
        if (apart) angles.push_back(angle);
    }
    std::sort(angles.begin(), angles.end());
    const Vector2 axis_1(size * uniform(random), size * uniform(random)),
        axis_2(-size, size * uniform(random));
    std::vector<Vector2> corners;
    for (const double angle : angles) corners.push_back(std::cos(angle) * axis_1 + std::sin(angle) * axis_2);
    const Vector2 centroid = centroid_of(corners);
    for (Vector2& corner : corners) corner -= centroid;
    return corners;
}

/// One cut particle in a block of whole ones.
struct CutBlock {
    Problem problem;
    State state;

    explicit CutBlock(std::vector<Vector2> corners)
    {
        problem.grid = {{0.0, 0.0}, 0.5, 4, 3};
        problem.materials = {fixtures::stiff_sand()};
        state = fixtures::fill(problem, 2, [](const Vector2&) { return true; });
        problem.cut_domains.number_of.assign(state.particles.size(), -1);
        problem.cut_domains.number_of[17] = 0;
        problem.cut_domains.shapes = {make_cut_domain(std::move(corners))};
    }
};

/// The weights of all particles: by particle, those of its stencil, and whether any domain was scaled down.
std::vector<std::vector<double>> all_weights(const Problem& problem, const Particles& particles,
                                             std::int64_t& limited)
{
    CellLists lists = make_cell_lists(problem.grid);
    update_cell_lists(problem.grid, particles, lists);
    std::vector<std::vector<double>> weights(particles.size());
    limited = 0;
    for (const Tile& tile : lists.tiles) {
        StencilStore store;
        limited += evaluate_weights(problem, particles, lists, tile, store);
        for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k) {
            auto& of_particle = weights[static_cast<std::size_t>(lists.order[k])];
            const StoredStencil& stencil = store.stencils[k - lists.first_entry(tile)];
            of_particle = {static_cast<double>(stencil.base(problem.grid.nodes_x()))};
            for_each_node(stencil, store, problem.grid.nodes_x(), [&](std::size_t, const NodeWeight& w) {
                for (const double part : {w.value, w.gradient_x, w.gradient_y}) of_particle.push_back(part);
            });
        }
    }
    return weights;
}

} // namespace

TEST(CutDomains, AreAPartitionOfUnityAndReproduceLinearFields)
{
    const auto field = [](const Vector2& x) { return 1.5 - 2.0 * x.x() + 0.7 * x.y(); };
    std::mt19937 random(23);
    std::uniform_real_distribution<double> place(-0.1, 0.1);
    for (int trial = 0; trial < 200; ++trial) {
        const CutDomain shape = make_cut_domain(random_polygon(random, 0.06));
        const Vector2 centre = Vector2(0.1, 0.5) + Vector2(place(random), place(random));
        // carried by any two edges
        const Vector2 edge_1(1.1, 4.0 * place(random)), edge_2(3.0 * place(random), 0.8);
        const std::vector<Vector2> corners = corners_in_frame(shape, centre, edge_1, edge_2);
        EXPECT_LT((centroid_of(corners) - centre).norm(), 1e-15);
        NodeStencil stencil;
        evaluate_polygon(sample_grid, shape, corners, stencil);
        const auto sum = [&](auto&& term) { return sum_over_nodes(stencil, term); };
        EXPECT_NEAR(sum([](const NodeWeight& w, const Vector2&) { return w.value; }), 1.0, 1e-14);
        EXPECT_NEAR(sum([](const NodeWeight& w, const Vector2&) { return w.gradient_x; }), 0.0, 1e-10);
        EXPECT_NEAR(sum([](const NodeWeight& w, const Vector2&) { return w.gradient_y; }), 0.0, 1e-10);
        EXPECT_NEAR(sum([&](const NodeWeight& w, const Vector2& x) { return w.value * field(x); }),
                    field(centre), 1e-13);
        EXPECT_NEAR(sum([&](const NodeWeight& w, const Vector2& x) { return w.gradient_x * field(x); }), -2.0,
                    1e-9);
        EXPECT_NEAR(sum([&](const NodeWeight& w, const Vector2& x) { return w.gradient_y * field(x); }), 0.7,
                    1e-9);
        EXPECT_GT(*std::min_element(shape.fractions.begin(), shape.fractions.end()), 0.0);
    }
}

TEST(CutDomains, AreCpdiWhereTheyAreParallelograms)
{
    const CutDomain box = make_cut_domain({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    const ParallelogramDomain domain{{0.113, 0.477}, {0.04, 0.011}, {-0.014, 0.05}};
    NodeStencil cut, whole;
    evaluate_polygon(sample_grid, box,
                     corners_in_frame(box, domain.centre, domain.half_edge_1, domain.half_edge_2), cut);
    evaluate_cpdi(sample_grid, domain, whole);
    ASSERT_EQ(cut.width * cut.height, whole.width * whole.height);
    for (int k = 0; k < cut.width * cut.height; ++k) {
        EXPECT_NEAR(cut.weights[k].value, whole.weights[k].value, 1e-15);
        EXPECT_NEAR(cut.weights[k].gradient_x, whole.weights[k].gradient_x, 1e-12);
        EXPECT_NEAR(cut.weights[k].gradient_y, whole.weights[k].gradient_y, 1e-12);
    }
}

TEST(CutDomains, GiveNoWeightBeyondAGridLineThatTheyEndOn)
{
    // beside lines of the grid by rounding, here and far away
    for (const Vector2& far : {Vector2(0.0, 0.0), Vector2(1000.0, 500.0)}) {
        BackgroundGrid there = sample_grid;
        there.origin += far;
        const double error = 1e-16 * (1.0 + far.x());
        std::vector<Vector2> corners = {
            {-error, 0.4 - error}, {0.1 + error, 0.4}, {0.1 + error, 0.5 + error}};
        const Vector2 centroid = centroid_of(corners);
        std::vector<Vector2> local = corners;
        for (Vector2& corner : local) corner -= centroid;
        for (Vector2& corner : corners) corner += far;
        NodeStencil stencil;
        evaluate_polygon(there, make_cut_domain(local), corners, stencil);
        int with_weight = 0;
        for (int k = 0; k < stencil.width * stencil.height; ++k) {
            const NodeWeight& w = stencil.weights[k];
            with_weight += w.value != 0.0 || w.gradient_x != 0.0 || w.gradient_y != 0.0 ? 1 : 0;
        }
        EXPECT_EQ(with_weight, 3); // a corner at each of three nodes
    }
}

TEST(CutDomains, LeaveTheBitsOfWholeDomainsAsTheyAre)
{
    const CutBlock block({{-1.0, -1.0}, {2.0, -1.0}, {-1.0, 2.0}});
    Problem without = block.problem;
    without.cut_domains = {};
    std::int64_t limited = 0;
    const auto cut = all_weights(block.problem, block.state.particles, limited);
    const auto whole = all_weights(without, block.state.particles, limited);
    EXPECT_EQ(limited, 0);
    for (std::size_t p = 0; p < cut.size(); ++p) EXPECT_EQ(cut[p] == whole[p], p != 17) << p;
}

TEST(CutDomains, AreScaledDownWhenTheyReachTooFar)
{
    CutBlock block({{-1.0, -1.0}, {2.0, -1.0}, {-1.0, 2.0}});
    Particles& particles = block.state.particles;
    std::int64_t limited = 0;
    // cells of 0.5 m: the triangle reaches 2.4, 2.8 and 5.6 of them, its parallelogram 1.2, 1.4 and 2.8
    particles.half_edge_1.set(17, {0.6, 0.0});
    all_weights(block.problem, particles, limited);
    EXPECT_EQ(limited, 0);
    for (const double edge : {0.7, 1.4}) {
        particles.half_edge_1.set(17, {edge, 0.0});
        const auto weights = all_weights(block.problem, particles, limited);
        EXPECT_EQ(limited, 1) << edge;
        double sum = 0.0;
        for (std::size_t k = 1; k < weights[17].size(); k += 3) sum += weights[17][k];
        EXPECT_NEAR(sum, 1.0, 1e-14);
    }
}

TEST(CutDomains, AreFoundByTheLastingNumber)
{
    const CutBlock block({{-1.0, -1.0}, {2.0, -1.0}, {-1.0, 2.0}});
    const Particles& particles = block.state.particles;
    EXPECT_EQ(block.problem.cut_domains.find(16), nullptr);
    EXPECT_NE(block.problem.cut_domains.find(17), nullptr);
    EXPECT_EQ(CutDomains{}.find(17), nullptr);
    const std::vector<Vector2> triangle = domain_polygon(block.problem.cut_domains, particles, 17);
    ASSERT_EQ(triangle.size(), 3u);
    EXPECT_LT((triangle[1] - particles.position[17] - Vector2(0.25, -0.125)).norm(), 1e-15);
    EXPECT_EQ(domain_polygon(block.problem.cut_domains, particles, 3).size(), 4u);
    EXPECT_EQ(reference_polygon(block.problem.cut_domains, particles, 17), triangle);
}

} // namespace quicksand
