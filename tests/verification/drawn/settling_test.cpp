// What must not matter while soil settles: how many particles a cell has, the angle of walls without gravity.
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double box_size = 4.0; // [m]

/// A slope of 1:3 from 7.3 m down to the ground, whose corners lie off cells of 2 m.
AssembledCase settling_slope(const std::string& law, int particles)
{
    const std::vector<NamedCorner> corners = {{{0.0, 0.0}, "base"},     {{52.0, 0.0}, "right"},
                                              {{52.0, 12.7}, "ground"}, {{25.9, 12.7}, "ground"},
                                              {{4.0, 20.0}, "ground"},  {{0.0, 20.0}, "left"}};
    const std::string tables = section_in_water(particles, "implicit", "12.7", law);
    return assemble(scene_with(2.0, {0.0, 0.0}, 26, 12, tables), polygon_section(corners));
}

struct Box {
    double volume = 0.0;                     // [m3/m]
    double vertical = 0.0, horizontal = 0.0; // sum of stress times volume [N m/m]
};

std::map<std::pair<int, int>, Box> boxes_of(const Particles& particles)
{
    std::map<std::pair<int, int>, Box> boxes;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 place = particles.reference_position[p] / box_size;
        Box& box = boxes[{static_cast<int>(place.x()), static_cast<int>(place.y())}];
        box.volume += particles.volume[p];
        box.vertical += particles.volume[p] * particles.stress.yy[p];
        box.horizontal += particles.volume[p] * particles.stress.xx[p];
    }
    return boxes;
}

/// Root mean square of the difference of mean stresses in boxes that are full of soil, over the largest
/// vertical one [-].
double difference(const Particles& a, const Particles& b)
{
    const auto of_a = boxes_of(a), of_b = boxes_of(b);
    double square = 0.0, largest = 0.0;
    int terms = 0;
    for (const auto& [place, box] : of_a) {
        const auto other = of_b.find(place);
        if (other == of_b.end() || box.volume < 0.99 * box_size * box_size) continue;
        const Box& second = other->second;
        square += std::pow(box.vertical / box.volume - second.vertical / second.volume, 2);
        square += std::pow(box.horizontal / box.volume - second.horizontal / second.volume, 2);
        largest = std::max(largest, -box.vertical / box.volume);
        terms += 2;
    }
    return std::sqrt(square / terms) / largest;
}

TEST(SettledSlope, IsTheSameWithTwoAndThreeParticlesAcrossACell)
{
    for (const std::string& law :
         {std::string("model = \"mohr_coulomb\"\nshear_modulus = 12e6\npoisson_ratio = 0.3\n"
                      "friction_angle = \"33 deg\"\ncohesion = 0\n"),
          std::string("model = \"ubcsand\"\nrelative_density = 0.5\n")}) {
        AssembledCase coarse = settling_slope(law, 2), fine = settling_slope(law, 3);
        const RelaxationReport two = relax(coarse.problem, {}, coarse.state);
        const RelaxationReport three = relax(fine.problem, {}, fine.state);
        EXPECT_LT(two.steps, 3000);
        EXPECT_LT(three.steps, 3000);
        EXPECT_LT(difference(coarse.state.particles, fine.state.particles), 0.01) << law;
    }
}

// Walls between grid lines took all forces of soil at rest, whose weight is their measure: without gravity
// it never came to rest.
TEST(WeightlessSoil, SettlesBetweenSlantedWalls)
{
    for (const double degrees : {0.0, 0.5, 13.0, 30.0}) {
        const auto corners =
            turned({{{0.0, 0.0}, "base"}, {{1.0, 0.0}, "right"}, {{1.0, 2.0}, "top"}, {{0.0, 2.0}, "left"}},
                   degrees, {1.5, 0.3});
        const std::string tables =
            elastic + "[gravity]\nacceleration = 0.0\n[boundaries.base]\nsoil = \"roller\"\n"
                      "[boundaries.left]\nsoil = \"roller\"\n[boundaries.right]\nsoil = \"roller\"\n"
                      "[boundaries.top]\npressure = 1000.0\n[relaxation]\nmax_steps = 20000\n";
        AssembledCase assembled =
            assemble(scene_with(0.1, {0.0, 0.0}, 32, 28, tables), polygon_section(corners));
        const RelaxationReport report =
            relax(assembled.problem, *assembled.scene.relaxation, assembled.state);
        EXPECT_TRUE(report.settled) << degrees;
        const Vector2 axis = turn({0.0, 1.0}, degrees);
        const Particles& particles = assembled.state.particles;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const double xx = particles.stress.xx[p], yy = particles.stress.yy[p],
                         xy = particles.stress.xy[p];
            const double along =
                axis.x() * axis.x() * xx + 2.0 * axis.x() * axis.y() * xy + axis.y() * axis.y() * yy;
            EXPECT_NEAR(along, -1000.0, 20.0) << degrees;
        }
    }
}

} // namespace
} // namespace quicksand
