// Stiffness of the nodes, and where soil has left them.
#include "solver/inertia/node_stiffness.hpp"
#include "solver/step/stepper.hpp"
#include "tests/fixtures/same_bits.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <set>
#include <vector>

namespace quicksand {
namespace {

using namespace fixtures;

TEST(NodeStiffness, HasRowsOfTheNodesWithSoilAlone)
{
    const NodeRows rows = make_node_rows({{0.0, 0.0}, 1.0, 5, 4});
    CellModuli cells{Scalars(rows.size(), 2e6), Scalars(rows.size(), 1e6)};
    NodeStiffness stiffness;
    const auto nodes_with_rows = [&](const std::set<std::size_t>& with_soil) {
        std::vector<NodeSpan> spans;
        find_spans(
            rows, [&](std::size_t node) { return with_soil.contains(node); }, spans);
        stiffness.assemble(rows, cells, {}, spans);
        std::set<std::size_t> visited;
        stiffness.for_each_node([&](std::size_t node, std::size_t place) {
            EXPECT_EQ(place, rows.place(node));
            visited.insert(node);
        });
        return visited;
    };
    const std::size_t width = rows.nodes_x;
    const auto rows_of = [&](const std::set<std::size_t>& nodes) {
        std::set<std::size_t> numbers;
        for (const std::size_t node : nodes) numbers.insert(node / width);
        return numbers;
    };
    const std::size_t low = width + 2, high = 2 * width + 3;
    std::set<std::size_t> visited = nodes_with_rows({low, high});
    EXPECT_EQ(rows_of(visited), (std::set<std::size_t>{1, 2}));
    EXPECT_TRUE(visited.contains(low) && visited.contains(high));
    visited = nodes_with_rows({low});
    EXPECT_EQ(rows_of(visited), std::set<std::size_t>{1});
}

// Nodes beyond a roller are tied to those on it, with or without soil.
TEST(NodeStiffness, LeavesNothingWhereSoilHasLeftTheNodesBeyondAWall)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0, 6, 12};
    problem.materials = {stiff_sand()};
    problem.gravity = 0.0;
    problem.scheme = TimeScheme::implicit;
    problem.boundaries = rectangle(0.0, 0.0, 3.0, 12.0, FreeFace{}, RollerWall{}, FreeFace{});
    State state =
        fill(problem, 2, [](const Vector2& x) { return x.x() < 3.0 && x.y() > 1.0 && x.y() < 4.0; });
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        state.particles.velocity_solid.set(p, {state.particles.position.y[p] > 3.0 ? -1.0 : 1.0, 200.0});
    const std::unique_ptr<Stepper> stepper = make_stepper(problem);
    for (int k = 0; k < 40; ++k) stepper->advance(problem, 5e-4, state);
    State copy = state;
    const std::unique_ptr<Stepper> other = make_stepper(problem);
    stepper->advance(problem, 5e-4, state);
    other->advance(problem, 5e-4, copy);
    expect_same_bits(state.particles, copy.particles);
}

/// The largest velocity of the corners of a grain's domain [m/s].
double fastest_corner(const Particles& grain)
{
    const Vector2 v = grain.velocity_solid[0], r_1 = grain.half_edge_1[0], r_2 = grain.half_edge_2[0];
    const Gradients& C = grain.affine_velocity_solid;
    const auto field = [&](const Vector2& r) {
        return Vector2(C.xx[0] * r.x() + C.xy[0] * r.y(), C.yx[0] * r.x() + C.yy[0] * r.y());
    };
    return v.norm() + std::max(field(r_1 + r_2).norm(), field(r_1 - r_2).norm());
}

// Without stiffness in the cells beside the node, the parts before and behind it turn without resistance: up
// to thousands of metres per second from stresses whose energy is that of 2 m/s.
TEST(NodeStiffness, HoldsAGrainWhoseDomainPassesANodeTogether)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0, 6, 6};
    problem.materials = {stiff_sand()};
    problem.gravity = 0.0;
    problem.scheme = TimeScheme::implicit;
    problem.strain = StrainForm::small;
    const Material& sand = problem.materials[0];
    const double M = constrained_modulus(std::get<LinearElastic>(sand.law));
    const double density = (1.0 - sand.porosity) * sand.grain_density, wave = std::sqrt(M / density);
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> offset(-0.1, 0.1), part(-1.0, 1.0);
    for (int k = 0; k < 800; ++k) {
        SCOPED_TRACE(k);
        State state = fill(problem, 1, [](const Vector2& x) { return x.x() < 1.0 && x.y() < 1.0; });
        Particles& grain = state.particles;
        const double length = 0.17 * (1.0 + (k % 4)), angle = 3.0 * part(generator);
        const double width = std::vector{1.0, 0.5, 0.2, 0.1}[static_cast<std::size_t>(k / 4 % 4)] * length;
        grain.position.set(0, Vector2(3.0 + offset(generator), 3.0 + offset(generator)));
        grain.half_edge_1.set(0, length * Vector2(std::cos(angle), std::sin(angle)));
        grain.half_edge_2.set(0, width * Vector2(-std::sin(angle), std::cos(angle)));
        grain.volume[0] = 4.0 * length * width;
        grain.mass_solid[0] = density * grain.volume[0];
        const double strain = 0.01;
        grain.stress.xx[0] = strain * M * part(generator);
        grain.stress.yy[0] = strain * M * part(generator);
        grain.stress.xy[0] = strain * M * part(generator);
        begin_shaking(state);
        const std::unique_ptr<Stepper> stepper = make_stepper(problem);
        double fastest = 0.0;
        for (int step = 0; step < 50; ++step) {
            stepper->advance(problem, 5.0 / wave, state);
            fastest = std::max(fastest, fastest_corner(grain));
        }
        EXPECT_LT(fastest, 3.0 * strain * wave);
    }
}

} // namespace
} // namespace quicksand
