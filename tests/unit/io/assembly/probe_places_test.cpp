#include "io/assembly/probe_places.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {

TEST(ProbePlaces, NearestParticleGoesByTheStartAndTheLowestNumber)
{
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    // (0.5, 0.5) is equally near to four particles; they have moved since, and the arrays are in another
    // order.
    const std::int32_t expected = state.particles.identifier[nearest_particle(state.particles, {0.5, 0.5})];
    for (double& x : state.particles.position.x) x += 0.3;
    std::vector<std::int32_t> order;
    for (std::size_t p = state.particles.size(); p-- > 0;) order.push_back(static_cast<std::int32_t>(p));
    reorder(state.particles, order);
    EXPECT_EQ(state.particles.identifier[nearest_particle(state.particles, {0.5, 0.5})], expected);
}

TEST(ProbePlaces, SurfaceIsTheHighestDomainOverTheLine)
{
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    Particles& particles = state.particles;
    const std::size_t p = nearest_particle(particles, {1.1, 1.4});
    EXPECT_EQ(surface_point(problem, particles, 1.1).particle, p);
    EXPECT_NEAR(surface_point(problem, particles, 1.1).height, 1.5, 1e-12);
    // a top that slopes up to the right by 0.1 over the half edge
    particles.half_edge_1.y[p] = 0.1;
    const double x = particles.position.x[p] + 0.5 * particles.half_edge_1.x[p];
    EXPECT_NEAR(surface_point(problem, particles, x).height, 1.55, 1e-12);
    EXPECT_FALSE(surface_point(problem, particles, 7.0).found);
}

// The top of a column that sways had left the line of its side, where the base alone was found.
TEST(ProbePlaces, SurfaceGoesOnBeyondTiedSides)
{
    Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    Particles& particles = state.particles;
    const double width = 2.0, highest = surface_point(problem, particles, 1.0).height;
    for (std::size_t p = 0; p < particles.size(); ++p)
        particles.position.x[p] -= 0.1 * particles.position.y[p];
    EXPECT_LT(surface_point(problem, particles, width).height, highest);
    problem.tied_sides = TiedSides{"left", "right", 0.0, width};
    const SurfacePoint surface = surface_point(problem, particles, width);
    EXPECT_NEAR(surface.height, highest, 1e-12);
    EXPECT_EQ(surface.shift, -width);
    for (double& x : particles.position.x) x += 3.5 * width; // drifted on
    const SurfacePoint drifted = surface_point(problem, particles, 0.6 * width);
    EXPECT_NEAR(drifted.height, highest, 1e-12);
    EXPECT_EQ(drifted.shift, 3.0 * width);
}

// Domains lean as soil moves, and leave hairlines.
TEST(ProbePlaces, ASurfaceIsNotSeenThroughAHairline)
{
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    Particles& particles = state.particles;
    const double x = 1.0, highest = surface_point(problem, particles, x).height;
    for (std::size_t p = 0; p < particles.size(); ++p)
        if (particles.position.y[p] > highest - 0.3)
            for (Scalars* edge : {&particles.half_edge_1.x, &particles.half_edge_2.x}) (*edge)[p] *= 0.999;
    EXPECT_EQ(surface_point(problem, particles, x).height, highest);
}

TEST(ProbePlaces, ASurfaceIsFoundWhereDomainsMeetButForRounding)
{
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    Particles& particles = state.particles;
    double edge = 0.0; // of the body, on its right
    for (std::size_t p = 0; p < particles.size(); ++p)
        edge = std::max(edge, particles.position.x[p] + std::abs(particles.half_edge_1.x[p]) +
                                  std::abs(particles.half_edge_2.x[p]));
    const SurfacePoint beside = surface_point(problem, particles, std::nextafter(edge, 2.0 * edge));
    EXPECT_TRUE(beside.found);
    EXPECT_NEAR(beside.height, surface_point(problem, particles, 0.999 * edge).height, 1e-9);
    EXPECT_FALSE(surface_point(problem, particles, 1.001 * edge).found);
}

} // namespace quicksand
