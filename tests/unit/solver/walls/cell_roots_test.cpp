#include "solver/motion/particle_order.hpp"
#include "solver/walls/cell_roots.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double h = 0.5; // cell size [m]

/// Soil of 2 x 2 particles a cell up to 1 m where its cells are full; above lies what `upper` chooses.
struct Soil {
    Problem problem;
    State state;
    CellLists lists;
    NodeConditions conditions;
    CellRoots roots;

    explicit Soil(const std::function<bool(const Vector2&)>& upper)
    {
        problem.grid = {{0.0, 0.0}, h, 4, 5};
        problem.materials = {stiff_sand()};
        state = fill(problem, 2, [&](const Vector2& x) { return x.y() < 1.0 || upper(x); });
        lists = make_cell_lists(problem.grid);
        conditions = node_conditions(problem, Stage::shaking);
        update();
    }

    void update()
    {
        sort_particles(problem.grid, 0.0, state, lists);
        find_roots(problem, conditions, lists, state.particles, {}, roots);
    }

    /// The slot of a cell of the scene's grid.
    std::int32_t slot(int i, int j) const
    {
        const int cell =
            (j + BackgroundGrid::ghost_cells) * problem.grid.all_cells_x() + i + BackgroundGrid::ghost_cells;
        return lists.slot_of_cell[static_cast<std::size_t>(cell)];
    }
    std::size_t node(int i, int j) const
    {
        return problem.grid.node_index(i + BackgroundGrid::ghost_cells, j + BackgroundGrid::ghost_cells);
    }
    std::vector<FollowedNode> followed_by(std::size_t k) const
    {
        std::vector<FollowedNode> followed;
        follow(problem.grid, roots, k, followed);
        return followed;
    }
};

TEST(CellRoots, OfABadlyFilledCellIsTheGoodOneBesideIt)
{
    // one particle of four in the cell (1, 2)
    const Soil soil([](const Vector2& x) { return x.x() > 0.5 && x.x() < 0.75 && x.y() < 1.25; });
    const std::vector<AggregatedCell> expected = {{soil.slot(1, 2), soil.slot(1, 1)}};
    EXPECT_EQ(soil.roots.aggregated, expected);
}

TEST(CellRoots, RoundingDoesNotDecideWhichCellsAreGood)
{
    Soil soil([](const Vector2& x) { return x.y() < 1.25; }); // half a layer
    for (double& volume : soil.state.particles.volume) volume *= 0.8 * (1.0 - 1e-12);
    soil.update();
    EXPECT_TRUE(soil.roots.aggregated.empty()); // cells 0.4 full but for rounding
    for (double& volume : soil.state.particles.volume) volume *= 0.99;
    soil.update();
    EXPECT_EQ(soil.roots.aggregated.size(), 4U);
}

TEST(CellRoots, OfEquallyNearCellsIsTheFullestAndThenTheOneNearestToTheSoil)
{
    // soil of the cell (1, 3) with (0, 3) and (2, 3) full beside it, and nothing below
    const auto beside = [](const Vector2& x) {
        const bool full = x.y() > 1.5 && x.y() < 2.0 && (x.x() < 0.5 || (x.x() > 1.0 && x.x() < 1.5));
        return full || (x.y() > 1.75 && x.y() < 2.0 && x.x() > 0.75 && x.x() < 1.0);
    };
    Soil soil(beside);
    ASSERT_EQ(soil.roots.aggregated.size(), 1U);
    EXPECT_EQ(soil.roots.aggregated[0].root, soil.slot(2, 3));
    for (std::size_t p = 0; p < soil.state.particles.size(); ++p) // the right one looser
        if (soil.state.particles.position.x[p] > 1.0) soil.state.particles.volume[p] *= 0.9;
    soil.update();
    EXPECT_EQ(soil.roots.aggregated[0].root, soil.slot(0, 3));
}

TEST(CellRoots, AFewPerMilleOfVolumeDoNotTurnThem)
{
    // two full cells side by side below a third that is nearly empty, whose node (2, 3) both are near
    Soil soil([](const Vector2& x) { return x.x() > 0.75 && x.x() < 1.25 && x.y() < 1.25; });
    const auto followed = [&](double right) {
        for (std::size_t p = 0; p < soil.state.particles.size(); ++p)
            soil.state.particles.volume[p] =
                0.0625 * (soil.state.particles.position.x[p] > 1.0 ? right : 1.0);
        soil.update();
        return soil.followed_by(soil.node(2, 3)).size();
    };
    const std::size_t both = followed(1.0);
    EXPECT_EQ(followed(1.003), both);
    EXPECT_EQ(followed(0.997), both);
    EXPECT_LT(followed(1.1), both);
}

/// Four cells beside each other, of which the first is full; above them a floating particle, or none.
struct ThinSoil {
    Problem problem;
    State state;
    CellLists lists;
    NodeConditions conditions;
    CellRoots roots;

    explicit ThinSoil(double floating)
    {
        problem.grid = {{0.0, 0.0}, h, 8, 3};
        problem.materials = {stiff_sand()};
        state = fill(problem, 2, [&](const Vector2& x) {
            const bool thin = x.y() < 0.25 && x.x() < 3.0;
            return (x.x() < 0.5 && x.y() < 0.5) || thin || (x.y() < 0.25 && x.x() > floating);
        });
        for (std::size_t p = 0; p < state.particles.size(); ++p)
            if (state.particles.position.x[p] > 0.5) state.particles.volume[p] *= 0.5;
        lists = make_cell_lists(problem.grid);
        conditions = node_conditions(problem, Stage::shaking);
        sort_particles(problem.grid, 0.0, state, lists);
        find_roots(problem, conditions, lists, state.particles, {}, roots);
    }
};

TEST(CellRoots, OfATipIsTheFirstGoodCellOnTheWayThroughTheSoil)
{
    const ThinSoil soil(9.0);
    ASSERT_EQ(soil.roots.aggregated.size(), 5U); // up to five cells away
    for (const AggregatedCell& cell : soil.roots.aggregated)
        EXPECT_EQ(cell.root, soil.roots.aggregated[0].root);
    std::vector<FollowedNode> followed; // the node (6, 0) at the tip
    const int ghost = BackgroundGrid::ghost_cells;
    follow(soil.problem.grid, soil.roots, soil.problem.grid.node_index(6 + ghost, ghost), followed);
    double sum = 0.0;
    for (const FollowedNode& other : followed) sum += other.weight;
    EXPECT_NEAR(sum, 1.0, 1e-15);
}

TEST(CellRoots, SoilThatLiesApartHasNone)
{
    const ThinSoil soil(3.5); // a cell is empty between the tip and this soil
    EXPECT_EQ(soil.roots.aggregated.size(), 5U);
}

TEST(CellRoots, FollowersContinueTheGoodCellLinearly)
{
    const Soil soil([](const Vector2& x) { return x.x() > 0.5 && x.x() < 0.75 && x.y() < 1.25; });
    const auto linear = [](const Vector2& x) { return 0.3 + 2.0 * x.x() - 0.7 * x.y(); };
    for (const std::size_t k : {soil.node(1, 3), soil.node(2, 3)}) {
        EXPECT_TRUE(std::binary_search(soil.roots.followers.begin(), soil.roots.followers.end(), k));
        double sum = 0.0;
        for (const FollowedNode& followed : soil.followed_by(k)) {
            const int column = static_cast<int>(followed.node) % soil.problem.grid.nodes_x();
            const int row = static_cast<int>(followed.node) / soil.problem.grid.nodes_x();
            sum += followed.weight * linear(soil.problem.grid.node_position(column, row));
        }
        const int column = static_cast<int>(k) % soil.problem.grid.nodes_x();
        const int row = static_cast<int>(k) / soil.problem.grid.nodes_x();
        EXPECT_NEAR(sum, linear(soil.problem.grid.node_position(column, row)), 1e-13);
    }
}

TEST(CellRoots, FollowersOfTornSoilMoveAsTheNearestCorner)
{
    Soil soil([](const Vector2& x) { return x.x() > 0.5 && x.x() < 0.75 && x.y() < 1.25; });
    const auto tear = [&](double factor) {
        soil.state.particles.volume.back() = factor * 0.25 * h * h;
        soil.update();
    };
    tear(1.5);
    EXPECT_GT(soil.followed_by(soil.node(1, 3)).size(), 1U); // elastic soil does not tear
    soil.problem.materials[0].law =
        MohrCoulomb{.shear_modulus = 1e6, .poisson_ratio = 0.3, .friction_angle = 0.5};
    tear(1.1);
    EXPECT_GT(soil.followed_by(soil.node(1, 3)).size(), 1U);
    tear(1.5);
    const std::vector<FollowedNode> followed = soil.followed_by(soil.node(1, 3));
    double sum = 0.0;
    for (const FollowedNode& other : followed) {
        EXPECT_TRUE(other.node == soil.node(1, 2) || other.node == soil.node(0, 2) ||
                    other.node == soil.node(2, 2));
        EXPECT_GT(other.weight, 0.0);
        sum += other.weight;
    }
    EXPECT_DOUBLE_EQ(sum, 1.0);
    EXPECT_EQ(soil.roots.aggregated.size(), 1U); // its pressure is still that of its root
}

TEST(CellRoots, CornersOfGoodCellsFollowNothing)
{
    const Soil soil([](const Vector2& x) { return x.x() > 0.5 && x.x() < 0.75 && x.y() < 1.25; });
    for (int i = 0; i <= 4; ++i)
        for (int j = 0; j <= 2; ++j)
            EXPECT_FALSE(std::binary_search(soil.roots.followers.begin(), soil.roots.followers.end(),
                                            soil.node(i, j)));
}

TEST(CellRoots, MergedListsHoldEveryParticleOnceAndFollowTheCells)
{
    Soil soil([](const Vector2& x) { return x.x() > 0.5 && x.x() < 0.75 && x.y() < 1.25; });
    AggregatedLists merged;
    const auto count_in = [&](std::int32_t slot) {
        const auto s = static_cast<std::size_t>(slot);
        return merged.lists.cell_start[s + 1] - merged.lists.cell_start[s];
    };
    aggregate_cells(soil.lists, soil.roots.aggregated, merged);
    EXPECT_EQ(count_in(soil.slot(1, 2)), 0);
    EXPECT_EQ(count_in(soil.slot(1, 1)), 5);
    std::vector<std::int32_t> particles = merged.lists.order;
    std::sort(particles.begin(), particles.end());
    for (std::size_t p = 0; p < particles.size(); ++p) EXPECT_EQ(particles[p], static_cast<std::int32_t>(p));

    // the lonely particle moves over the next cell
    soil.state.particles.position.x.back() += 0.5;
    soil.update();
    aggregate_cells(soil.lists, soil.roots.aggregated, merged);
    EXPECT_EQ(count_in(soil.slot(1, 1)), 4);
    EXPECT_EQ(count_in(soil.slot(2, 1)), 5);
}

} // namespace
} // namespace quicksand
