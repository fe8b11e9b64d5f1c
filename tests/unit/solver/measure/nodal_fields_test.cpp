#include "solver/measure/nodal_fields.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace quicksand {

namespace {

/// Soil in 4 x 3 cells of 0.5 m.
struct Block {
    Problem problem;
    State state;

    Block()
    {
        problem.grid = {{1.0, 2.0}, 0.5, 4, 3};
        problem.materials = {fixtures::stiff_sand()};
        problem.strain = StrainForm::small;
        state = fixtures::fill(problem, 2, [](const Vector2&) { return true; });
    }

    double averaged_volume() const
    {
        const Scalars volume = nodal_fields(problem, state.particles).volume;
        return std::accumulate(volume.begin(), volume.end(), 0.0);
    }
};

} // namespace

TEST(NodalFields, LeaveOutNodesBeyondTheGrid)
{
    // displaced domains of small strain go wherever they please: beyond each side, by parts and altogether
    const Block whole;
    const double domain = 0.25 * 0.25;
    const double all = whole.averaged_volume();
    EXPECT_NEAR(all, 4 * 3 * 0.25, 1e-13);
    const BackgroundGrid& grid = whole.problem.grid;
    const Vector2 lower = grid.rim_origin(), upper = lower + 0.5 * Vector2(12, 11);
    struct Case {
        Vector2 place;
        double left; // of the domain's volume that is still counted
    };
    const Case cases[] = {
        {{lower.x(), 3.1}, 1.0 - 0.5 * 0.125 / 0.5},
        {{upper.x(), 3.1}, 1.0 - 0.5 * 0.125 / 0.5},
        {{2.1, lower.y() - 0.25}, 0.5},
        {{2.1, upper.y() + 0.25}, 0.5},
        {{lower.x() - 0.25, lower.y() - 0.25}, 0.25},
        {{lower.x() - 1.0, 3.0}, 0.0},
        {{2.0, upper.y() + 1.0}, 0.0},
        {{1e300, -1e300}, 0.0},
        {{std::nan(""), 3.0}, 0.0},
    };
    for (const Case& displaced : cases) {
        Block block;
        block.state.particles.position.set(5, displaced.place);
        EXPECT_NEAR(block.averaged_volume(), all - (1.0 - displaced.left) * domain, 1e-12)
            << displaced.place.transpose();
    }
}

} // namespace quicksand
