#include "solver/motion/slivers.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace quicksand {
namespace {

using namespace fixtures;

/// Boxes of 0.25 m, of which number 5 is cut to a piece of `fraction` of itself, in one corner of its box.
struct Soil {
    Problem problem;
    State state;

    explicit Soil(double fraction)
    {
        problem.grid = {{0.0, 0.0}, 0.5, 4, 4};
        problem.materials = {stiff_sand()};
        state = fill(problem, 2, [](const Vector2&) { return true; });
        Particles& particles = state.particles;
        particles.volume[5] *= fraction;
        for (Vectors* edge : {&particles.half_edge_1, &particles.half_edge_2})
            edge->set(5, std::sqrt(fraction) * (*edge)[5]);
        particles.position.set(5, particles.position[5] + Vector2(0.1, 0.02));
        reset_reference(particles);
        problem.cut_domains.pieces.assign(particles.size(), 0);
        problem.cut_domains.pieces[5] = 1;
        problem.cut_domains.slivers = find_slivers(problem.cut_domains, particles, 0.0625);
    }
};

TEST(Slivers, ArePiecesBelowATenthOfABoxWithTheNearestCarrier)
{
    EXPECT_TRUE(Soil(0.12).problem.cut_domains.slivers.empty());
    const Soil soil(0.01);
    ASSERT_EQ(soil.problem.cut_domains.slivers.size(), 1U);
    EXPECT_EQ(soil.problem.cut_domains.slivers[0].identifier, 5);
    EXPECT_EQ(soil.problem.cut_domains.slivers[0].carrier, 6);
}

TEST(Slivers, StayWhereTheyAreInTheFrameOfTheirCarrier)
{
    Soil soil(0.01);
    Particles& particles = soil.state.particles;
    const Vector2 before = particles.position[5] - particles.position[6];
    Eigen::Matrix2d F;
    F << 1.1, 0.3, -0.2, 0.9;
    particles.position.set(6, {3.0, 4.0});
    particles.half_edge_1.set(6, F * particles.half_edge_1[6]);
    particles.half_edge_2.set(6, F * particles.half_edge_2[6]);
    particles.stress.xy[6] = -7e3;
    particles.stress.zz[6] = -9e3;
    const double volume = particles.volume[5];
    ParticlePlaces places;
    carry_slivers(soil.problem, places, soil.state);
    EXPECT_NEAR((particles.position[5] - (Vector2(3.0, 4.0) + F * before)).norm(), 0.0, 1e-14);
    EXPECT_NEAR(particles.volume[5], F.determinant() * volume, 1e-15);
    EXPECT_EQ(particles.stress.xy[5], -7e3);
    EXPECT_EQ(particles.stress.zz[5], -9e3);
}

TEST(Slivers, KeepTheirVolumeInSmallStrain)
{
    Soil soil(0.01);
    soil.problem.strain = StrainForm::small;
    Particles& particles = soil.state.particles;
    const double volume = particles.volume[5];
    particles.half_edge_1.set(6, 1.01 * particles.half_edge_1[6]);
    ParticlePlaces places;
    carry_slivers(soil.problem, places, soil.state);
    EXPECT_EQ(particles.volume[5], volume);
}

} // namespace
} // namespace quicksand
