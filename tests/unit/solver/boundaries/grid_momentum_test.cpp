#include "solver/boundaries/grid_momentum.hpp"
#include "solver/boundaries/node_response.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

TEST(LocalDamping, OpposesTheMomentumAndFadesWithIt)
{
    const double dt = 0.1, force = -4.0;
    EXPECT_NEAR(local_damping(0.7, dt, force, 1e6), -0.7 * 4.0, 1e-5);
    EXPECT_NEAR(local_damping(0.7, dt, force, -1e6), 0.7 * 4.0, 1e-5);
    EXPECT_EQ(local_damping(0.7, dt, force, 0.1), -0.5 * 0.7 * 4.0); // a quarter of the force's impulse
    EXPECT_LT(std::abs(local_damping(0.7, dt, force, 1e-17)), 1e-15);
    EXPECT_EQ(local_damping(0.7, dt, 0.0, 0.0), 0.0);
}

TEST(SolveDrag, IsTheSolutionOfTheTwoByTwoSystem)
{
    const double m_s = 3.0, m_w = 0.7, b_s = 1.1, b_w = -0.4;
    for (const double dt_drag : {0.0, 1e-3, 1.0, 1e3}) {
        const PhaseVelocities v = solve_drag(m_s, m_w, dt_drag, b_s, b_w);
        EXPECT_NEAR((m_s + dt_drag) * v.solid - dt_drag * v.fluid, b_s, 1e-12 * (1.0 + dt_drag));
        EXPECT_NEAR(-dt_drag * v.solid + (m_w + dt_drag) * v.fluid, b_w, 1e-12 * (1.0 + dt_drag));
        EXPECT_NEAR(m_s * v.solid + m_w * v.fluid, b_s + b_w, 1e-14);
    }
}

TEST(SolveDrag, InfiniteDragMovesBothPhasesTogetherWithoutCancellation)
{
    const PhaseVelocities v = solve_drag(3.0, 0.7, 1e300, 1.1, -0.4);
    EXPECT_DOUBLE_EQ(v.solid, 0.7 / 3.7);
    EXPECT_DOUBLE_EQ(v.fluid, 0.7 / 3.7);
}

TEST(SolveDrag, ANodeWithoutWaterMovesAsTheGrains)
{
    const PhaseVelocities v = solve_drag(2.0, 0.0, 0.0, 1.0, 0.0);
    EXPECT_DOUBLE_EQ(v.solid, 0.5);
    EXPECT_DOUBLE_EQ(v.fluid, 0.5);
}

/// Relative velocity of water and grains after a step of `rate` times the time of their exchange, over that
/// before it; a force on the water besides that a relative velocity of `steady` balances.
double relative_velocity_left(double rate, double steady, double strong = explicit_strong_drag)
{
    const double m_s = 3.0, m_w = 0.7, dt = 0.1, reduced = m_s * m_w / (m_s + m_w),
                 drag = rate * reduced / dt;
    std::vector<TwoPhaseSums> sums(1);
    sums[0].mass_solid = m_s;
    sums[0].mass_fluid = m_w;
    sums[0].volume = 1.0;
    sums[0].momentum_fluid_x = m_w;
    sums[0].drag = sums[0].drag_1 = sums[0].drag_2 = drag;
    centre_drag(dt, strong, sums);
    const double known = dt * sums[0].drag_force_x, push = dt * drag * steady;
    const PhaseVelocities v = solve_drag(m_s, m_w, dt * sums[0].drag_1, known - push, m_w - known + push);
    EXPECT_NEAR(m_s * v.solid + m_w * v.fluid, m_w, 1e-14 * (1.0 + std::abs(push))) << "momentum";
    return v.fluid - v.solid;
}

TEST(CentreDrag, FollowsTheExponentialDecayInSecondOrderAndNeverSwings)
{
    for (const double strong : {explicit_strong_drag, semi_implicit_strong_drag}) {
        const auto error = [strong](double rate) {
            return std::abs(relative_velocity_left(rate, 0.0, strong) - std::exp(-rate));
        };
        EXPECT_LT(error(0.1), 1e-4); // of the third order in a step
        EXPECT_NEAR(error(0.1) / error(0.05), 8.0, 0.5);
    }
    for (const double rate : {2.0, 3.0, 1e3, 1e9})
        EXPECT_NEAR(relative_velocity_left(rate, 0.0), 0.0, 1e-12) << rate;
    for (const double rate : {1.0, 3.0, 1e3, 1e9})
        EXPECT_NEAR(relative_velocity_left(rate, 0.0, semi_implicit_strong_drag), 0.5 / (rate + 0.5), 1e-12)
            << rate;
}

TEST(CentreDrag, KeepsASteadySeepage)
{
    for (const double strong : {explicit_strong_drag, semi_implicit_strong_drag})
        for (const double rate : {1e-3, 1.0, 2.5, 1e6})
            EXPECT_NEAR(relative_velocity_left(rate, 1.0, strong), 1.0, 1e-9) << rate;
}

/// One node of a saturated problem and its velocities under given conditions.
TwoPhaseMotion solve_one(const Problem& problem, std::uint8_t conditions)
{
    std::vector<TwoPhaseSums> sums(1);
    sums[0].mass_solid = 1500.0;
    sums[0].mass_fluid = 430.0;
    sums[0].volume = 1.0;
    sums[0].momentum_solid_x = 30.0;
    sums[0].momentum_solid_y = -15.0;
    sums[0].momentum_fluid_x = 4.0;
    sums[0].momentum_fluid_y = 8.0;
    sums[0].drag = sums[0].drag_1 = sums[0].drag_2 = 2e6;
    std::vector<TwoPhaseMotion> motion(1);
    NodeConditions node_conditions;
    node_conditions.of_node = {conditions};
    solve_two_phase_momentum(problem, node_conditions, 1e-4, 0.0, sums, motion);
    return motion[0];
}

Problem weightless()
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0, 1, 1};
    problem.materials = {fixtures::stiff_sand()};
    problem.water = fixtures::water_to(1.0);
    problem.gravity = 0.0;
    return problem;
}

/// A node whose drag is 100 times as strong across layers that rise by 30 degrees as along them.
TwoPhaseSums node_of_slanted_layers()
{
    TwoPhaseSums node{};
    node.mass_solid = 1500.0;
    node.mass_fluid = 430.0;
    node.volume = 1.0;
    node.drag = 2e6;
    node.drag_1 = 1e5;
    node.drag_2 = 1e7;
    node.layer_x = 0.5 * std::sqrt(3.0);
    node.layer_y = 0.5;
    node.momentum_solid_x = 30.0;
    node.momentum_solid_y = -15.0;
    node.momentum_fluid_x = 4.0;
    node.momentum_fluid_y = 8.0;
    return node;
}

TEST(SlantedDrag, MovesANodeAsTheSameNodeInTheAxesOfItsLayers)
{
    const Problem problem = weightless();
    NodeConditions conditions;
    conditions.of_node = {0};
    const auto solve = [&](TwoPhaseSums node) {
        std::vector<TwoPhaseSums> sums{node};
        centre_drag(1e-4, semi_implicit_strong_drag, sums);
        std::vector<TwoPhaseMotion> motion(1);
        solve_two_phase_momentum(problem, conditions, 1e-4, 0.0, sums, motion);
        return motion[0];
    };
    const TwoPhaseSums node = node_of_slanted_layers();
    TwoPhaseSums turned = node;
    turned.layer_x = 1.0;
    turned.layer_y = 0.0;
    const Vector2 solid = along_layers(node, {node.momentum_solid_x, node.momentum_solid_y}),
                  fluid = along_layers(node, {node.momentum_fluid_x, node.momentum_fluid_y});
    turned.momentum_solid_x = solid.x(), turned.momentum_solid_y = solid.y();
    turned.momentum_fluid_x = fluid.x(), turned.momentum_fluid_y = fluid.y();
    const TwoPhaseMotion a = solve(node), b = solve(turned);
    const Vector2 of_solid = along_grid(node, {b.solid_x, b.solid_y}),
                  of_fluid = along_grid(node, {b.fluid_x, b.fluid_y});
    EXPECT_NEAR(a.solid_x, of_solid.x(), 1e-15);
    EXPECT_NEAR(a.solid_y, of_solid.y(), 1e-15);
    EXPECT_NEAR(a.fluid_x, of_fluid.x(), 1e-15);
    EXPECT_NEAR(a.fluid_y, of_fluid.y(), 1e-15);
}

TEST(SlantedDrag, HasResponsesAndCompliancesOfItsTensor)
{
    const double dt = 1e-4;
    const Problem problem = weightless();
    const TwoPhaseSums node = node_of_slanted_layers();
    const Eigen::Matrix2d drag = dt * drag_tensor(node), unit = Eigen::Matrix2d::Identity();
    Eigen::Matrix4d masses;
    masses << node.mass_solid * unit + drag, -drag, -drag, node.mass_fluid * unit + drag;
    const NodeResponses r = responses(node, dt, 0);
    Eigen::Matrix4d inverse;
    inverse << r.solid, r.exchange, r.exchange, r.fluid;
    EXPECT_LT((inverse * masses - Eigen::Matrix4d::Identity()).norm(), 1e-11);

    NodeConditions conditions;
    conditions.of_node = {0};
    NodeCompliances compliances;
    set_pressure_compliances(problem, conditions, dt, {node}, compliances);
    const double n = node_porosity(problem, node);
    const Eigen::Matrix2d flux =
        (1.0 - n) * (1.0 - n) * r.solid + 2.0 * n * (1.0 - n) * r.exchange + n * n * r.fluid;
    EXPECT_NEAR(compliances.xx[0], flux(0, 0), 1e-16);
    EXPECT_NEAR(compliances.xy[0], flux(0, 1), 1e-16);
    EXPECT_NEAR(compliances.yy[0], flux(1, 1), 1e-16);
}

TEST(NodeConditions, AHeldSkeletonStillDragsTheWater)
{
    const TwoPhaseMotion v = solve_one(weightless(), solid_x_fixed);
    EXPECT_EQ(v.solid_x, 0.0);
    EXPECT_NEAR(v.fluid_x, 4.0 / (430.0 + 1e-4 * 2e6), 1e-15);
    EXPECT_NE(v.solid_y, 0.0);
}

TEST(NodeConditions, ASealMovesBothPhasesTogether)
{
    const TwoPhaseMotion v = solve_one(weightless(), seal_y);
    EXPECT_DOUBLE_EQ(v.solid_y, (8.0 - 15.0) / 1930.0);
    EXPECT_DOUBLE_EQ(v.fluid_y, v.solid_y);
    EXPECT_NE(v.fluid_x, v.solid_x);
}

TEST(NodeConditions, ASealHoldsTheWaterOfHeldGrains)
{
    const TwoPhaseMotion v = solve_one(weightless(), solid_y_fixed | seal_y);
    EXPECT_EQ(v.solid_y, 0.0);
    EXPECT_EQ(v.fluid_y, 0.0);
}

TEST(Submerged, GrainsCarryTheirBuoyantWeightAndWaterNone)
{
    Problem problem = weightless();
    problem.gravity = 10.0;
    const TwoPhaseMotion with = solve_one(problem, 0), without = solve_one(weightless(), 0);
    // m (v_s + v_w) changes by the buoyant weight (1500 + 430 - 1000) g dt in all
    const double change =
        1500.0 * (with.solid_y - without.solid_y) + 430.0 * (with.fluid_y - without.fluid_y);
    EXPECT_NEAR(change, -930.0 * 10.0 * 1e-4, 1e-12);
}

} // namespace
} // namespace quicksand
