// Steady flow with a free surface on meshes of rectangles cut in halves, against closed forms.
#include "solver/seepage/flow_field.hpp"
#include "solver/seepage/ground_flow.hpp"
#include "tests/fixtures/seepage_rectangle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace quicksand {
namespace {

using namespace fixtures;

double highest_exit(const GroundFlowProblem& flow, const GroundFlow& solution)
{
    double highest = 0.0;
    for (std::size_t i = 0; i < flow.water.size(); ++i)
        if (flow.water[i] == NodeWater::open && solution.inflow[i] < -1e-9 * solution.discharge)
            highest = std::max(highest, flow.mesh.nodes[i].y());
    return highest;
}

double sum(const Scalars& values)
{
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum;
}

TEST(GroundFlow, DamHasTheDischargeOfDupuit)
{
    for (const int refinement : {1, 2, 4}) {
        for (const double right : {4.0, 0.0}) {
            Rectangle box;
            box.columns = 8 * refinement;
            box.rows = 12 * refinement;
            const GroundFlow flow = solve_steady_flow(dam(box, 24.0, right));
            ASSERT_TRUE(flow.converged);
            EXPECT_LE(flow.iterations, 15);
            const double dupuit = 1e-4 * (24.0 * 24.0 - right * right) / (2.0 * 16.0);
            EXPECT_NEAR(flow.discharge, dupuit, 1e-9 * dupuit); // of any mesh of rectangles
            EXPECT_NEAR(sum(flow.inflow), 0.0, 1e-9 * dupuit);
            EXPECT_LT(flow.imbalance, 1e-9);
        }
    }
}

TEST(GroundFlow, DamInTwoPartsHasTheDischargeOfDupuit)
{
    // Q = (h1^2 - h2^2) / 2 over the sum of the widths over their conductivities
    for (const double ratio : {1e4, 10.0, 0.1, 1e-4}) {
        Rectangle box;
        box.size = {20.0, 12.0};
        box.columns = 40;
        box.conductivity = [&](const Vector2& x) { return x.x() < 10.0 ? 1e-4 : ratio * 1e-4; };
        for (const double right : {2.0, 0.0}) {
            const GroundFlow flow = solve_steady_flow(dam(box, 10.0, right));
            ASSERT_TRUE(flow.converged) << ratio;
            EXPECT_LE(flow.iterations, 15) << ratio;
            const double dupuit = (100.0 - right * right) / 2.0 / (10.0 / 1e-4 + 10.0 / (ratio * 1e-4));
            EXPECT_NEAR(flow.discharge, dupuit, 5e-6 * dupuit) << ratio;
        }
    }
}

TEST(GroundFlow, WaterLeavesTheDamOfMuskatAboveItsTail)
{
    // 16 m wide between 24 m and 4 m of water: 12.7 to 12.8 m in the literature on this test, within one edge
    for (const int refinement : {1, 2, 4}) {
        Rectangle box;
        box.columns = 16 * refinement;
        box.rows = 24 * refinement;
        const GroundFlowProblem problem = dam(box, 24.0, 4.0);
        const GroundFlow flow = solve_steady_flow(problem);
        EXPECT_NEAR(highest_exit(problem, flow), 12.75, 1.0 / refinement);
        const FlowField field(problem.mesh, flow.head);
        double before = 24.0 + 1e-9;
        for (double x = 0.5; x < 16.0; x += 0.5) {
            const double surface = field.surface(x).value();
            EXPECT_LT(surface, before) << x;
            before = surface;
        }
    }
}

TEST(GroundFlow, KnowsNoScaleOfConductivity)
{
    Rectangle box, looser;
    looser.conductivity = [](const Vector2&) { return 1e-1; };
    const GroundFlow flow = solve_steady_flow(dam(box, 20.0, 3.0)),
                     more = solve_steady_flow(dam(looser, 20.0, 3.0));
    EXPECT_NEAR(more.discharge, 1e3 * flow.discharge, 1e-9 * more.discharge);
    for (std::size_t i = 0; i < flow.head.size(); ++i) EXPECT_NEAR(more.head[i], flow.head[i], 1e-8);
}

TEST(GroundFlow, GoesThroughLayersInSeries)
{
    // confined between the sides: the loss of head of every layer is as its thickness over its conductivity
    Rectangle box;
    box.size = {6.0, 2.0};
    box.columns = 12;
    box.rows = 4;
    box.conductivity = [](const Vector2& x) { return x.x() < 2.0 ? 1e-4 : 1e-6; };
    GroundFlowProblem problem = mesh_of(box);
    for (std::size_t i = 0; i < problem.water.size(); ++i) {
        const double x = problem.mesh.nodes[i].x();
        if (x > 0.0 && x < 6.0) continue;
        problem.water[i] = NodeWater::head;
        problem.given_head[i] = x > 0.0 ? 4.0 : 9.0;
    }
    const GroundFlow flow = solve_steady_flow(problem);
    ASSERT_TRUE(flow.converged);
    const double q = 5.0 / (2.0 / 1e-4 + 4.0 / 1e-6);
    EXPECT_NEAR(flow.discharge, 2.0 * q, 1e-10 * q);
    for (std::size_t i = 0; i < flow.head.size(); ++i) {
        const double x = problem.mesh.nodes[i].x();
        EXPECT_NEAR(flow.head[i], 9.0 - q * (std::min(x, 2.0) / 1e-4 + std::max(0.0, x - 2.0) / 1e-6), 1e-9);
    }
}

TEST(GroundFlow, FallsThroughSandBelowClay)
{
    // 1 m of water on 2 m of clay over 4 m of sand that drains: q = k (2 + 1) / 2, sand without pressure
    Rectangle box;
    box.size = {2.0, 6.0};
    box.columns = 4;
    box.rows = 24;
    box.conductivity = [](const Vector2& x) { return x.y() > 4.0 ? 1e-7 : 1e-4; };
    GroundFlowProblem problem = mesh_of(box);
    for (std::size_t i = 0; i < problem.water.size(); ++i) {
        const double y = problem.mesh.nodes[i].y();
        if (y == 6.0) problem.water[i] = NodeWater::head;
        if (y == 0.0) problem.water[i] = NodeWater::open;
        problem.given_head[i] = 7.0;
    }
    const GroundFlow flow = solve_steady_flow(problem);
    ASSERT_TRUE(flow.converged);
    EXPECT_NEAR(flow.discharge, 2.0 * 1e-7 * 1.5, 1e-8 * 1e-7);
    for (std::size_t i = 0; i < flow.head.size(); ++i) {
        const double y = problem.mesh.nodes[i].y();
        EXPECT_NEAR(flow.pressure_head[i], y > 4.0 ? 0.5 * (y - 4.0) : 0.0, 1e-7);
    }
}

TEST(FlowField, IsLinearInTheTriangles)
{
    Rectangle box;
    const GroundFlowProblem problem = mesh_of(box);
    const auto plane = [](const Vector2& x) { return 30.0 - 0.3 * x.x() + 0.1 * x.y(); };
    Scalars head;
    for (const Vector2& node : problem.mesh.nodes) head.push_back(plane(node));
    const FlowField field(problem.mesh, head);
    for (const Vector2& point : {Vector2(0.0, 0.0), Vector2(3.3, 7.1), Vector2(16.0, 24.0),
                                 Vector2(15.9, 0.01), Vector2(16.001, 5.0)}) // a little outside
        EXPECT_NEAR(field.head(point), plane(point), 1e-10);
    EXPECT_NEAR(*field.surface(4.0), plane({4.0, 24.0}), 1e-10) << "open water above the ground";
}

TEST(FlowField, FindsTheSurfaceInTheSoil)
{
    Rectangle box;
    const GroundFlowProblem problem = mesh_of(box);
    Scalars head;
    for (const Vector2& node : problem.mesh.nodes) head.push_back(18.5 - 0.25 * node.x());
    const FlowField field(problem.mesh, head);
    for (const double x : {0.0, 1.0, 5.5, 13.7, 16.0}) EXPECT_NEAR(*field.surface(x), 18.5 - 0.25 * x, 1e-10);
    for (double& value : head) value = -1.0;
    EXPECT_FALSE(FlowField(problem.mesh, head).surface(3.0)) << "no water";
}

} // namespace
} // namespace quicksand
