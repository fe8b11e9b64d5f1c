#include "solver/step/single_phase_step.hpp"
#include "solver/step/stepper.hpp"
#include "solver/step_length/time_step_control.hpp"
#include "solver/walls/wall_rows.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

using namespace fixtures;

/// Soil of 4 x 3 m on cells of 1 m, its corner at `corner`, everything a wall of one kind but the free top.
Problem box_at(const Vector2& corner, SoilCondition walls)
{
    Problem problem;
    problem.grid = {{-2.0, -2.0}, 1.0, 9, 8};
    problem.materials = {stiff_sand()};
    problem.boundaries =
        rectangle(corner.x(), corner.y(), corner.x() + 4.0, corner.y() + 3.0, walls, walls, FreeFace{});
    return problem;
}

TEST(WallChains, WallsOnGridLinesAreNone)
{
    EXPECT_TRUE(make_soil_edges(box_at({0.0, 0.0}, FixedWall{}), Stage::shaking).empty());
    const SoilEdges edges = make_soil_edges(box_at({0.3, 0.0}, FixedWall{}), Stage::shaking);
    EXPECT_EQ(edges.chains.size(), 2U); // the sides; base and top are other edges
    EXPECT_EQ(edges.others.size(), 2U);
}

TEST(WallChains, JoinSegmentsThatTurnLittleAndPartAtCorners)
{
    Problem problem = box_at({0.3, 0.3}, RollerWall{});
    problem.boundaries[0].segments = {{{0.3, 0.3}, {2.0, 0.0}}, {{2.0, 0.0}, {4.3, 0.3}}};
    const SoilEdges edges = make_soil_edges(problem, Stage::shaking);
    ASSERT_EQ(edges.chains.size(), 3U);
    EXPECT_EQ(edges.chains[0].edges.size(), 2U);
    EXPECT_FALSE(edges.chains[0].straight);
}

TEST(WallChains, HatsAddUpToOneEverywhere)
{
    Problem problem = box_at({0.3, 0.3}, FixedWall{});
    problem.boundaries[0].segments = {{{0.3, 0.3}, {2.0, 0.0}}, {{2.0, 0.0}, {4.3, 0.3}}};
    const SoilEdges edges = make_soil_edges(problem, Stage::shaking);
    EXPECT_EQ(edges.chains[0].line_axis, -1);
    EXPECT_EQ(edges.chains[1].line_axis, 1);
    for (const WallChain& chain : edges.chains) {
        for (double s = chain.first; s <= chain.last; s += 0.05) {
            double sum = 0.0;
            for_each_hat(chain, s, [&](std::size_t m, double value) {
                EXPECT_LT(m, chain.hats);
                EXPECT_GE(value, 0.0);
                sum += value;
            });
            EXPECT_NEAR(sum, 1.0, 1e-14);
        }
    }
}

TEST(WallChains, GoOnBeyondAFreeCornerAsFarAsTheGrid)
{
    const SoilEdges edges = make_soil_edges(box_at({0.3, 0.3}, FixedWall{}), Stage::shaking);
    const WallChain& right = edges.chains[1]; // upwards
    EXPECT_EQ(right.first, 0.0);
    EXPECT_GT(right.last, 5.0);
    const WallChain& base = edges.chains[0]; // its neighbours are walls
    EXPECT_EQ(base.first, 0.0);
    EXPECT_NEAR(base.last, 4.0, 1e-12);
}

TEST(WallChains, ARingHasNoEnds)
{
    Problem problem = box_at({0.0, 0.0}, FreeFace{});
    Boundary hole{"hole", FixedWall{}, Impervious{}, {}};
    constexpr int sides = 12;
    const auto corner = [](int k) {
        const double angle = -2.0 * std::numbers::pi * k / sides; // clockwise: the soil lies to the left
        return Vector2(2.0 + std::cos(angle), 1.5 + std::sin(angle));
    };
    for (int k = 0; k < sides; ++k) hole.segments.push_back({corner(k), corner(k + 1)});
    hole.segments.back().end = hole.segments.front().start;
    problem.boundaries.push_back(hole);
    const SoilEdges edges = make_soil_edges(problem, Stage::shaking);
    ASSERT_EQ(edges.chains.size(), 1U);
    EXPECT_TRUE(edges.chains[0].closed);
    const NodeConditions conditions = node_conditions(problem);
    const WallContacts contacts = find_contacts(problem, edges, conditions, Stage::shaking, {0.0, 0.1, 0.0});
    double length = 0.0;
    for (const WallContact& contact : contacts.walls) {
        length += contact.length;
        // the place along the ring is that beside the node, at its joint as well
        const double angle = -2.0 * std::numbers::pi * contact.s / edges.chains[0].last;
        const Vector2 place(2.0 + std::cos(angle), 1.5 + std::sin(angle));
        EXPECT_LT((problem.grid.node_position(contact.node) - place).norm(), 1.5);
    }
    EXPECT_NEAR(length, edges.chains[0].last, 1e-12);
}

TEST(WallContacts, NodesShareTheLengthOfTheWall)
{
    Problem problem = box_at({0.3, 0.3}, FixedWall{});
    problem.boundaries.resize(1);
    problem.boundaries[0].segments = {{{0.1, 0.2}, {4.3, 1.7}}};
    const NodeConditions conditions = node_conditions(problem);
    const SoilEdges edges = make_soil_edges(problem, Stage::shaking);
    ASSERT_EQ(edges.chains.size(), 1U);
    double length = 0.0, moment = 0.0;
    Vector2 centre = Vector2::Zero();
    for (const WallContact& contact :
         find_contacts(problem, edges, conditions, Stage::shaking, {0.0, 0.1, 0.0}).walls) {
        length += contact.length;
        moment += contact.length * contact.s;
        centre += contact.length * problem.grid.node_position(contact.node);
    }
    const WallChain& chain = edges.chains[0];
    const double whole = chain.last - chain.first;
    EXPECT_NEAR(length, whole, 1e-10);
    EXPECT_NEAR(moment / length, 0.5 * (chain.first + chain.last), 1e-10);
    const Segment front = chain.edges.front().drawn, back = chain.edges.back().drawn;
    EXPECT_LT((centre / length - 0.5 * (front.start + back.end)).norm(), 1e-9);
}

TEST(VelocityRows, HoldMeetsTheValuesAndProjectMeetsZero)
{
    VelocityRows rows;
    rows.clear(10);
    rows.begin_row(0.7);
    rows.add(3, {1.0, 0.5, 0.0, 0.0});
    rows.add(4, {0.2, 0.0, 0.3, 0.0});
    rows.begin_row(-0.1);
    rows.add(4, {0.0, 1.0, 0.0, 2.0});
    rows.add(7, {0.4, 0.0, 0.0, -1.0});
    NodeInverse inverse = NodeInverse::Identity();
    inverse(0, 2) = inverse(2, 0) = 0.3;
    rows.factorise({inverse, 2.0 * inverse, 0.1 * inverse});
    const std::vector<NodeVelocities> start = {
        {1.0, 2.0, 3.0, 4.0}, {-1.0, 0.0, 1.0, 0.5}, {0.3, 0.1, 0.0, 0.0}};
    const auto products = [](const std::vector<NodeVelocities>& v) {
        return Vector2(v[0][0] + 0.5 * v[0][1] + 0.2 * v[1][0] + 0.3 * v[1][2],
                       v[1][1] + 2.0 * v[1][3] + 0.4 * v[2][0] - v[2][3]);
    };
    std::vector<NodeVelocities> velocities = start;
    rows.hold(velocities);
    EXPECT_LT((products(velocities) - Vector2(0.7, -0.1)).norm(), 1e-14);
    velocities = start;
    rows.project(velocities);
    EXPECT_LT(products(velocities).norm(), 1e-14);
}

TEST(VelocityRows, RowsThatRepeatEachOtherAreAnsweredOnce)
{
    VelocityRows rows;
    rows.clear(1);
    for (int k = 0; k < 3; ++k) {
        rows.begin_row(0.5);
        rows.add(0, {1.0, 0.0, 0.0, 0.0});
    }
    rows.factorise({NodeInverse::Identity()});
    std::vector<NodeVelocities> velocities = {{2.0, 3.0, 0.0, 0.0}};
    rows.hold(velocities);
    EXPECT_NEAR(velocities[0][0], 0.5, 1e-12);
    EXPECT_EQ(velocities[0][1], 3.0);
}

/// A square of soil with corners at `centre` plus its half diagonals, turned by an angle; all edges of one
/// kind.
Problem turned_square(double angle, SoilCondition walls)
{
    Problem problem;
    problem.grid = {{-4.0, -4.0}, 0.5, 16, 16};
    problem.materials = {stiff_sand()};
    problem.gravity = 0.0;
    const Vector2 e1(std::cos(angle), std::sin(angle)), e2(-e1.y(), e1.x());
    const Vector2 a = -2.0 * e1 - 2.0 * e2, b = a + 4.0 * e1, c = b + 4.0 * e2, d = a + 4.0 * e2;
    const WaterCondition water = Impervious{};
    problem.boundaries = {{"base", walls, water, {{a, b}}},
                          {"right", walls, water, {{b, c}}},
                          {"top", walls, water, {{c, d}}},
                          {"left", walls, water, {{d, a}}}};
    return problem;
}

/// Domains along the sides of the square.
State fill_square(const Problem& problem, double angle, int cells)
{
    const double size = 4.0 / cells;
    const Vector2 e1(std::cos(angle), std::sin(angle)), e2(-e1.y(), e1.x());
    State state;
    Particles& particles = state.particles;
    resize_particles(problem, static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells), particles);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto i = static_cast<double>(p % static_cast<std::size_t>(cells)),
                   j = static_cast<double>(p / static_cast<std::size_t>(cells));
        particles.identifier[p] = static_cast<std::int32_t>(p);
        particles.position.set(p, (-2.0 + (i + 0.5) * size) * e1 + (-2.0 + (j + 0.5) * size) * e2);
        particles.half_edge_1.set(p, 0.5 * size * e1);
        particles.half_edge_2.set(p, 0.5 * size * e2);
        particles.volume[p] = size * size;
        particles.mass_solid[p] = 0.57 * 2650.0 * size * size;
        if (problem.water) particles.porosity[p] = 0.43;
    }
    begin_shaking(state);
    return state;
}

double fastest(const Particles& particles)
{
    double speed = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p)
        speed = std::max({speed, particles.velocity_solid[p].norm(), particles.velocity_fluid[p].norm()});
    return speed;
}

TEST(WallRows, AConstantPressureIsAtRestInATurnedBox)
{
    for (const double degrees : {0.0, 7.0, 30.0, 45.0}) {
        for (const TimeScheme scheme : {TimeScheme::explicit_steps, TimeScheme::semi_implicit}) {
            const double angle = degrees * std::numbers::pi / 180.0;
            Problem problem = turned_square(angle, RollerWall{});
            problem.water = water_to(-10.0);
            problem.scheme = scheme;
            State state = fill_square(problem, angle, 16);
            state.particles.pore_pressure.assign(state.particles.size(), 1e4);
            const auto stepper = make_stepper(problem);
            for (int step = 0; step < 300; ++step)
                stepper->advance(problem, stable_time_step(problem, state.particles).dt, state);
            double deviation = 0.0;
            for (const double p : state.particles.pore_pressure)
                deviation = std::max(deviation, std::abs(p / 1e4 - 1.0));
            EXPECT_LT(deviation, 1e-5) << degrees;
            // the sound of 1e4 Pa is a particle velocity of 6 mm/s
            EXPECT_LT(fastest(state.particles), 1e-7) << degrees;
        }
    }
}

/// A box of 4 x 3 m off the grid lines on a fixed base, with a right side that moves by this.
struct PushedBox {
    Problem problem = box_at({0.3, 0.3}, RollerWall{});
    State state;

    explicit PushedBox(const WallMotion& motion)
    {
        problem.gravity = 0.0;
        problem.boundaries[0].soil = FixedWall{};
        problem.boundaries[1].soil = MovingWall{motion};
        state = fill(problem, 10, [](const Vector2& x) {
            return x.x() > 0.3 && x.x() < 4.3 && x.y() > 0.3 && x.y() < 3.3;
        });
        begin_shaking(state);
    }
};

TEST(WallRows, OfAMovingWallAskForAMotionThatAFixedOneBesideItLeaves)
{
    constexpr double speed = 0.5;
    for (const WallMotion& motion :
         {WallMotion{MotionQuantity::velocity, WallGrip::rough, {-speed, 0.0}, 0.0, {}},
          WallMotion{MotionQuantity::velocity, WallGrip::smooth, {0.0, 0.0}, speed, {}}}) {
        PushedBox box(motion);
        SinglePhaseWorkspace work = make_single_phase_workspace(box.problem);
        locate_particles(box.problem, 1e-4, box.state, work);
        scatter_to_nodes(box.problem, 1e-4, box.state, work);
        assemble_walls(box.problem, 1e-4, work.sums, work);
        const VelocityRows& rows = work.walls.rows;
        std::vector<NodeVelocities> velocities(rows.nodes().size(), NodeVelocities::Zero());
        rows.hold(velocities);
        double fastest = 0.0, missed = 0.0, most = 0.0;
        for (const NodeVelocities& v : velocities) fastest = std::max(fastest, v.head<2>().norm());
        for (std::size_t r = 0; r < rows.size(); ++r) {
            missed = std::max(missed, std::abs(rows.product(r, velocities) - rows.value(r)));
            most = std::max(most, std::abs(rows.value(r)));
        }
        EXPECT_GT(most, 0.1 * speed);
        EXPECT_LT(missed, 1e-6 * speed); // not all of them, when they asked for the wall's velocity alone
        EXPECT_LT(fastest, 3.0 * speed); // 40 m/s then
    }
}

TEST(WallRows, OfAMovingWallBesideARollerAskForItsVelocity)
{
    const WallMotion motion{MotionQuantity::velocity, WallGrip::rough, {-0.5, 0.0}, 0.0, {}};
    PushedBox box(motion);
    box.problem.boundaries[0].soil = RollerWall{};
    SinglePhaseWorkspace work = make_single_phase_workspace(box.problem);
    locate_particles(box.problem, 1e-4, box.state, work);
    scatter_to_nodes(box.problem, 1e-4, box.state, work);
    assemble_walls(box.problem, 1e-4, work.sums, work);
    const VelocityRows& rows = work.walls.rows;
    const std::vector<NodeVelocities> velocities(rows.nodes().size(), {-0.5, 0.0, 0.0, 0.0});
    for (std::size_t r = 0; r < work.walls.chain_of_row.size(); ++r)
        if (work.walls.chain_moves[work.walls.chain_of_row[r]]) {
            EXPECT_NEAR(rows.product(r, velocities), rows.value(r), 1e-12);
        }
}

} // namespace
} // namespace quicksand
