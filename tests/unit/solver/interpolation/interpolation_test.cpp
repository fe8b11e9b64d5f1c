// The same questions to every member of the family.
#include "solver/base/failure.hpp"
#include "solver/interpolation/cpdi.hpp"
#include "solver/interpolation/cpdi2.hpp"
#include "solver/interpolation/gimp.hpp"
#include "solver/interpolation/linear_interpolation.hpp"
#include "solver/motion/particle_motion.hpp"
#include "tests/fixtures/node_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace quicksand {
namespace {

using fixtures::sample_grid;
using fixtures::sum_over_nodes;

/// Particles of many shapes: boxes inside a cell and across cells, stretched, sheared and turned;
/// quadrilaterals with a twist where the member has corners.
Particles many_shapes(bool twisted)
{
    const double shapes[6][8] = {{0.05, 0.35, 0.016, 0.0, 0.0, 0.016, 0.0, 0.0},
                                 {0.0, 0.4, 0.0166, 0.0, 0.0, 0.0166, 0.001, -0.002},
                                 {0.013, 0.377, 0.02, 0.011, -0.014, 0.02, 0.002, 0.003},
                                 {0.1, 0.5, 0.04, 0.01, 0.02, 0.045, -0.004, 0.006},
                                 {0.22, 0.41, 0.049, -0.02, 0.025, 0.03, 0.003, 0.001},
                                 {0.1001, 0.2999, 0.03, 0.0, 0.0, 0.03, 0.0, 0.004}};
    Particles particles;
    resize(particles, 6, std::nullopt);
    if (twisted) particles.twist.x = particles.twist.y = Scalars(6, 0.0);
    for (std::size_t p = 0; p < 6; ++p) {
        particles.position.set(p, {shapes[p][0], shapes[p][1]});
        particles.half_edge_1.set(p, {shapes[p][2], shapes[p][3]});
        particles.half_edge_2.set(p, {shapes[p][4], shapes[p][5]});
        if (twisted) particles.twist.set(p, {shapes[p][6], shapes[p][7]});
        particles.reference_edge_1.set(p, {0.016, 0.0});
        particles.reference_edge_2.set(p, {0.0, 0.014});
    }
    return particles;
}

template <class Member>
class InterpolationFamily : public testing::Test {
public:
    static constexpr bool twisted = std::is_same_v<Member, Cpdi2>;
};

using Members = testing::Types<LinearInterpolation, UniformGimp, ContiguousGimp, Cpdi, Cpdi2>;
TYPED_TEST_SUITE(InterpolationFamily, Members);

TYPED_TEST(InterpolationFamily, IsAPartitionOfUnity)
{
    const Particles particles = many_shapes(TestFixture::twisted);
    NodeStencil stencil;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        TypeParam::evaluate(sample_grid, particles, p, stencil);
        EXPECT_NEAR(sum_over_nodes(stencil, [](const NodeWeight& w, const Vector2&) { return w.value; }), 1.0,
                    1e-14);
        EXPECT_NEAR(sum_over_nodes(stencil, [](const NodeWeight& w, const Vector2&) { return w.gradient_x; }),
                    0.0, 1e-11);
        EXPECT_NEAR(sum_over_nodes(stencil, [](const NodeWeight& w, const Vector2&) { return w.gradient_y; }),
                    0.0, 1e-11);
    }
}

TYPED_TEST(InterpolationFamily, ReproducesALinearFieldAtTheParticleAndItsGradient)
{
    const auto field = [](const Vector2& x) { return 1.5 - 2.0 * x.x() + 0.7 * x.y(); };
    const Particles particles = many_shapes(TestFixture::twisted);
    NodeStencil stencil;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        TypeParam::evaluate(sample_grid, particles, p, stencil);
        const auto value = [&](const NodeWeight& w, const Vector2& x) { return w.value * field(x); };
        const auto slope_x = [&](const NodeWeight& w, const Vector2& x) { return w.gradient_x * field(x); };
        const auto slope_y = [&](const NodeWeight& w, const Vector2& x) { return w.gradient_y * field(x); };
        EXPECT_NEAR(sum_over_nodes(stencil, value), field(particles.position[p]), 1e-13) << p;
        EXPECT_NEAR(sum_over_nodes(stencil, slope_x), -2.0, 1e-11) << p;
        EXPECT_NEAR(sum_over_nodes(stencil, slope_y), 0.7, 1e-11) << p;
    }
}

/// Members whose gradient is the derivative of their value when the domain is carried along.
template <class Member>
class RigidFamily : public testing::Test {
};
using RigidMembers = testing::Types<LinearInterpolation, UniformGimp>;
TYPED_TEST_SUITE(RigidFamily, RigidMembers);

TYPED_TEST(RigidFamily, GradientIsTheDerivativeOfTheValue)
{
    const auto field = [](const Vector2& x) { return std::sin(9.0 * x.x()) * std::cos(7.0 * x.y()); };
    const auto value_at = [&](Particles particles, std::size_t p, const Vector2& step) {
        particles.position.set(p, particles.position[p] + step);
        NodeStencil stencil;
        TypeParam::evaluate(sample_grid, particles, p, stencil);
        return sum_over_nodes(stencil,
                              [&](const NodeWeight& w, const Vector2& x) { return w.value * field(x); });
    };
    const Particles particles = many_shapes(false);
    const double step = 1e-7;
    for (const std::size_t p : {0u, 2u, 4u}) { // away from cell edges, where the linear member has a kink
        NodeStencil stencil;
        TypeParam::evaluate(sample_grid, particles, p, stencil);
        const double by_gradient = sum_over_nodes(
            stencil, [&](const NodeWeight& w, const Vector2& x) { return w.gradient_x * field(x); });
        const double by_difference =
            (value_at(particles, p, {step, 0.0}) - value_at(particles, p, {-step, 0.0})) / (2.0 * step);
        EXPECT_NEAR(by_gradient, by_difference, 1e-6) << p;
    }
}

TEST(Cpdi2, AgreesWithGaussIntegrationOverTheQuadrilateral)
{
    // phi = 1/V int N dV and grad phi = 1/V int grad N dV, N bilinear between its corner values
    const Particles particles = many_shapes(true);
    const double point[3] = {-std::sqrt(0.6), 0.0, std::sqrt(0.6)},
                 weight[3] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto x = quadrilateral_corners(particles, p);
        const double value[4] = {0.3, -1.0, 2.0, 0.7}; // corner values of some nodal field
        double V = 0.0, phi = 0.0;
        Vector2 gradient = Vector2::Zero();
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b) {
                const double s = point[a], t = point[b];
                const double N[4] = {(1 - s) * (1 - t) / 4, (1 + s) * (1 - t) / 4, (1 + s) * (1 + t) / 4,
                                     (1 - s) * (1 + t) / 4};
                const double Ns[4] = {-(1 - t) / 4, (1 - t) / 4, (1 + t) / 4, -(1 + t) / 4};
                const double Nt[4] = {-(1 - s) / 4, -(1 + s) / 4, (1 + s) / 4, (1 - s) / 4};
                Vector2 xs = Vector2::Zero(), xt = Vector2::Zero();
                double f = 0.0, fs = 0.0, ft = 0.0;
                for (std::size_t c = 0; c < 4; ++c) {
                    xs += Ns[c] * x[c], xt += Nt[c] * x[c];
                    f += N[c] * value[c], fs += Ns[c] * value[c], ft += Nt[c] * value[c];
                }
                const double J = xs.x() * xt.y() - xs.y() * xt.x(), w = weight[a] * weight[b];
                V += w * J;
                phi += w * J * f;
                gradient += w * Vector2(xt.y() * fs - xs.y() * ft, -xt.x() * fs + xs.x() * ft);
            }
        }
        // the corner weights as Cpdi2 uses them: a linear nodal field through three corners is not enough, so
        // compare through the formula of the header
        const double area = 4.0 * (particles.half_edge_1[p].x() * particles.half_edge_2[p].y() -
                                   particles.half_edge_1[p].y() * particles.half_edge_2[p].x());
        EXPECT_NEAR(V, area, 1e-15);
        const auto corner_cross = [](const Vector2& u, const Vector2& v) {
            return u.x() * v.y() - u.y() * v.x();
        };
        const double a = corner_cross(x[3] - x[0], x[1] - x[2]), b = corner_cross(x[2] - x[3], x[0] - x[1]);
        const double w[4] = {6 * V - a - b, 6 * V - a + b, 6 * V + a + b, 6 * V + a - b};
        double expected = 0.0;
        for (int c = 0; c < 4; ++c) expected += w[c] * value[c] / (24.0 * V);
        EXPECT_NEAR(phi / V, expected, 1e-13) << p;
        const double gx =
            ((x[1].y() - x[3].y()) * (value[0] - value[2]) + (x[2].y() - x[0].y()) * (value[1] - value[3])) /
            (2 * V);
        EXPECT_NEAR(gradient.x() / V, gx, 1e-10) << p;
    }
}

TEST(Cpdi2, ShrinksAQuadrilateralThatReachesTooFar)
{
    const BackgroundGrid wide{{0.0, 0.0}, 0.1, 10, 10};
    Particles particles;
    resize(particles, 1, std::nullopt);
    particles.twist.x = particles.twist.y = Scalars(1, 0.0);
    set_quadrilateral({Vector2(0.1, 0.3), Vector2(0.9, 0.35), Vector2(0.85, 0.6), Vector2(0.15, 0.55)}, 0,
                      particles);
    NodeStencil stencil;
    EXPECT_TRUE(Cpdi2::evaluate(wide, particles, 0, stencil));
    EXPECT_LE(stencil.width, NodeStencil::max_width);
    double sum = 0.0, slope = 0.0;
    Vector2 centre = Vector2::Zero();
    for (int k = 0; k < stencil.width * stencil.height; ++k) {
        const Vector2 x =
            wide.node_position(stencil.column + k % stencil.width, stencil.row + k / stencil.width);
        sum += stencil.weights[k].value;
        centre += stencil.weights[k].value * x;
        slope += stencil.weights[k].gradient_x * x.x();
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_NEAR(slope, 1.0, 1e-13);
    EXPECT_LT((centre - particles.position[0]).norm(), 1e-14);
}

TEST(Cpdi2, CornersThatMoveKeepThePartOfTheAreaThatTheParticleCarries)
{
    const BackgroundGrid wide{{0.0, 0.0}, 0.1, 10, 10};
    Particles particles;
    resize(particles, 1, std::nullopt);
    particles.twist.x = particles.twist.y = Scalars(1, 0.0);
    set_quadrilateral({Vector2(0.41, 0.4), Vector2(0.46, 0.42), Vector2(0.48, 0.47), Vector2(0.42, 0.45)}, 0,
                      particles);
    particles.volume[0] = 0.9 * domain_area(particles, 0);
    const auto stretch = [&](std::size_t i) -> Vector2 { return {3.0 * wide.node_position(i).x(), 0.0}; };
    EXPECT_EQ(advance_quadrilaterals(wide, 0.1, stretch, particles), -1);
    EXPECT_NEAR(particles.volume[0], 0.9 * domain_area(particles, 0), 1e-17);
    EXPECT_NEAR(quadrilateral_corners(particles, 0)[0].x(), 1.3 * 0.41, 1e-15);
    const auto away = [](std::size_t) -> Vector2 { return {10.0, 0.0}; };
    EXPECT_EQ(advance_quadrilaterals(wide, 0.1, away, particles), -1);
    EXPECT_EQ(advance_quadrilaterals(wide, 0.1, away, particles), 0) << "a corner outside the grid";
}

// A box of length l that reaches over a line by o gives the node beyond o^2/(2 l), on either side: its force
// goes with o, and must find the mass that belongs to it.
TEST(Gimp, WhatJustReachesOverALineHasTheSquareOfTheOverlap)
{
    const BackgroundGrid unit{{0.0, 0.0}, 1.0, 8, 6};
    constexpr double l = 0.5, o = 1e-8;
    Particles particles;
    resize(particles, 1, std::nullopt);
    particles.reference_edge_1.set(0, {0.5 * l, 0.0});
    particles.reference_edge_2.set(0, {0.0, 0.5 * l});
    for (const double side : {-1.0, 1.0}) {
        const double edge = 3.0 + side * o; // of the box, beyond the line at 3
        particles.position.set(0, {1.5, edge - side * 0.5 * l});
        NodeStencil stencil;
        UniformGimp::evaluate(unit, particles, 0, stencil);
        ASSERT_EQ(stencil.height, 3);
        const NodeWeight* row = stencil.weights + (side > 0.0 ? 2 : 0) * stencil.width;
        double beyond = 0.0;
        for (int k = 0; k < stencil.width; ++k) beyond += row[k].value;
        EXPECT_NEAR(beyond, 0.5 * o * o / l, 1e-6 * o * o) << side;
    }
}

TEST(Cpdi2, ALostCornerEndsTheRun)
{
    State state;
    resize(state.particles, 1, std::nullopt);
    try {
        throw_lost_corner(1e-3, state, 0);
    } catch (const NumericalError& error) {
        EXPECT_EQ(error.record.what, "a corner of a particle's quadrilateral has left the grid");
        EXPECT_EQ(error.record.phase, "motion");
    }
}

TEST(Cpdi2, ShapeSurvivesTheRoundTripThroughItsCorners)
{
    Particles particles = many_shapes(true);
    const Particles before = particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        set_quadrilateral(quadrilateral_corners(particles, p), p, particles);
        EXPECT_LT((particles.position[p] - before.position[p]).norm(), 1e-15);
        EXPECT_LT((particles.twist[p] - before.twist[p]).norm(), 1e-15);
        EXPECT_LT((particles.half_edge_1[p] - before.half_edge_1[p]).norm(), 1e-15);
    }
}

} // namespace
} // namespace quicksand
