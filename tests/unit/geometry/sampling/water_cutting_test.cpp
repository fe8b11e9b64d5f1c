// Boxes parted at the lines up to which water stands, asked through the sampler.
#include "geometry/sampling/particle_sampler.hpp"
#include "tests/fixtures/scratch_files.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

/// A block from (0, 0) to (2, 1.5) m on cells of 0.5 m with 2 x 2 particles, moved by `shift`.
Sampling parted_block(std::vector<Vector2> line, const Vector2& shift = Vector2::Zero())
{
    for (Vector2& knee : line) knee += shift;
    const Section section =
        make_section({{"sand", {rectangle(shift.x(), shift.y(), shift.x() + 2.0, shift.y() + 1.5)}}});
    return sample_lattice(section, make_grid(shift.x(), shift.y(), 0.5, 4, 3), 2, 2, {{std::move(line)}});
}

double area_below(const std::vector<Vector2>& line, const Sampling& sampling)
{
    double sum = 0.0;
    for (const ParticleDomain& domain : sampling.domains)
        if (domain.centre.y() < elevation(line, domain.centre.x())) sum += domain.volume;
    return sum;
}

double whole_area(const Sampling& sampling)
{
    double sum = 0.0;
    for (const ParticleDomain& domain : sampling.domains) sum += domain.volume;
    return sum;
}

TEST(WaterCutting, PartsARowOfBoxesAtALevel)
{
    for (const double level : {0.6, 0.7499, 0.7501, 0.99}) {
        const std::vector<Vector2> line{{0.0, level}};
        const Sampling sampling = parted_block(line);
        EXPECT_EQ(sampling.domains.size(), 56u) << level; // of 48 boxes 8 are parted
        EXPECT_EQ(sampling.regions[0].cut, 16u) << level;
        EXPECT_TRUE(sampling.shapes.empty()) << level; // into rectangles
        EXPECT_NEAR(area_below(line, sampling), 2.0 * level, 1e-12) << level;
        EXPECT_NEAR(whole_area(sampling), 3.0, 1e-12) << level;
    }
}

TEST(WaterCutting, LeavesBoxesWholeThatTheLineOnlyTouches)
{
    for (const Vector2& shift : {Vector2(0.0, 0.0), Vector2(1000.3, 500.7), Vector2(-0.1, 0.3)})
        for (const double level : {-1.0, 0.0, 0.75, 0.75 + 1e-10, 0.75 - 1e-8, 1.5, 9.0})
            EXPECT_EQ(parted_block({{0.0, level}}, shift).domains.size(), 48u) << shift.x() << ' ' << level;
}

TEST(WaterCutting, FollowsASlantedLineWithKneesInBoxes)
{
    const std::vector<Vector2> line{{0.33, 1.21}, {0.9, 0.87}, {1.42, 0.4}};
    const Sampling sampling = parted_block(line);
    double exact = 0.33 * 1.21 + (2.0 - 1.42) * 0.4;
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
        exact += 0.5 * (line[k].y() + line[k + 1].y()) * (line[k + 1].x() - line[k].x());
    EXPECT_NEAR(area_below(line, sampling), exact, 1e-12);
    EXPECT_NEAR(whole_area(sampling), 3.0, 1e-12);
    EXPECT_FALSE(sampling.shapes.empty());
}

TEST(WaterCutting, AMirroredLineGivesTheMirroredParts)
{
    const std::vector<Vector2> line{{0.33, 1.21}, {0.9, 0.87}, {1.42, 0.4}};
    std::vector<Vector2> mirrored;
    for (auto knee = line.rbegin(); knee != line.rend(); ++knee)
        mirrored.emplace_back(2.0 - knee->x(), knee->y());
    const Sampling one = parted_block(line), other = parted_block(mirrored);
    ASSERT_EQ(one.domains.size(), other.domains.size());
    for (const ParticleDomain& domain : one.domains) {
        const Vector2 place(2.0 - domain.centre.x(), domain.centre.y());
        EXPECT_TRUE(std::any_of(other.domains.begin(), other.domains.end(), [&](const ParticleDomain& like) {
            return (like.centre - place).norm() < 1e-12 && std::abs(like.volume - domain.volume) < 1e-12;
        })) << place.transpose();
    }
}

TEST(WaterCutting, PartsPiecesThatAnOutlineHasCut)
{
    const Ring slope = {{0.0, 0.0}, {2.0, 0.0}, {0.0, 1.5}};
    const Section section = make_section({{"sand", {{slope, {}}}}});
    const std::vector<Vector2> line{{0.0, 0.61}};
    const Sampling sampling = sample_lattice(section, make_grid(0, 0, 0.5, 4, 3), 2, 2, {{line}});
    EXPECT_NEAR(whole_area(sampling), 1.5, 1e-9);
    const double above = 0.5 * (1.5 - 0.61) * (2.0 * (1.5 - 0.61) / 1.5);
    EXPECT_NEAR(area_below(line, sampling), 1.5 - above, 1e-9);
}

} // namespace
} // namespace quicksand
