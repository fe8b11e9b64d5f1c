#include "solver/interpolation/cpdi2.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/motion/compact_domains.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace quicksand {
namespace {

/// Five domains, the last sheared by 2.4 of its width, the fourth in the other direction with its edges
/// exchanged, of soil of the law; there is one boundary curve without pieces.
struct ShearedSoil {
    explicit ShearedSoil(const SkeletonLaw& law)
    {
        Material soil;
        soil.law = law;
        problem.materials = {soil};
        problem.boundaries.resize(1);
        problem.grid.cell_size = 4.0;
        resize(particles, 5, std::nullopt);
        for (std::size_t p = 0; p < 5; ++p) {
            particles.identifier[p] = static_cast<std::int32_t>(p);
            particles.half_edge_1.set(p, {2.0, 0.0});
            particles.half_edge_2.set(p, {0.0, 1.0});
        }
        reset_reference(particles);
        particles.half_edge_1.set(3, {2.0, -4.4});
        particles.half_edge_2.set(4, {4.8, 1.0});
    }

    Problem problem;
    Particles particles;
};

TEST(CompactDomains, OfYieldingSoilLoseTheirShorterEdgeFromTheLongerWhenSheared)
{
    ShearedSoil soil{MohrCoulomb{}};
    const Particles before = soil.particles;
    keep_domains_compact(soil.problem, soil.particles);
    const Particles& now = soil.particles;
    EXPECT_NEAR((now.half_edge_1[3] - Vector2(2.0, -0.4)).norm(), 0.0, 1e-14);
    EXPECT_NEAR((now.half_edge_2[4] - Vector2(0.8, 1.0)).norm(), 0.0, 1e-14);
    for (const std::size_t p : {3U, 4U}) {
        EXPECT_NEAR(domain_area(now, p), domain_area(before, p), 1e-14);
        const Eigen::Matrix2d F = deformation_gradient(before, p);
        EXPECT_NEAR((deformation_gradient(now, p) - F).norm(), 0.0, 1e-14) << "particle " << p;
    }
    EXPECT_EQ(now.half_edge_1[0], before.half_edge_1[0]);
    EXPECT_EQ(now.half_edge_2[0], before.half_edge_2[0]);
}

TEST(CompactDomains, OfYieldingSoilBecomeShorterAndWiderWhenStretched)
{
    ShearedSoil soil{MohrCoulomb{}};
    soil.particles.half_edge_1.set(1, {0.0, 3.0 * longest_half_edge * 4.0}); // turned by a right angle
    soil.particles.half_edge_2.set(1, {-0.2, 0.0});
    const Particles before = soil.particles;
    keep_domains_compact(soil.problem, soil.particles);
    EXPECT_NEAR((soil.particles.half_edge_1[1] - Vector2(0.0, longest_half_edge * 4.0)).norm(), 0.0, 1e-14);
    EXPECT_NEAR((soil.particles.half_edge_2[1] - Vector2(-0.6, 0.0)).norm(), 0.0, 1e-14);
    EXPECT_NEAR(domain_area(soil.particles, 1), domain_area(before, 1), 1e-13);
    const Eigen::Matrix2d F = deformation_gradient(before, 1);
    EXPECT_NEAR((deformation_gradient(soil.particles, 1) - F).norm(), 0.0, 1e-14 * F.norm());
}

TEST(CompactDomains, RecordTheDeformationOfMixedSoilUpToALimit)
{
    ShearedSoil soil{MohrCoulomb{}};
    Vectors &r1 = soil.particles.half_edge_1, &r2 = soil.particles.half_edge_2;
    Eigen::Matrix2d mixing; // stretches by 2.6 each time, area unchanged
    mixing << 2.0, 1.0, 1.0, 1.0;
    for (int time = 1; time <= 60; ++time) {
        r1.set(0, mixing * r1[0]);
        r2.set(0, mixing * r2[0]);
        keep_domains_compact(soil.problem, soil.particles);
        const Eigen::Matrix2d F = deformation_gradient(soil.particles, 0);
        EXPECT_NEAR(F.determinant(), 1.0, 1e-6) << "after " << time;
        EXPECT_LT(F.norm(), 30.0 * largest_recorded_stretch);
        if (time == 9) {
            EXPECT_NEAR(F(0, 0), 4181.0, 1e-6) << "a Fibonacci number";
        }
    }
}

TEST(CompactDomains, LeaveTheCrestWhereItWas)
{
    ShearedSoil soil{MohrCoulomb{}};
    Particles& particles = soil.particles;
    for (std::size_t p = 0; p < 5; ++p) particles.position.set(p, {4.0 * double(p), p < 2 ? 3.0 : 1.0});
    reset_reference(particles);
    const auto crest_at_start = [&] {
        Particles at_start = particles;
        return_to_reference(at_start);
        return crest_particles(at_start);
    };
    const std::vector<std::int32_t> before = crest_at_start();
    EXPECT_EQ(before, (std::vector<std::int32_t>{0, 1}));
    for (std::size_t p = 0; p < 5; ++p) particles.half_edge_1.set(p, {2.0, 9.0});
    keep_domains_compact(soil.problem, particles);
    EXPECT_NE(particles.reference_edge_1[3].y(), -4.4) << "the shape of the reference has changed";
    EXPECT_EQ(crest_at_start(), before);
}

TEST(CompactDomains, AreCompactAfterOneTime)
{
    ShearedSoil soil{MohrCoulomb{}};
    keep_domains_compact(soil.problem, soil.particles);
    const Particles once = soil.particles;
    keep_domains_compact(soil.problem, soil.particles);
    for (std::size_t p = 0; p < 5; ++p) {
        EXPECT_EQ(soil.particles.half_edge_1[p], once.half_edge_1[p]);
        EXPECT_EQ(soil.particles.half_edge_2[p], once.half_edge_2[p]);
    }
}

TEST(CompactDomains, StayInElasticSoil)
{
    ShearedSoil soil{LinearElastic{}};
    keep_domains_compact(soil.problem, soil.particles);
    EXPECT_EQ(soil.particles.half_edge_1[3], Vector2(2.0, -4.4));
    EXPECT_EQ(soil.particles.half_edge_2[4], Vector2(4.8, 1.0));
}

TEST(CompactDomains, StayUnderABoundaryCurve)
{
    ShearedSoil soil{MohrCoulomb{}};
    soil.problem.boundaries[0].pieces.push_back({4, {-1.0, 1.0}, {1.0, 1.0}, 4.0});
    keep_domains_compact(soil.problem, soil.particles);
    EXPECT_EQ(soil.particles.half_edge_2[4], Vector2(4.8, 1.0));
    EXPECT_NEAR(soil.particles.half_edge_1[3].y(), -0.4, 1e-14) << "of another particle";
}

TEST(CompactDomains, StayUnderAnyPieceOfAnyCurve)
{
    // carriers in no order, one with two pieces, on two curves
    ShearedSoil soil{MohrCoulomb{}};
    soil.problem.boundaries.resize(2);
    const auto put_piece = [&](std::size_t curve, std::int32_t identifier) {
        soil.problem.boundaries[curve].pieces.push_back({identifier, {-1.0, 1.0}, {1.0, 1.0}, 4.0});
    };
    put_piece(0, 7);
    put_piece(0, 4);
    put_piece(0, 4);
    put_piece(1, 3);
    put_piece(1, 0);
    keep_domains_compact(soil.problem, soil.particles);
    EXPECT_EQ(soil.particles.half_edge_1[3], Vector2(2.0, -4.4));
    EXPECT_EQ(soil.particles.half_edge_2[4], Vector2(4.8, 1.0));
}

} // namespace
} // namespace quicksand
