#include "solver/cpdi2.hpp"
#include "solver/sheared_domains.hpp"

#include <gtest/gtest.h>

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

TEST(ShearedDomains, OfYieldingSoilLoseTheirShorterEdgeFromTheLonger)
{
    ShearedSoil soil{MohrCoulomb{}};
    const Particles before = soil.particles;
    shorten_sheared_domains(soil.problem, soil.particles);
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

TEST(ShearedDomains, AreCompactAfterOneTime)
{
    ShearedSoil soil{MohrCoulomb{}};
    shorten_sheared_domains(soil.problem, soil.particles);
    const Particles once = soil.particles;
    shorten_sheared_domains(soil.problem, soil.particles);
    for (std::size_t p = 0; p < 5; ++p) {
        EXPECT_EQ(soil.particles.half_edge_1[p], once.half_edge_1[p]);
        EXPECT_EQ(soil.particles.half_edge_2[p], once.half_edge_2[p]);
    }
}

TEST(ShearedDomains, StayInElasticSoil)
{
    ShearedSoil soil{LinearElastic{}};
    shorten_sheared_domains(soil.problem, soil.particles);
    EXPECT_EQ(soil.particles.half_edge_1[3], Vector2(2.0, -4.4));
    EXPECT_EQ(soil.particles.half_edge_2[4], Vector2(4.8, 1.0));
}

TEST(ShearedDomains, StayUnderABoundaryCurve)
{
    ShearedSoil soil{MohrCoulomb{}};
    soil.problem.boundaries[0].pieces.push_back({4, {-1.0, 1.0}, {1.0, 1.0}, 4.0});
    shorten_sheared_domains(soil.problem, soil.particles);
    EXPECT_EQ(soil.particles.half_edge_2[4], Vector2(4.8, 1.0));
    EXPECT_NEAR(soil.particles.half_edge_1[3].y(), -0.4, 1e-14) << "of another particle";
}

} // namespace
} // namespace quicksand
