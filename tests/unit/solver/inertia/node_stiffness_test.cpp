// Stiffness of the nodes, and where soil has left them.
#include "solver/inertia/node_stiffness.hpp"
#include "solver/step/stepper.hpp"
#include "tests/fixtures/same_bits.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <memory>
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
        stiffness.assemble(rows, cells, spans);
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

} // namespace
} // namespace quicksand
