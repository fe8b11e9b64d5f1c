// What few particles about a node carry to it and take back must not grow, however they lie.
#include "solver/interpolation/cpdi.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step/two_phase_step.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace quicksand {
namespace {

/// Centre and half edges [cells].
struct Domain {
    Vector2 centre, half_edge_1, half_edge_2;
};

/// Nothing but the domains in space without gravity; their slopes have the length 1, their velocities none.
struct Cluster {
    Problem problem;
    State state;
};

void set_shapes(const std::vector<Domain>& domains, Particles& particles)
{
    for (std::size_t p = 0; p < domains.size(); ++p) {
        particles.identifier[p] = static_cast<std::int32_t>(p);
        particles.position.set(p, domains[p].centre);
        particles.half_edge_1.set(p, domains[p].half_edge_1);
        particles.half_edge_2.set(p, domains[p].half_edge_2);
        particles.volume[p] = 1.0 / 9.0;
        particles.mass_solid[p] = 150.0;
        if (particles.has_fluid()) particles.porosity[p] = 0.4;
    }
}

Cluster make_cluster(const std::vector<Domain>& domains, bool saturated, std::mt19937& random)
{
    Cluster cluster;
    cluster.problem.grid = {{0.0, 0.0}, 1.0, 6, 6};
    cluster.problem.materials = {fixtures::stiff_sand()};
    cluster.problem.gravity = 0.0;
    if (saturated) cluster.problem.water = fixtures::water_to(100.0);
    Particles& particles = cluster.state.particles;
    resize_particles(cluster.problem, domains.size(), particles);
    set_shapes(domains, particles);
    std::uniform_real_distribution<double> slope(-1.0, 1.0);
    for (std::size_t p = 0; p < domains.size(); ++p) {
        for (Gradients* C : {&particles.affine_velocity_solid, &particles.affine_velocity_fluid}) {
            if (C->xx.empty()) continue;
            for (Scalars* part : {&C->xx, &C->xy, &C->yx, &C->yy}) (*part)[p] = slope(random);
        }
    }
    begin_shaking(cluster.state);
    return cluster;
}

/// sum m sum phi |C d|^2 of the grains' slopes about the particles.
double carried_energy(const Cluster& cluster)
{
    const BackgroundGrid& grid = cluster.problem.grid;
    const Particles& particles = cluster.state.particles;
    const Gradients& C = particles.affine_velocity_solid;
    double energy = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        NodeStencil stencil;
        Cpdi::evaluate(grid, particles, p, stencil);
        for (int k = 0; k < stencil.width * stencil.height; ++k) {
            const Vector2 d =
                grid.node_position(stencil.column + k % stencil.width, stencil.row + k / stencil.width) -
                particles.position[p];
            const Vector2 v(C.xx[p] * d.x() + C.xy[p] * d.y(), C.yx[p] * d.x() + C.yy[p] * d.y());
            energy += particles.mass_solid[p] * stencil.weights[k].value * v.squaredNorm();
        }
    }
    return energy;
}

/// Steps so short that nothing moves: only what is carried there and back changes.
void carry(int steps, Cluster& cluster)
{
    constexpr double dt = 1e-15;
    if (cluster.problem.water) {
        TwoPhaseWorkspace work = make_two_phase_workspace(cluster.problem);
        for (int k = 0; k < steps; ++k) advance_two_phase_step(cluster.problem, dt, cluster.state, work);
    } else {
        SinglePhaseWorkspace work = make_single_phase_workspace(cluster.problem);
        for (int k = 0; k < steps; ++k)
            advance_single_phase_step(cluster.problem, dt, 0.0, cluster.state, work);
    }
}

TEST(AffineVelocity, OfTwoStretchedDomainsAboutANodeDoesNotGrow)
{
    // gradients would gain 0.75 % a step
    const std::vector<Domain> pair = {{{1.780, 1.222}, {-0.194, 0.724}, {-0.098, -0.026}},
                                      {{1.806, 1.340}, {-0.701, -0.170}, {0.030, -0.124}}};
    for (const bool saturated : {false, true}) {
        std::mt19937 random(7);
        Cluster cluster = make_cluster(pair, saturated, random);
        const double start = carried_energy(cluster);
        carry(4000, cluster);
        EXPECT_LT(carried_energy(cluster), start);
        for (const double v : cluster.state.particles.velocity_solid.x) EXPECT_LT(std::abs(v), 1e-9);
    }
}

TEST(AffineVelocity, OfFewDomainsOfAnyShapeNeverGains)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<Domain> domains(static_cast<std::size_t>(2 + trial % 5));
        for (Domain& domain : domains) {
            const double angle = 6.283 * unit(random), a = 0.03 * std::pow(60.0, unit(random));
            const double b = std::min(1.8, 0.03 * std::pow(60.0, unit(random)));
            const double shear = unit(random) - 0.5;
            const Vector2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
            domain = {Vector2(2.5 + unit(random), 2.5 + unit(random)), a * along,
                      b * across + shear * std::min(a, b) * along};
        }
        Cluster cluster = make_cluster(domains, false, random);
        double before = carried_energy(cluster);
        for (int k = 0; k < 5; ++k) {
            carry(1, cluster);
            const double after = carried_energy(cluster);
            EXPECT_LE(after, before * (1.0 + 1e-12)) << "trial " << trial;
            before = after;
        }
    }
}

TEST(AffineVelocity, OfALinearMotionIsItsGradient)
{
    std::vector<Domain> domains = {{{1.5, 2.2}, {0.16, 0.0}, {0.0, 0.16}},
                                   {{2.001, 3.0}, {0.3, 0.1}, {-0.2, 0.1}},
                                   {{3.0, 2.3}, {0.7, 0.6}, {0.2, 0.3}},
                                   {{3.99, 3.5}, {0.02, 0.0}, {0.0, 0.02}}};
    for (const double x : {1.4, 2.4, 3.4, 4.4}) // motion at all their nodes
        for (const double y : {1.4, 2.4, 3.4, 4.4})
            domains.push_back({Vector2(x, y), Vector2(0.2, 0.0), Vector2(0.0, 0.2)});
    Eigen::Matrix2d slope;
    slope << 1.0, -4.0, 3.0, 2.0;
    for (const Interpolation interpolation :
         {Interpolation::gimp, Interpolation::cpgimp, Interpolation::cpdi, Interpolation::cpdi2}) {
        std::mt19937 random(7);
        Cluster cluster = make_cluster(domains, true, random);
        cluster.problem.interpolation = interpolation;
        resize_particles(cluster.problem, domains.size(), cluster.state.particles);
        Particles& particles = cluster.state.particles;
        set_shapes(domains, particles);
        for (std::size_t p = 0; p < domains.size(); ++p) {
            const Vector2 v = slope * particles.position[p] + Vector2(5.0, 0.0);
            particles.velocity_solid.set(p, v);
            particles.velocity_fluid.set(p, v);
        }
        const auto fill_affine = [&](Gradients& C) {
            const std::size_t n = domains.size();
            C = {Scalars(n, slope(0, 0)), Scalars(n, slope(0, 1)), Scalars(n, slope(1, 0)),
                 Scalars(n, slope(1, 1))};
        };
        fill_affine(particles.affine_velocity_solid);
        fill_affine(particles.affine_velocity_fluid);
        begin_shaking(cluster.state);
        carry(3, cluster);
        for (const Gradients* C : {&particles.affine_velocity_solid, &particles.affine_velocity_fluid}) {
            for (std::size_t p = 0; p < domains.size(); ++p) {
                Eigen::Matrix2d found;
                found << C->xx[p], C->xy[p], C->yx[p], C->yy[p];
                EXPECT_LT((found - slope).norm(), 1e-8)
                    << "interpolation " << static_cast<int>(interpolation);
            }
        }
    }
}

TEST(AffineVelocity, OfAPointOnALineBetweenNodesIsNoneAcrossIt)
{
    std::mt19937 random(7);
    Cluster cluster = make_cluster({{{2.0, 2.5}, {0.1, 0.0}, {0.0, 0.1}}}, false, random);
    cluster.problem.interpolation = Interpolation::linear;
    Gradients& C = cluster.state.particles.affine_velocity_solid;
    C = {{1.0}, {2.0}, {3.0}, {4.0}};
    carry(1, cluster);
    EXPECT_EQ(C.xx[0], 0.0);
    EXPECT_NEAR(C.xy[0], 2.0, 1e-10);
    EXPECT_EQ(C.yx[0], 0.0);
    EXPECT_NEAR(C.yy[0], 4.0, 1e-10);
}

} // namespace
} // namespace quicksand
