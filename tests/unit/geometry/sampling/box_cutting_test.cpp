// Exact cutting of lattice boxes by outlines, asked through the sampler.
#include "geometry/sampling/particle_sampler.hpp"
#include "solver/base/cross_product.hpp"
#include "tests/fixtures/scratch_files.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace quicksand {
namespace {

/// Corners of a domain as sampled, counter-clockwise.
std::vector<Vector2> polygon_of(const Sampling& sampling, const ParticleDomain& domain)
{
    const CutDomain box = make_cut_domain({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    const CutDomain& shape = domain.shape < 0 ? box : sampling.shapes[static_cast<std::size_t>(domain.shape)];
    return corners_in_frame(shape, domain.centre, domain.half_edge_1, domain.half_edge_2);
}

/// Every polygon is convex, has the volume of its domain and its centroid there, and fractions that give it;
/// the volumes of a region add up to its area but for what is left out.
void expect_sound(const Section& section, const Sampling& sampling, double box, double left_out = 0.0)
{
    const double box_size = std::sqrt(box); // [m]
    std::vector<double> sums(section.regions.size(), 0.0);
    for (const ParticleDomain& domain : sampling.domains) {
        sums[domain.region] += domain.volume;
        EXPECT_NEAR(4.0 * cross(domain.half_edge_1, domain.half_edge_2) / domain.volume, 1.0, 1e-12);
        const Ring corners = polygon_of(sampling, domain);
        const double rounding = 1e-16 * domain.centre.norm() * box_size; // of the corners' places
        EXPECT_NEAR(area(Region{"", {{corners, {}}}}), domain.volume, 1e-9 * domain.volume + 10.0 * rounding);
        for (std::size_t c = 0; c < corners.size(); ++c) {
            const Vector2 &b = corners[(c + 1) % corners.size()], &d = corners[(c + 2) % corners.size()];
            EXPECT_GT(cross(b - corners[c], d - b), 0.0) << domain.centre.transpose();
        }
        if (domain.shape < 0) continue;
        const CutDomain& shape = sampling.shapes[static_cast<std::size_t>(domain.shape)];
        Vector2 centroid = Vector2::Zero();
        for (std::size_t c = 0; c < corners.size(); ++c) {
            EXPECT_GT(shape.fractions[c], 0.0);
            centroid += shape.fractions[c] * shape.corners[c];
        }
        EXPECT_NEAR(std::accumulate(shape.fractions.begin(), shape.fractions.end(), 0.0), 1.0, 1e-14);
        EXPECT_LT(centroid.norm(), 1e-6);
    }
    for (std::size_t r = 0; r < sums.size(); ++r)
        EXPECT_NEAR(sums[r], area(section.regions[r]), 1e-9 * sums[r] + left_out * box);
}

/// A dike with slopes of 1:2 and a berm: its toes and crest lie inside boxes and on their corners.
Section dike(double scale, const Vector2& shift, bool mirrored)
{
    Ring outline = {{0, 0}, {10, 0}, {10, 1}, {8.13, 1}, {4.13, 3}, {2.5, 3}, {0.5, 2}, {0, 2}};
    for (Vector2& vertex : outline) {
        if (mirrored) vertex.x() = 10.0 - vertex.x();
        vertex = scale * (vertex + shift);
    }
    if (mirrored) std::reverse(outline.begin(), outline.end());
    return make_section({{"dike", {{outline, {}}}}});
}

Sampling sample_dike(double scale, const Vector2& shift, bool mirrored)
{
    const Section section = dike(scale, shift, mirrored);
    const Vector2 origin = scale * shift;
    return sample_lattice(section, make_grid(origin.x(), origin.y(), 0.25 * scale, 40, 12), 2, 2);
}

TEST(BoxCutting, GivesTheSameParticlesWhereverTheDikeLies)
{
    const Sampling drawn = sample_dike(1.0, {0, 0}, false);
    EXPECT_GT(drawn.regions[0].cut, 40u);
    expect_sound(dike(1.0, {0, 0}, false), drawn, 0.125 * 0.125);
    struct Case {
        double scale;
        Vector2 shift;
    };
    for (const Case& other : {Case{1.0, {1000, 500}}, {50.0, {0, 0}}, {0.02, {0, 0}}, {0.1, {3, 7}}}) {
        const Sampling moved = sample_dike(other.scale, other.shift, false);
        ASSERT_EQ(moved.domains.size(), drawn.domains.size());
        EXPECT_EQ(moved.regions[0].cut, drawn.regions[0].cut);
        EXPECT_EQ(moved.shapes.size(), drawn.shapes.size());
        for (std::size_t p = 0; p < drawn.domains.size(); ++p) {
            const ParticleDomain &a = drawn.domains[p], &b = moved.domains[p];
            EXPECT_LT((b.centre / other.scale - other.shift - a.centre).norm(), 1e-9);
            EXPECT_NEAR(b.volume / (other.scale * other.scale), a.volume, 1e-9);
        }
    }
}

TEST(BoxCutting, GivesTheSameParticlesInAMirror)
{
    const Sampling drawn = sample_dike(1.0, {0, 0}, false), mirrored = sample_dike(1.0, {0, 0}, true);
    ASSERT_EQ(mirrored.domains.size(), drawn.domains.size());
    EXPECT_EQ(mirrored.regions[0].cut, drawn.regions[0].cut);
    for (const ParticleDomain& a : drawn.domains) {
        const Vector2 image(10.0 - a.centre.x(), a.centre.y());
        const auto twin =
            std::find_if(mirrored.domains.begin(), mirrored.domains.end(), [&](const ParticleDomain& b) {
                return (b.centre - image).norm() < 1e-9 && std::abs(b.volume - a.volume) < 1e-9;
            });
        EXPECT_NE(twin, mirrored.domains.end()) << a.centre.transpose();
    }
}

TEST(BoxCutting, LeavesNoStairsOnASlope)
{
    const Sampling sampling = sample_dike(1.0, {0, 0}, false);
    double length = 0.0; // of the edges of domains that lie on the slope from (4.13, 3) to (8.13, 1)
    for (const ParticleDomain& domain : sampling.domains) {
        const Ring corners = polygon_of(sampling, domain);
        for (std::size_t c = 0; c < corners.size(); ++c) {
            const Vector2 &a = corners[c], &b = corners[(c + 1) % corners.size()];
            const auto above = [](const Vector2& x) { return x.y() - 3.0 + 0.5 * (x.x() - 4.13); };
            if (a.x() > 4.14 && a.x() < 8.12) {
                EXPECT_LT(above(a), 1e-9);
            }
            if (std::abs(above(a)) < 1e-9 && std::abs(above(b)) < 1e-9) length += (b - a).norm();
        }
    }
    EXPECT_NEAR(length, std::sqrt(20.0), 1e-8);
}

TEST(BoxCutting, LeavesAsItIsWhatTheOutlineHardlyTouches)
{
    // sides beside the boxes' by rounding, and by less than counts; a corner that reaches over a box's by
    // less
    const double little = 1e-8;
    const Section section = make_section(
        {{"sand",
          {{{{1e-17, 0}, {1, -1e-17}, {1 - 0.1 * little, 0.5}, {1 + 1e-15, 1 - little}, {0, 1}}, {}}}}});
    const Sampling sampling = sample_lattice(section, make_grid(0, 0, 0.25, 4, 4), 1, 1);
    EXPECT_EQ(sampling.domains.size(), 16u);
    EXPECT_EQ(sampling.regions[0].cut, 0u);
    EXPECT_EQ(sampling.domains[3].volume, 0.0625);
}

TEST(BoxCutting, FollowsACurvedOutlineOfManySegments)
{
    Ring circle;
    constexpr int segments = 1000;
    for (int k = 0; k < segments; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / segments;
        circle.emplace_back(1.0 + 0.77 * std::cos(angle), 1.0 + 0.77 * std::sin(angle));
    }
    const BackgroundGrid grid = make_grid(0, 0, 0.02, 100, 100);
    const double box = 0.01 * 0.01;
    const Section disc = make_section({{"disc", {{circle, {}}}}});
    const Sampling inside = sample_lattice(disc, grid, 2, 2);
    EXPECT_GT(inside.regions[0].cut, 600u);
    expect_sound(disc, inside, box, 1e-3);

    std::reverse(circle.begin(), circle.end());
    // the soil around it has reflex corners; together they fill the square
    const Section square = make_section({{"square", {{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {circle}}}}});
    const Sampling outside = sample_lattice(square, grid, 2, 2);
    expect_sound(square, outside, box, 1e-3);
    EXPECT_LT(outside.regions[0].cut, 2000u);
}

TEST(BoxCutting, LosesNoSoilOfAnyOutline)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int trial = 0; trial < 40; ++trial) {
        // a star with a star-shaped hole, jagged within boxes and across them, here or far away
        const Vector2 far = trial % 2 == 0 ? Vector2(0, 0) : Vector2(1000.0 * uniform(random), 500.0);
        const int count = 5 + static_cast<int>(60 * uniform(random));
        Polygon star;
        star.holes.emplace_back();
        for (int k = 0; k < count; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / count;
            const Vector2 direction(std::cos(angle), std::sin(angle));
            star.outer.push_back(far + Vector2(1, 1) + (0.5 + 0.4 * uniform(random)) * direction);
            star.holes[0].push_back(far + Vector2(1, 1) + (0.1 + 0.3 * uniform(random)) * direction);
        }
        std::reverse(star.holes[0].begin(), star.holes[0].end());
        const Section section = make_section(
            {{"core", {{{star.holes[0].rbegin(), star.holes[0].rend()}, {}}}}, {"star", {star}}});
        const Sampling sampling = sample_lattice(section, make_grid(far.x(), far.y(), 0.2, 10, 10), 1, 2);
        expect_sound(section, sampling, 0.2 * 0.1, 1e-4);
    }
}

TEST(BoxCutting, CutsAroundAHoleSmallerThanABox)
{
    Polygon plate = rectangle(0, 0, 1, 1);
    plate.holes = {{{0.3, 0.3}, {0.3, 0.4}, {0.4, 0.35}}};
    const Section section = make_section({{"plate", {plate}}});
    const Sampling sampling = sample_lattice(section, make_grid(0, 0, 0.5, 2, 2), 1, 1);
    EXPECT_EQ(sampling.domains.size(), 3u + sampling.regions[0].cut);
    EXPECT_LE(sampling.regions[0].cut, 5u);
    expect_sound(section, sampling, 0.25);
}

TEST(BoxCutting, CutsBothSidesOfASlantedInterface)
{
    const Section section = make_section({{"lower", {{{{0, 0}, {2, 0}, {2, 1.3}, {0, 0.4}}, {}}}},
                                          {"upper", {{{{0, 0.4}, {2, 1.3}, {2, 2}, {0, 2}}, {}}}}});
    const Sampling sampling = sample_lattice(section, make_grid(0, 0, 0.25, 8, 8), 2, 2);
    expect_sound(section, sampling, 0.125 * 0.125);
    EXPECT_EQ(sampling.regions[0].cut, sampling.regions[1].cut);
    EXPECT_EQ(sampling.regions[0].particles + sampling.regions[1].particles, 256u + sampling.regions[0].cut);
}

TEST(BoxCutting, TakesPartsOfARegionInOneBoxTogether)
{
    // a line of construction inside a region cuts no box that the region fills
    const Section section = make_section({{"sand", {rectangle(0, 0, 0.3, 1), rectangle(0.3, 0, 1, 1)}}});
    const Sampling sampling = sample_lattice(section, make_grid(0, 0, 0.25, 4, 4), 1, 1);
    EXPECT_EQ(sampling.domains.size(), 16u);
    EXPECT_EQ(sampling.regions[0].cut, 0u);
}

TEST(BoxCutting, KeepsALayerThinnerThanABox)
{
    const Section section = make_section({{"lower", {rectangle(0, 0, 1, 0.3)}},
                                          {"clay", {rectangle(0, 0.3, 1, 0.32)}},
                                          {"upper", {rectangle(0, 0.32, 1, 1)}}});
    const Sampling sampling = sample_lattice(section, make_grid(0, 0, 0.25, 4, 4), 1, 1);
    EXPECT_EQ(sampling.regions[1].particles, 4u);
    expect_sound(section, sampling, 0.0625);
}

} // namespace
} // namespace quicksand
