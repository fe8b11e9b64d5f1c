#include "solver/drag/layered_drag.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace quicksand {
namespace {

/// Saturated sands with these conductivities [m/s].
LayeredDrag drag_of(const std::vector<double>& conductivities)
{
    Problem problem;
    problem.water = fixtures::water_to(1.0);
    for (const double k : conductivities) {
        problem.materials.push_back(fixtures::stiff_sand());
        problem.materials.back().hydraulic_conductivity = k;
    }
    return make_layered_drag(problem);
}

TEST(LayeredDrag, TakesSoilsOfNearlyTheSameConductivityForOne)
{
    EXPECT_FALSE(drag_of({1e-4}).any());
    EXPECT_FALSE(drag_of({1e-4, 1.05e-4, 0.95e-4}).any());
    const LayeredDrag two = drag_of({1e-4, 1e-7, 1.05e-4});
    ASSERT_TRUE(two.any());
    EXPECT_EQ(two.kind_of_material[0], two.kind_of_material[2]);
    EXPECT_NE(two.kind_of_material[0], two.kind_of_material[1]);
}

TEST(LayeredDrag, LeavesSoilWithoutWaterAndSolidsOut)
{
    Problem problem;
    problem.water = fixtures::water_to(1.0);
    problem.materials.assign(3, fixtures::stiff_sand());
    problem.materials[1].saturated = false;
    problem.materials[1].hydraulic_conductivity = 1e-7;
    problem.materials[2].has_pores = false;
    EXPECT_FALSE(make_layered_drag(problem).any());
}

} // namespace
} // namespace quicksand
