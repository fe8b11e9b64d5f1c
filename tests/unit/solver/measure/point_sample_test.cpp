#include "solver/measure/point_sample.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {

TEST(PointSample, FixedPointInterpolatesLinearFieldsExactly)
{
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    NodalFields fields = nodal_fields(problem, state.particles);
    for (std::size_t node = 0; node < problem.grid.node_count(); ++node) {
        const Vector2 place = problem.grid.node_position(node);
        fields.find("displacement")->components[0][node] = 0.01 * place.x() + 0.03 * place.y();
        fields.find("displacement")->components[1][node] = 0.02 * place.x() - 0.01 * place.y();
        fields.find("excess_pore_pressure")->components[0][node] = 100.0 * place.y();
    }
    const PointSample sample = sample_point(problem, fields, {1.1, 0.7});
    EXPECT_NEAR(sample["displacement"][0], 0.032, 1e-14);
    EXPECT_NEAR(sample["excess_pore_pressure"][0], 70.0, 1e-11);
    EXPECT_NEAR(sample["shear_strain_xy"][0], 0.05, 1e-14);
}

TEST(PointSample, NodesAroundThePointsAloneGiveTheSameBits)
{
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double x = particles.position.x[p], y = particles.position.y[p];
        particles.velocity_solid.set(p, {std::sin(3.0 * x), std::cos(2.0 * y)});
        particles.pore_pressure[p] = 1e3 * std::sin(x * y);
        particles.half_edge_2.x[p] += 0.1 * x; // sheared, over several cells
    }
    const NodalFields all = nodal_fields(problem, particles);
    const std::vector<Vector2> points = {{0.3, 0.2}, {1.1, 0.7}, {2.0, 1.5}, {9.0, 9.0}};
    const NodalFields some = nodal_fields_at(problem, particles, points);
    std::size_t left_out = 0;
    for (std::size_t node = 0; node < problem.grid.node_count(); ++node)
        left_out += all.volume[node] > 0.0 && some.volume[node] == 0.0;
    EXPECT_GT(left_out, 5u);
    for (const Vector2& point : points) {
        const PointSample expected = sample_point(problem, all, point);
        const PointSample found = sample_point(problem, some, point);
        if (std::isnan(expected["velocity_solid"][0])) {
            EXPECT_TRUE(std::isnan(found["velocity_solid"][0]));
            continue;
        }
        EXPECT_EQ(found.vector("velocity_solid"), expected.vector("velocity_solid"));
        EXPECT_EQ(found["excess_pore_pressure"][0], expected["excess_pore_pressure"][0]);
        EXPECT_EQ(found["shear_strain_xy"][0], expected["shear_strain_xy"][0]);
    }
}

TEST(PointSample, OutsideTheSoilThereIsNoValue)
{
    const Problem problem = fixtures::small_problem(true);
    const NodalFields fields = nodal_fields(problem, fixtures::small_state(problem).particles);
    const PointSample sample = sample_point(problem, fields, {1.0, 2.4});
    EXPECT_EQ(sample.vector("position"), Vector2(1.0, 2.4));
    EXPECT_TRUE(std::isnan(sample["velocity_solid"][0]));
    EXPECT_TRUE(std::isnan(sample["pore_pressure"][0]));
}

TEST(PointSample, AParticlesShearStrainFollowsItsEdges)
{
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    state.particles.half_edge_2.x[3] += 0.02 * state.particles.half_edge_2.y[3];
    EXPECT_NEAR(sample_particle(problem, state.particles, 3)["shear_strain_xy"][0], 0.02, 1e-14);
}

// The particle lies a quarter of a cell below the surface, which has strained as the soil around it.
TEST(PointSample, TheSurfaceMovesAsThePlaneThroughTheParticlesBelowIt)
{
    const Problem problem = fixtures::small_problem(false);
    State state = fixtures::small_state(problem);
    Particles& particles = state.particles;
    const auto motion = [](const Vector2& x) {
        return Vector2(1e-3 + 2e-2 * x.x() - 3e-2 * x.y(), -2e-3 + 1e-2 * x.x() - 5e-2 * x.y());
    };
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 drawn = particles.reference_position[p];
        particles.velocity_solid.set(p, motion(drawn));
        particles.position.set(p, drawn + motion(drawn));
        particles.stress.yy[p] = -1e3 * drawn.y();
    }
    for (const Vector2& drawn : {Vector2(0.9, 1.5), Vector2(1.1, 1.5), Vector2(0.0, 1.5)}) {
        std::size_t below = 0;
        for (std::size_t p = 1; p < particles.size(); ++p)
            if ((particles.reference_position[p] - drawn).norm() <
                (particles.reference_position[below] - drawn).norm())
                below = p;
        const Vector2 place = drawn + motion(drawn);
        const PointSample surface = sample_surface(problem, particles, below, place);
        EXPECT_LT((surface.vector("displacement") - motion(drawn)).norm(), 1e-12);
        EXPECT_LT((surface.vector("velocity_solid") - motion(drawn)).norm(), 1e-12);
        EXPECT_EQ(surface.vector("position"), place);
        const PointSample particle = sample_particle(problem, particles, below);
        EXPECT_EQ(surface["vertical_effective_stress"][0], particle["vertical_effective_stress"][0]);
    }
}

// Rows as high as a cell lie a cell apart.
TEST(PointSample, TheSurfaceMovesSoOverOneRowOfParticlesInACellToo)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 4, 3};
    problem.materials = {fixtures::stiff_sand()};
    State state;
    resize_particles(problem, 24, state.particles);
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 place(0.125 + 0.25 * static_cast<double>(p % 8),
                            0.25 + 0.5 * static_cast<double>(p / 8));
        particles.identifier[p] = static_cast<std::int32_t>(p);
        particles.position.set(p, place);
        particles.half_edge_1.set(p, {0.125, 0.0});
        particles.half_edge_2.set(p, {0.0, 0.25});
        particles.volume[p] = 0.125;
        particles.velocity_solid.set(p, {place.y() + 2.0 * place.x(), 3.0 * place.y()});
    }
    const Vector2 surface(1.0, 1.5);
    const Vector2 found = sample_surface(problem, particles, 20, surface).vector("velocity_solid");
    EXPECT_NEAR(found.x(), 3.5, 1e-12);
    EXPECT_NEAR(found.y(), 4.5, 1e-12);
}

// Stresses of neighbouring particles of liquefied sand are as far apart as they are large.
TEST(PointSample, AParticlesStressesAreThoseOfASmoothFieldAroundIt)
{
    const Problem problem = fixtures::small_problem(false);
    State state = fixtures::small_state(problem);
    Particles& particles = state.particles;
    const auto smooth = [](const Vector2& x) { return 2e3 + 7e3 * x.x() - 5e3 * x.y(); };
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 row = particles.position[p] / 0.25; // .5, 1.5, ...
        const bool black = (static_cast<int>(row.x()) + static_cast<int>(row.y())) % 2 == 0;
        const double stress = -smooth(particles.position[p]);
        particles.stress.xx[p] = particles.stress.yy[p] = particles.stress.zz[p] = stress;
        particles.stress.xy[p] = black ? 1e3 : -1e3;
    }
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const PointSample sample = sample_particle(problem, particles, p);
        const Vector2 x = particles.position[p];
        EXPECT_NEAR(sample["mean_effective_stress"][0], smooth(x), 1e-9);
        EXPECT_NEAR(sample["vertical_effective_stress"][0], smooth(x), 1e-9);
        const bool inside = x.x() > 0.25 && x.x() < 1.75 && x.y() > 0.25 && x.y() < 1.25;
        if (inside) {
            EXPECT_NEAR(sample["shear_stress_xy"][0], 0.0, 1e-9);
        }
    }
}

TEST(PointSample, AParticlesStressesAreThoseOfItsOwnSoil)
{
    Problem problem = fixtures::small_problem(false);
    problem.materials.push_back(problem.materials[0]);
    State state = fixtures::small_state(problem);
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        particles.material[p] = particles.position.y[p] > 0.75 ? 1 : 0; // in the middle of a cell
        particles.stress.xy[p] = particles.material[p] == 0 ? 1e3 : 2e3;
    }
    for (std::size_t p = 0; p < particles.size(); ++p)
        EXPECT_NEAR(sample_particle(problem, particles, p)["shear_stress_xy"][0], particles.stress.xy[p],
                    1e-9);
}

} // namespace quicksand
