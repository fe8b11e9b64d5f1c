#include "solver/particles/cell_lists.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace quicksand {
namespace {

using namespace fixtures;

Problem wide_grid()
{
    Problem problem;
    problem.grid = {{1.0, -2.0}, 0.5, 30, 21};
    problem.materials = {stiff_sand()};
    return problem;
}

TEST(CellLists, EveryParticleIsListedOnceInTheCellOfItsCentre)
{
    const Problem problem = wide_grid();
    const State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 0.3 * x.x(); });
    CellLists lists = make_cell_lists(problem.grid);
    ASSERT_EQ(update_cell_lists(problem.grid, state.particles, lists), -1);

    std::set<std::int32_t> listed(lists.order.begin(), lists.order.end());
    EXPECT_EQ(listed.size(), state.particles.size());
    for (std::size_t c = 0; c + 1 < lists.cell_start.size(); ++c) {
        for (auto k = lists.cell_start[c]; k < lists.cell_start[c + 1]; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[static_cast<std::size_t>(k)]);
            EXPECT_EQ(lists.cell_of_particle[p], static_cast<std::int32_t>(c));
        }
    }
}

TEST(CellLists, TilesOfOneColourNeverShareANode)
{
    const BackgroundGrid grid = wide_grid().grid;
    const CellLists lists = make_cell_lists(grid);
    std::vector<int> cell_of_slot(grid.cell_count());
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell)
        cell_of_slot[static_cast<std::size_t>(lists.slot_of_cell[cell])] = static_cast<int>(cell);
    constexpr int reach = 3; // cells a domain may stick out
    for (const auto& tiles : lists.tiles_of_colour) {
        std::vector<int> owner(grid.node_count(), -1);
        for (const Tile& tile : tiles) {
            for (auto slot = tile.first_cell; slot < tile.last_cell; ++slot) {
                const int cell = cell_of_slot[static_cast<std::size_t>(slot)];
                const int i = cell % grid.all_cells_x(), j = cell / grid.all_cells_x();
                for (int b = std::max(0, j - reach); b <= std::min(grid.nodes_y() - 1, j + reach + 1); ++b) {
                    for (int a = std::max(0, i - reach); a <= std::min(grid.nodes_x() - 1, i + reach + 1);
                         ++a) {
                        int& number = owner[static_cast<std::size_t>(b * grid.nodes_x() + a)];
                        EXPECT_TRUE(number == -1 || number == tile.number);
                        number = tile.number;
                    }
                }
            }
        }
    }
}

TEST(CellLists, AParticleOutsideTheGridOrNowhereIsReported)
{
    const Problem problem = wide_grid();
    State state = fill(problem, 1, [](const Vector2& x) { return x.x() < 3.0; });
    CellLists lists = make_cell_lists(problem.grid);
    state.particles.position.x[7] = 0.49; // more than a cell left of the grid
    EXPECT_EQ(update_cell_lists(problem.grid, state.particles, lists), 7);
    state.particles.position.x[7] = 0.51; // within the cell that is allowed
    EXPECT_EQ(update_cell_lists(problem.grid, state.particles, lists), -1);
    state.particles.position.y[5] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(update_cell_lists(problem.grid, state.particles, lists), 5);
}

TEST(CellLists, ReorderingByTheListsLeavesNoDisorder)
{
    const Problem problem = wide_grid();
    State state = fill(problem, 2, [](const Vector2&) { return true; });
    CellLists lists = make_cell_lists(problem.grid);
    update_cell_lists(problem.grid, state.particles, lists);
    EXPECT_GT(disorder(lists), 0.3);
    reorder(state.particles, lists.order);
    lists.cell_of_particle.clear();
    update_cell_lists(problem.grid, state.particles, lists);
    EXPECT_EQ(disorder(lists), 0.0);
}

} // namespace
} // namespace quicksand
