// Flow in time with a free surface, against closed forms and balances.
#include "solver/seepage/transient_flow.hpp"
#include "tests/fixtures/seepage_rectangle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double conductivity = 1e-4, drainable = 0.3; // [m/s], [-]

Scalars pores_of(const GroundFlowProblem& flow)
{
    return pores_of_nodes(flow.mesh, Scalars(flow.mesh.triangles.size(), drainable));
}

FlowHistory follow(const GroundFlowProblem& flow, const Scalars& saturation, double duration, int steps)
{
    return follow_flow([&](double) -> const GroundFlowProblem& { return flow; }, pores_of(flow), saturation,
                       duration, steps);
}

/// Water of the pores over x, of those from the base to the top [m].
double height_of_water(const Scalars& saturation, const Rectangle& box, int column)
{
    double height = 0.0;
    for (int j = 0; j <= box.rows; ++j) {
        const double part = j == 0 || j == box.rows ? 0.5 : 1.0;
        height += part * box.size.y() / box.rows *
                  saturation[static_cast<std::size_t>(j * (box.columns + 1) + column)];
    }
    return height;
}

// Without pressure the water of a column falls at k/n_d, and leaves at k until the last of it has fallen.
TEST(TransientFlow, ColumnDrainsAtItsConductivity)
{
    const double height = 6.0;
    double last_error = 1.0;
    for (const int rows : {30, 60, 120}) {
        const Rectangle box{{1.0, height}, 1, rows};
        GroundFlowProblem flow = mesh_of(box);
        for (std::size_t i = 0; i < flow.water.size(); ++i)
            if (flow.mesh.nodes[i].y() == 0.0) flow.water[i] = NodeWater::head;
        const double duration = 0.4 * drainable * height / conductivity;
        const FlowHistory drained = follow(flow, Scalars(flow.mesh.nodes.size(), 1.0), duration, 2 * rows);
        ASSERT_TRUE(drained.converged);
        EXPECT_NEAR(drained.inflow, -conductivity * duration, 2e-3 * conductivity * duration);
        EXPECT_NEAR(drained.inflow, drained.stored, 1e-9 * drained.turnover);
        double error = 0.0; // in the mean of the saturation
        for (int j = 0; j <= rows; ++j) {
            const double y = height * j / rows, front = 0.6 * height;
            error +=
                std::abs(drained.end.saturation[static_cast<std::size_t>(2 * j)] - (y < front ? 1.0 : 0.0)) /
                rows;
        }
        EXPECT_LT(error, 0.8 * last_error);
        last_error = error;
    }
}

// The water of a shallow mound spreads as that of Barenblatt (1952): with the slopes of Dupuit
//   h_t = a (h^2)_xx,  a = k / (2 n_d),  h = s^(-1/3) (C - x^2 s^(-2/3) / 12),  s = a t.
TEST(TransientFlow, MoundSpreadsAsThatOfBarenblatt)
{
    const double a = conductivity / (2.0 * drainable), C = 1.0;
    const auto mound = [&](double x, double s) {
        return std::max(0.0, std::pow(s, -1.0 / 3.0) * (C - x * x * std::pow(s, -2.0 / 3.0) / 12.0));
    };
    const double first = 1000.0, last = 4000.0; // s: heights .1 and .063, widths 35 and 55
    const Rectangle box{{64.0, 0.12}, 64, 24};
    const GroundFlowProblem flow = mesh_of(box);
    Scalars saturation;
    for (const Vector2& node : flow.mesh.nodes) {
        const double dy = box.size.y() / box.rows;
        saturation.push_back(std::clamp((mound(node.x(), first) - node.y()) / dy + 0.5, 0.0, 1.0));
    }
    const FlowHistory spread = follow(flow, saturation, (last - first) / a, 60);
    ASSERT_TRUE(spread.converged);
    EXPECT_NEAR(spread.stored, 0.0, 1e-9); // the sets are found to 1e-10
    for (int i = 0; i <= box.columns; ++i)
        EXPECT_NEAR(height_of_water(spread.end.saturation, box, i),
                    mound(box.size.x() * i / box.columns, last), 0.025 * mound(0.0, last));
}

TEST(TransientFlow, DamComesToItsSteadyFlow)
{
    const Rectangle box{{16.0, 12.0}, 32, 24};
    const GroundFlowProblem flood = dam(box, 10.0, 2.0), fallen = dam(box, 3.0, 2.0);
    const GroundFlow before = solve_steady_flow(flood), steady = solve_steady_flow(fallen);
    const FlowHistory fall = follow(fallen, before.saturation, 1e8, 60);
    ASSERT_TRUE(fall.converged);
    EXPECT_NEAR(fall.inflow, fall.stored, 1e-9 * fall.turnover);
    for (std::size_t i = 0; i < steady.head.size(); ++i)
        EXPECT_NEAR(fall.end.pressure_head[i], steady.pressure_head[i], 1e-3);
    const FlowHistory rise = follow(flood, steady.saturation, 1e8, 60);
    for (std::size_t i = 0; i < steady.head.size(); ++i)
        EXPECT_NEAR(rise.end.pressure_head[i], before.pressure_head[i], 1e-3);
}

// Three times as large and as long, the flow is the same.
TEST(TransientFlow, KnowsNoScaleOfLength)
{
    const auto drained = [](double scale) {
        const Rectangle box{{16.0 * scale, 12.0 * scale}, 16, 12};
        const GroundFlowProblem flood = dam(box, 10.0 * scale, 2.0 * scale),
                                fallen = dam(box, 3.0 * scale, 2.0 * scale);
        return follow(fallen, solve_steady_flow(flood).saturation, 20000.0 * scale, 20);
    };
    const FlowHistory one = drained(1.0), three = drained(3.0);
    EXPECT_LT(one.stored, -1.0);
    EXPECT_NEAR(three.stored, 9.0 * one.stored, -1e-9 * one.stored);
    for (std::size_t i = 0; i < one.end.head.size(); ++i) {
        EXPECT_NEAR(three.end.pressure_head[i], 3.0 * one.end.pressure_head[i], 1e-9);
        EXPECT_NEAR(three.end.saturation[i], one.end.saturation[i], 1e-9);
    }
}

// Behind water that falls in an instant the soil still holds its own, and lets none in.
TEST(TransientFlow, SlopeKeepsItsWaterAtFirst)
{
    const Rectangle box{{16.0, 12.0}, 32, 24};
    const GroundFlowProblem flood = dam(box, 10.0, 2.0), fallen = dam(box, 3.0, 2.0);
    const GroundFlow before = solve_steady_flow(flood);
    const FlowHistory fall = follow(fallen, before.saturation, 60.0, 20);
    ASSERT_TRUE(fall.converged);
    EXPECT_LT(fall.stored, 0.0);
    EXPECT_GT(fall.stored,
              -conductivity * 60.0 * 10.0); // what leaves the slope at the gradient of its height
    for (std::size_t i = 0; i < fall.end.inflow.size(); ++i) {
        if (fallen.water[i] == NodeWater::open) {
            EXPECT_LT(fall.end.inflow[i], 1e-12);
        }
        EXPECT_LE(fall.end.pressure_head[i], before.pressure_head[i] + 1e-9);
    }
}

// The row of nodes above the line began empty, wherever the line was below it: rising water filled half a row
// too much, and came late.
TEST(TransientFlow, StillWaterStandsBetweenRowsOfNodes)
{
    const Rectangle box{{1.0, 4.0}, 4, 20};
    const GroundFlowProblem flow = mesh_of(box);
    const double half_row = 0.5 * 4.0 / 20;
    for (const double level : {1.0, 1.05, 1.1, 1.15, 1.2}) {
        const Scalars saturation = still_saturations(flow.mesh, flow.conductivity, level);
        for (int column = 0; column <= 4; ++column)
            EXPECT_NEAR(height_of_water(saturation, box, column), level + half_row, 1e-12) << level;
        const FlowHistory still = follow(flow, saturation, 1e4, 10);
        ASSERT_TRUE(still.converged);
        for (std::size_t i = 0; i < saturation.size(); ++i)
            EXPECT_NEAR(still.end.saturation[i], saturation[i], 1e-9);
    }
}

} // namespace
} // namespace quicksand
