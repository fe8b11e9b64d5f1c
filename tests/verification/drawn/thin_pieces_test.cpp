// Level ground whose surface cuts thin pieces off the boxes: one column of it stands for all.
#include "solver/measure/monitors.hpp"
#include "solver/run/staged_run.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {
namespace {

using namespace fixtures;

/// The ground's state after a cycle of shaking, computed from all columns of cells or from one.
State shaken(const AssembledCase& ground, ColumnsComputed columns)
{
    StagedRun run(ground.problem, ground.state, {0.05, columns, true});
    EXPECT_EQ(run.column() != nullptr, columns == ColumnsComputed::one) << run.obstacle();
    run.begin_shaking();
    EXPECT_TRUE(run.shake({}));
    return run.state_of_body();
}

TEST(ThinPieces, OfOneColumnAreCarriedAsThoseOfAll)
{
    const std::vector<NamedCorner> corners = {
        {{0.0, 0.0}, "base"}, {{4.0, 0.0}, "right"}, {{4.0, 2.01}, "surface"}, {{0.0, 2.01}, "left"}};
    const std::string walls = R"([boundaries.base]
soil = "fixed"
[boundaries.left]
soil = "tied"
tied_to = "right"
[boundaries.right]
soil = "tied"
tied_to = "left"
[sampling]
particles_per_cell = [3, 3]
[motion]
kind = "sine"
amplitude = "0.1 g"
frequency = "20 Hz"
)";
    const AssembledCase ground =
        assemble(scene_with(0.5, {0.0, 0.0}, 8, 6, elastic + walls), polygon_section(corners));
    ASSERT_FALSE(ground.problem.cut_domains.slivers.empty());
    const State all = shaken(ground, ColumnsComputed::all), one = shaken(ground, ColumnsComputed::one);
    const double fallen = monitor(ground.problem, all, {}).max_displacement;
    EXPECT_GT(fallen, 1e-6);
    double apart = 0.0;
    for (std::size_t p = 0; p < all.particles.size(); ++p) {
        for (std::size_t q = 0; q < one.particles.size(); ++q)
            if (one.particles.identifier[q] == all.particles.identifier[p])
                apart = std::max(apart, (one.particles.position[q] - all.particles.position[p]).norm());
    }
    EXPECT_LT(apart, 1e-9 * fallen + 1e-14);
}

} // namespace
} // namespace quicksand
