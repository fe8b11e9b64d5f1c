// What the study of a slope reads off a problem, and which problems it refuses.
#include "solver/base/failure.hpp"
#include "solver/verification/studies/griffiths_lane_study.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

Problem drawn_slope()
{
    Problem problem;
    problem.grid = {{0.0, -5.0}, 0.5, 90, 31};
    Material soil;
    soil.law = MohrCoulomb{4e7, 0.3, 10e3, 0.35, 0.0};
    soil.porosity = 0.25;
    soil.grain_density = 2000.0;
    problem.materials = {soil};
    const auto curve = [](const char* name, SoilCondition condition, Vector2 start, Vector2 end) {
        Boundary boundary;
        boundary.name = name;
        boundary.soil = condition;
        boundary.segments = {{start, end}};
        return boundary;
    };
    problem.boundaries = {curve("base", FixedWall{}, {0.0, -5.0}, {45.0, -5.0}),
                          curve("face", FreeFace{}, {30.0, 10.0}, {10.0, 0.0}),
                          curve("crest", FreeFace{}, {45.0, 10.0}, {30.0, 10.0})};
    return problem;
}

TEST(GriffithsLaneStudy, ReadsTheSlopeOffTheProblem)
{
    const HomogeneousSlope slope = slope_of(drawn_slope());
    EXPECT_DOUBLE_EQ(slope.height, 10.0);
    EXPECT_DOUBLE_EQ(slope.run, 2.0);
    EXPECT_DOUBLE_EQ(slope.depth_factor, 1.5);
    EXPECT_DOUBLE_EQ(slope.unit_weight, 0.75 * 2000.0 * standard_gravity);
    EXPECT_DOUBLE_EQ(slope.cohesion, 10e3);
    EXPECT_DOUBLE_EQ(slope.friction_angle, 0.35);
}

TEST(GriffithsLaneStudy, RefusesOtherProblems)
{
    Problem elastic = drawn_slope();
    elastic.materials[0].law = LinearElastic{1e7, 0.3};
    EXPECT_THROW(slope_of(elastic), InputError);
    Problem level = drawn_slope();
    level.boundaries.erase(level.boundaries.begin() + 1);
    EXPECT_THROW(slope_of(level), InputError);
    Problem twice = drawn_slope();
    twice.boundaries.push_back(twice.boundaries[1]);
    try {
        slope_of(twice);
        ADD_FAILURE() << "two faces";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "the slope has more than one inclined free face");
    }
    Problem floating = drawn_slope();
    floating.boundaries.erase(floating.boundaries.begin());
    EXPECT_THROW(slope_of(floating), InputError);
}

} // namespace
} // namespace quicksand
