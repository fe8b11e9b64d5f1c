#include "geometry/sampling/particle_sampler.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/scratch_files.hpp"

#include <cmath>

namespace quicksand {
namespace {

Section dike_section()
{
    const Ring outline = {{0, 0}, {0.48, 0}, {0.48, 0.10}, {0.4272, 0.10}, {0.15, 0.25}, {0, 0.25}};
    return make_section({{"dike", {{outline, {}}}}});
}

void expect_exact_areas(const Section& section, const Sampling& sampling)
{
    std::vector<double> sums(section.regions.size(), 0.0);
    for (const ParticleDomain& domain : sampling.domains) sums[domain.region] += domain.volume;
    for (std::size_t k = 0; k < sums.size(); ++k) EXPECT_NEAR(sums[k] / area(section.regions[k]), 1.0, 1e-12);
}

TEST(LatticeSampling, FillsARectangleOfWholeDomainsExactly)
{
    const Section section = make_section({{"sand", {rectangle(0, 0, 0.0675, 0.3175)}}});
    const Sampling sampling = sample_lattice(section, make_grid(0, 0, 0.0075, 9, 43), 3, 3);
    EXPECT_EQ(sampling.domains.size(), 3429u);
    EXPECT_EQ(sampling.regions[0].cut, 0u); // sides along the domains' edges cut none of them
    EXPECT_NEAR(sampling.regions[0].area_error, 0.0, 1e-13);
    EXPECT_EQ(sampling.occupied_cells, 9u * 43u);
    expect_exact_areas(section, sampling);
}

TEST(LatticeSampling, CountsTheParticlesOfTheDike)
{
    const Sampling sampling = sample_lattice(dike_section(), make_grid(0, 0, 0.0075, 64, 34), 3, 3);
    const std::size_t whole = sampling.domains.size() - sampling.regions[0].cut;
    EXPECT_EQ(whole, 14522u);
    EXPECT_EQ(sampling.regions[0].cut, 170u);
    EXPECT_EQ(sampling.shapes.size(), 170u);
    EXPECT_GT(sampling.particles_per_cell, 8.5);
    expect_exact_areas(dike_section(), sampling);
}

TEST(LatticeSampling, RunsRowByRowFromTheBottomLeft)
{
    const Section section = make_section({{"sand", {rectangle(0, 0, 1, 1)}}});
    const Sampling sampling = sample_lattice(section, make_grid(0, 0, 0.5, 2, 2), 2, 1);
    ASSERT_EQ(sampling.domains.size(), 8u);
    EXPECT_EQ(sampling.domains[0].centre, Vector2(0.125, 0.25));
    EXPECT_EQ(sampling.domains[1].centre, Vector2(0.375, 0.25));
    EXPECT_EQ(sampling.domains[4].centre, Vector2(0.125, 0.75));
    EXPECT_EQ(sampling.domains[0].half_edge_1, Vector2(0.125, 0.0));
    EXPECT_EQ(sampling.domains[0].half_edge_2, Vector2(0.0, 0.25));
}

TEST(LatticeSampling, CutsARowAlongALevelInterfaceIntoRectangles)
{
    // the interface runs through the centres of a row
    const Section section =
        make_section({{"lower", {rectangle(0, 0, 1, 0.375)}}, {"upper", {rectangle(0, 0.375, 1, 1)}}});
    const Sampling sampling = sample_lattice(section, make_grid(0, 0, 0.25, 4, 4), 1, 1);
    EXPECT_EQ(sampling.regions[0].particles, 8u);
    EXPECT_EQ(sampling.regions[1].particles, 12u);
    EXPECT_EQ(sampling.regions[0].cut, 4u);
    EXPECT_TRUE(sampling.shapes.empty());
    EXPECT_EQ(sampling.domains[4].centre, Vector2(0.125, 0.3125));
    EXPECT_EQ(sampling.domains[4].half_edge_2, Vector2(0.0, 0.0625));
    EXPECT_EQ(sampling.domains[5].region, 1u);
    expect_exact_areas(section, sampling);
}

TEST(LatticeSampling, ReportsWhatItDid)
{
    const Section section = make_section({{"sand", {rectangle(0, 0, 1, 0.9)}}});
    const RegionSampling report = sample_lattice(section, make_grid(0, 0, 0.5, 2, 2), 1, 1).regions[0];
    EXPECT_EQ(report.particles, 4u);
    EXPECT_EQ(report.cut, 2u);
    EXPECT_DOUBLE_EQ(report.area, 0.9);
    EXPECT_NEAR(report.area_error, 0.0, 1e-15);
    EXPECT_DOUBLE_EQ(report.smallest_volume, 0.2);
    EXPECT_DOUBLE_EQ(report.largest_volume, 0.25);
}

TEST(MeshSampling, TakesTheAreaOfAnyQuadrilateral)
{
    Section section = make_section({{"sand", {{{{0, 0}, {2, 0}, {3, 2}, {0, 1}}, {}}}}});
    section.quads.push_back({{{0, 0}, {2, 0}, {3, 2}, {0, 1}}, 0});
    const Sampling sampling = sample_mesh(section, make_grid(0, 0, 1, 3, 2));
    EXPECT_NEAR(sampling.regions[0].area_error, 0.0, 1e-15);
    // centroid of the triangles (0,0) (2,0) (3,2) and (0,0) (3,2) (0,1), of areas 2 and 1.5
    const Vector2 centroid = (2.0 * Vector2(5.0, 2.0) + 1.5 * Vector2(3.0, 3.0)) / (3.0 * 3.5);
    EXPECT_LT((sampling.domains[0].centre - centroid).norm(), 1e-15);
    EXPECT_EQ(sampling.domains[0].twist, Vector2(0.25, 0.25));
}

TEST(MeshSampling, RefusesAQuadrilateralThatIsNotConvex)
{
    Section section = make_section({{"sand", {{{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}, {}}}}});
    section.quads.push_back({{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}, 0});
    try {
        sample_mesh(section, make_grid(0, 0, 1, 3, 2));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "the mesh has a quadrilateral at (0.5, 0.5) that is folded, flat or "
                                   "not convex\nhint: try another quad_size, or sample a lattice");
    }
}

TEST(MeshSampling, FollowsASlopeWithoutStairs)
{
    GmshRequest request;
    request.file = fixture("slope.geo");
    request.quad_size = 1.0;
    const Section section = read_gmsh_file(request);
    const Sampling sampling = sample_mesh(section, make_grid(0, 0, 0.5, 12, 4));
    // the left slope is y = 1 + x / 2: every domain beside it has two corners on it
    int beside = 0, corners_on_slope = 0;
    for (const ParticleDomain& domain : sampling.domains) {
        int corners = 0;
        for (const double s : {-1.0, 1.0}) {
            for (const double t : {-1.0, 1.0}) {
                const Vector2 corner = domain.centre + s * domain.half_edge_1 + t * domain.half_edge_2;
                EXPECT_LT(corner.y() - 1.0 - 0.5 * corner.x(), 1e-12);
                const bool on_slope =
                    std::abs(corner.y() - 1.0 - 0.5 * corner.x()) < 1e-12 && domain.region == 1;
                corners += on_slope ? 1 : 0;
            }
        }
        beside += corners == 2 ? 1 : 0;
        corners_on_slope += corners;
    }
    EXPECT_EQ(beside, 2);
    EXPECT_EQ(corners_on_slope, 4);
    expect_exact_areas(section, sampling);
}

TEST(MeshSampling, RecombinedQuadsFillTheDikeAndFollowItsSlope)
{
    GmshRequest request;
    request.quad_size = 0.01;
    const Section section = read_geo(R"(
Point(1) = {0,0,0}; Point(2) = {0.48,0,0}; Point(3) = {0.48,0.1,0}; Point(4) = {0.4272,0.1,0}; Point(5) = {0.15,0.25,0};
Point(6) = {0,0.25,0}; Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,5}; Line(5) = {5,6}; Line(6) = {6,1};
Curve Loop(1) = {1,2,3,4,5,6}; Plane Surface(1) = {1}; Physical Surface("dike") = {1};)",
                                     request);
    double sum = 0.0;
    int on_slope = 0;
    const Vector2 toe(0.4272, 0.1), crest(0.15, 0.25), along = (crest - toe).normalized();
    for (const MeshQuad& quad : section.quads) {
        sum += area(Region{"", {{{quad.corners, quad.corners + 4}, {}}}});
        for (int k = 0; k < 4; ++k) {
            const Vector2 a = quad.corners[k] - toe, b = quad.corners[(k + 1) % 4] - toe;
            const double off_a = along.x() * a.y() - along.y() * a.x(),
                         off_b = along.x() * b.y() - along.y() * b.x();
            on_slope += std::abs(off_a) < 1e-12 && std::abs(off_b) < 1e-12 ? 1 : 0;
        }
    }
    EXPECT_NEAR(sum / area(section.regions[0]), 1.0, 1e-12); // whole quads only, none on the wrong side
    EXPECT_GT(on_slope, 20);
    const double mean_size = std::sqrt(sum / static_cast<double>(section.quads.size()));
    EXPECT_NEAR(mean_size, 0.01, 0.002);
    expect_exact_areas(section, sample_mesh(section, make_grid(0, 0, 0.03, 16, 9)));
}

} // namespace
} // namespace quicksand
