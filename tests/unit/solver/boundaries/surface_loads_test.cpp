// Loads on boundary curves: exact totals and moments, whatever the sampling and the interpolation.
#include "solver/boundaries/outer_forces.hpp"
#include "solver/boundaries/surface_loads.hpp"
#include "solver/step/single_phase_step.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr std::array family = {Interpolation::linear, Interpolation::gimp, Interpolation::cpgimp,
                               Interpolation::cpdi, Interpolation::cpdi2};

/// A free block of 0.4 x 0.3 m in the middle of 0.1 m cells, its outline split into four curves.
Problem loaded_block(const SurfaceLoad& load)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.1, 12, 11};
    problem.materials = {stiff_sand()};
    problem.gravity = 0.0;
    problem.boundaries = rectangle(0.4, 0.4, 0.8, 0.7, FreeFace{}, FreeFace{}, FreeFace{});
    for (Boundary& boundary : problem.boundaries) boundary.soil = FreeFace{load};
    return problem;
}

bool in_block(const Vector2& x)
{
    return x.x() > 0.4 && x.x() < 0.8 && x.y() > 0.4 && x.y() < 0.7;
}

struct Resultant {
    Vector2 force = Vector2::Zero();
    double moment = 0.0; // about the origin
};

Resultant resultant(const Problem& problem, const std::vector<SinglePhaseSums>& sums)
{
    Resultant result;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const Vector2 x = problem.grid.node_position(i), f(sums[i].stress_force_x, sums[i].stress_force_y);
        result.force += f;
        result.moment += x.x() * f.y() - x.y() * f.x();
    }
    return result;
}

/// The nodes with the forces of all loads.
std::vector<SinglePhaseSums> loaded_nodes(const Problem& problem, double time, const Particles& particles,
                                          ParticlePlaces& places)
{
    std::vector<SinglePhaseSums> sums(problem.grid.node_count());
    std::vector<NodalForce> forces;
    add_surface_loads(problem, time, particles, places, forces);
    add_outer_forces(forces, sums);
    return sums;
}

Resultant scattered(const Problem& problem, const Particles& particles, double time = 0.0)
{
    ParticlePlaces places;
    return resultant(problem, loaded_nodes(problem, time, particles, places));
}

/// Turn and stretch the particles about the block's middle by the gradient F.
void deform(const Eigen::Matrix2d& F, Particles& particles)
{
    const Vector2 middle(0.6, 0.55);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        particles.position.set(p, middle + F * (particles.position[p] - middle));
        particles.half_edge_1.set(p, F * particles.half_edge_1[p]);
        particles.half_edge_2.set(p, F * particles.half_edge_2[p]);
    }
}

TEST(BoundaryPieces, OfAStraightEdgeAreTheEdgesOfTheDomainsBesideIt)
{
    Problem problem = loaded_block({{0.0, -1.0}, 0.0, {}});
    const State state = fill(problem, 3, in_block);
    EXPECT_TRUE(attach_boundaries(problem, state.particles).empty());
    const Boundary& top = problem.boundaries[2];
    ASSERT_EQ(top.pieces.size(), 12U);
    for (const BoundaryPiece& piece : top.pieces) {
        EXPECT_NEAR(piece.length, 0.1 / 3.0, 1e-15);
        EXPECT_LT((piece.start - Vector2(1.0, 1.0)).norm(), 1e-12); // the top runs to the left
        EXPECT_LT((piece.end - Vector2(-1.0, 1.0)).norm(), 1e-12);
    }
}

TEST(BoundaryPieces, AreFoundForLoadedCurvesAlone)
{
    Problem problem = loaded_block({{0.0, -1.0}, 0.0, {}});
    problem.boundaries[0].soil = FreeFace{};
    attach_boundaries(problem, fill(problem, 2, in_block).particles);
    EXPECT_TRUE(problem.boundaries[0].pieces.empty());
    EXPECT_FALSE(problem.boundaries[1].pieces.empty());
}

TEST(BoundaryPieces, NameCurvesWithoutSoilBesideThem)
{
    Problem problem = loaded_block({{0.0, -1.0}, 0.0, {}});
    problem.boundaries[1].segments = {{{1.1, 0.4}, {1.1, 0.7}}};
    EXPECT_EQ(attach_boundaries(problem, fill(problem, 2, in_block).particles),
              std::vector<std::string>{"right"});
}

TEST(SurfaceLoads, HaveTheExactTotalForEveryInterpolation)
{
    for (const Interpolation member : family) {
        Problem problem = loaded_block({{300.0, -1000.0}, 0.0, {}});
        problem.interpolation = member;
        for (std::size_t side : {0U, 1U, 3U}) problem.boundaries[side].soil = FreeFace{};
        State state = fill(problem, 3, in_block);
        attach_boundaries(problem, state.particles);
        const Resultant result = scattered(problem, state.particles);
        EXPECT_NEAR(result.force.x(), 120.0, 1e-11);
        EXPECT_NEAR(result.force.y(), -400.0, 1e-11);
        // at the middle of the top edge
        EXPECT_NEAR(result.moment, 0.6 * -400.0 - 0.7 * 120.0, 1e-11);
        const Vector2 total = full_load(problem, state, problem.boundaries[2]);
        EXPECT_LT((total - Vector2(120.0, -400.0)).norm(), 1e-11);
    }
}

TEST(SurfaceLoads, PressureAllAroundATurnedAndStretchedBlockHasNoForceAndNoMoment)
{
    Problem problem = loaded_block({{0.0, 0.0}, 1000.0, {}});
    State state = fill(problem, 3, in_block);
    attach_boundaries(problem, state.particles);
    Eigen::Matrix2d F;
    F << 0.8, -0.7, 0.65, 0.9; // turned by about 40 degrees, stretched and sheared
    deform(F, state.particles);
    for (const Interpolation member : {Interpolation::cpdi, Interpolation::cpdi2}) {
        problem.interpolation = member;
        const Resultant result = scattered(problem, state.particles);
        EXPECT_LT(result.force.norm(), 1e-11); // of 1400 N/m around
        EXPECT_LT(std::abs(result.moment), 1e-11);
    }
}

TEST(SurfaceLoads, PressureActsAlongTheTurnedNormalOnTheStretchedEdge)
{
    Problem problem = loaded_block({{0.0, 0.0}, 1000.0, {}});
    for (std::size_t side : {0U, 1U, 3U}) problem.boundaries[side].soil = FreeFace{};
    State state = fill(problem, 2, in_block);
    attach_boundaries(problem, state.particles);
    Eigen::Matrix2d F;
    F << 0.0, -1.0, 1.5, 0.0; // a quarter turn to the left, the top stretched to 0.6 m
    deform(F, state.particles);
    const Vector2 total = full_load(problem, state, problem.boundaries[2]);
    EXPECT_LT((total - Vector2(1000.0 * 0.6, 0.0)).norm(), 1e-10); // the top looks to the left now
}

TEST(SurfaceLoads, TractionKeepsDirectionAndTotal)
{
    Problem problem = loaded_block({{0.0, -1000.0}, 0.0, {}});
    for (std::size_t side : {0U, 1U, 3U}) problem.boundaries[side].soil = FreeFace{};
    State state = fill(problem, 2, in_block);
    attach_boundaries(problem, state.particles);
    Eigen::Matrix2d F;
    F << 0.0, -1.0, 1.5, 0.0;
    deform(F, state.particles);
    EXPECT_LT((scattered(problem, state.particles).force - Vector2(0.0, -400.0)).norm(), 1e-11);
}

TEST(SurfaceLoads, BalanceTheUniformStressOfAPressureAtEveryNode)
{
    for (const Interpolation member : family) {
        Problem problem = loaded_block({{0.0, 0.0}, 1000.0, {}});
        problem.interpolation = member;
        State state = fill(problem, 3, in_block);
        attach_boundaries(problem, state.particles);
        Particles& particles = state.particles;
        std::fill(particles.stress.xx.begin(), particles.stress.xx.end(), -1000.0);
        std::fill(particles.stress.yy.begin(), particles.stress.yy.end(), -1000.0);
        SinglePhaseWorkspace work = make_single_phase_workspace(problem);
        update_cell_lists(problem.grid, particles, work.lists);
        scatter_to_nodes(problem, 0.0, state, work);
        for (const SinglePhaseSums& node : work.sums) {
            EXPECT_NEAR(node.stress_force_x, 0.0, 1e-9); // of 100 N/m on a cell's edge
            EXPECT_NEAR(node.stress_force_y, 0.0, 1e-9);
        }
    }
}

TEST(SurfaceLoads, OnASlopeThroughTheLatticeHaveTheExactTotalAndMoment)
{
    Problem problem = loaded_block({{0.0, 0.0}, 1000.0, {}});
    const Vector2 foot(1.0, 0.2), crest(0.3, 0.93);
    problem.boundaries.resize(1);
    problem.boundaries[0].segments = {{foot, crest}};
    const Vector2 along = (crest - foot).normalized();
    State state = fill(problem, 3, [&](const Vector2& x) {
        const Vector2 from = x - foot;
        return x.y() > 0.2 && x.x() > 0.3 && along.x() * from.y() - along.y() * from.x() > 0.0;
    });
    attach_boundaries(problem, state.particles);
    double length = 0.0;
    for (const BoundaryPiece& piece : problem.boundaries[0].pieces) {
        length += piece.length;
        // carried by domains at the slope: no piece is farther from its domain than a stair
        EXPECT_LT(piece.start.cwiseAbs().maxCoeff(), 3.0);
    }
    EXPECT_GE(problem.boundaries[0].pieces.size(), 20U); // one a stair or more
    EXPECT_NEAR(length, (crest - foot).norm(), 1e-14);
    const Resultant result = scattered(problem, state.particles);
    const Vector2 force = -1000.0 * Vector2(crest.y() - foot.y(), foot.x() - crest.x());
    const Vector2 middle = 0.5 * (foot + crest);
    EXPECT_LT((result.force - force).norm(), 1e-10);
    EXPECT_NEAR(result.moment, middle.x() * force.y() - middle.y() * force.x(), 1e-10);
}

TEST(SurfaceLoads, FollowTheParticlesWhenTheArraysAreReordered)
{
    Problem problem = loaded_block({{200.0, 0.0}, 1000.0, {}});
    State state = fill(problem, 3, in_block);
    attach_boundaries(problem, state.particles);
    ParticlePlaces places;
    const std::vector<SinglePhaseSums> before = loaded_nodes(problem, 0.0, state.particles, places);
    std::vector<std::int32_t> order(state.particles.size());
    std::iota(order.rbegin(), order.rend(), 0);
    reorder(state.particles, order);
    const std::vector<SinglePhaseSums> after = loaded_nodes(problem, 0.0, state.particles, places);
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(before[i].stress_force_x, after[i].stress_force_x);
        EXPECT_EQ(before[i].stress_force_y, after[i].stress_force_y);
    }
}

TEST(SurfaceLoads, StandStillInTheirHistoryWhileTheSoilSettles)
{
    State state;
    state.time = 3.0;
    state.stage = Stage::relaxation;
    EXPECT_EQ(load_time(state), 0.0);
    state.stage = Stage::shaking;
    EXPECT_EQ(load_time(state), 3.0);
}

} // namespace
} // namespace quicksand
