// The pressure's preconditioner knows walls and badly filled cells: bodies that lie across the grid cost no
// more iterations than those along it.
#include "solver/step/two_phase_step.hpp"
#include "solver/step_length/time_step_control.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>

namespace quicksand {
namespace {

using namespace fixtures;

/// The most iterations in a few steps of a column under an uneven motion, each with blocks of its own.
int most_iterations(double degrees)
{
    const double h = 0.1;
    const auto corners =
        turned({{{0.0, 0.0}, "base"}, {{0.6, 0.0}, "right"}, {{0.6, 1.0}, "top"}, {{0.0, 1.0}, "left"}},
               degrees, {0.03, 0.0});
    AssembledCase assembled =
        assemble(scene_with(h, {-1.0, -0.3}, 20, 20, saturated_column("semi_implicit", "large", 1e-4)),
                 polygon_section(corners));
    State& state = assembled.state;
    begin_shaking(assembled.problem, state);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Vector2 x = state.particles.position[p];
        const Vector2 v(1e-3 * std::sin(9.0 * x.x() + 4.0 * x.y()),
                        1e-3 * std::cos(7.0 * x.x() - 5.0 * x.y()));
        state.particles.velocity_solid.set(p, v);
        state.particles.velocity_fluid.set(p, v);
    }
    SemiImplicitWorkspace work = make_semi_implicit_workspace(assembled.problem);
    work.controls.tolerance = 1e-3;
    const double dt = stable_time_step(assembled.problem, state.particles).dt;
    int most = 0;
    for (int step = 0; step < 20; ++step) {
        work.pressure.blocks_are_due = true;
        advance_semi_implicit_step(assembled.problem, dt, state, work);
        most = std::max(most, work.pressure.iterations);
    }
    return most;
}

TEST(PressureBlocks, KnowWallsAndBadlyFilledCells)
{
    for (const double degrees : {3.0, 30.0, 45.0, 71.0}) EXPECT_LE(most_iterations(degrees), 2) << degrees;
    EXPECT_LE(most_iterations(0.0), 3); // a whole side of badly filled cells
}

/// Equations of 12 x 12 cells whose pressures act on a few nodes, each of cells all over the block, as those
/// of followers and of tied sides do. There is next to no storage: the equations are nearly singular.
PressureEquations far_touches(const BackgroundGrid& grid, const CellLists& lists)
{
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    PressureEquations equations;
    const auto nodes = static_cast<std::size_t>(grid.node_count());
    equations.compliance = {Scalars(nodes, 1.0), Scalars(nodes, 0.0), Scalars(nodes, 1.0)};
    equations.storage.assign(lists.cell_of_slot.size(), 1e-6);
    equations.diagonal = equations.storage;
    TileDivergence& divergence = equations.divergence.emplace_back();
    constexpr std::int16_t width = 6;
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 12; ++x) {
            const auto cell = static_cast<std::size_t>((y + 2) * grid.all_cells_x() + x + 2);
            const std::int32_t slot = lists.slot_of_cell[cell];
            divergence.stencils.push_back(
                {slot, 50, static_cast<std::int32_t>(divergence.x.size()), width, 1});
            for (int k = 0; k < width; ++k) {
                divergence.x.push_back(number(generator));
                divergence.y.push_back(number(generator));
                equations.diagonal[static_cast<std::size_t>(slot)] +=
                    divergence.x.back() * divergence.x.back() + divergence.y.back() * divergence.y.back();
            }
        }
    }
    return equations;
}

// What the band leaves out must not make the rest indefinite: a pivot at its least value then grows beyond
// all numbers.
TEST(PressureBlocks, StayPositiveWhereTheBandLeavesNumbersOut)
{
    const BackgroundGrid grid{{0.0, 0.0}, 1.0, 14, 14};
    const CellLists lists = make_cell_lists(grid);
    const PressureEquations equations = far_touches(grid, lists);
    NodeConditions conditions;
    conditions.master.resize(static_cast<std::size_t>(grid.node_count()));
    std::iota(conditions.master.begin(), conditions.master.end(), std::size_t{0});
    PressureBlocks blocks;
    set_up_blocks(grid, lists, conditions, 1.0, equations, blocks);
    scale_blocks(equations.diagonal, blocks);
    Scalars residual(lists.cell_of_slot.size(), 0.0), answer = residual;
    double by_storage = 0.0; // the answer without nodes
    for (const CellStencil& stencil : equations.divergence.front().stencils) {
        const auto slot = static_cast<std::size_t>(stencil.cell);
        residual[slot] = std::sin(static_cast<double>(slot));
        by_storage += residual[slot] * residual[slot] / equations.storage[slot];
    }
    precondition(residual, blocks, answer);
    const double product = std::inner_product(residual.begin(), residual.end(), answer.begin(), 0.0);
    EXPECT_GT(product, 0.0);
    EXPECT_LT(product, by_storage);
}

} // namespace
} // namespace quicksand
