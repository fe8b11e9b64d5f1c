// Two soils in one cell strain as layers that touch along a plane.
#include "solver/motion/cell_stress.hpp"
#include "solver/motion/particle_order.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace quicksand {
namespace {

constexpr double G_stiff = 80e6, G_soft = 2e6, nu = 0.25, dt = 1e-3; // M = 3 G

/// Three by three cells; the soft soil is material 1, a third one 2.
Problem three_by_three_cells()
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0, 3, 3};
    problem.materials = {fixtures::stiff_sand(), fixtures::stiff_sand(), fixtures::stiff_sand()};
    for (std::size_t m = 0; m < 3; ++m)
        problem.materials[m].law = LinearElastic{m == 1 ? G_soft : G_stiff, nu};
    return problem;
}

/// The particles after a step with the same velocity gradients for all, from rest without stress.
Particles strained(const Problem& problem, const std::function<std::int32_t(const Vector2&)>& material)
{
    State state = fixtures::fill(problem, 4, [](const Vector2&) { return true; });
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        particles.material[p] = material(particles.position[p]);
        particles.velocity_gradient_solid.xx[p] = 0.002;
        particles.velocity_gradient_solid.xy[p] = 0.03;
        particles.velocity_gradient_solid.yx[p] = -0.01;
        particles.velocity_gradient_solid.yy[p] = -0.01;
    }
    CellLists lists = make_cell_lists(problem.grid);
    sort_particles(problem.grid, 0.0, state, lists);
    CellStrain strain = make_cell_strain(problem);
    update_stress_of_cells(problem, dt, lists, particles, strain);
    return particles;
}

Vector2 traction(const Particles& particles, std::size_t p, const Vector2& n)
{
    const SymmetricTensors& s = particles.stress;
    return {s.xx[p] * n.x() + s.xy[p] * n.y(), s.xy[p] * n.x() + s.yy[p] * n.y()};
}

bool is_in_middle(const Particles& particles, std::size_t p)
{
    return (particles.position[p] - Vector2(1.5, 1.5)).cwiseAbs().maxCoeff() < 0.5;
}

/// Every particle of the middle cell has the same traction on the plane of normal n, within 1e-9 of it;
/// returns it.
Vector2 common_traction(const Particles& particles, const Vector2& n)
{
    Vector2 common = Vector2::Zero();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!is_in_middle(particles, p)) continue;
        const Vector2 t = traction(particles, p, n);
        if (common.isZero(0.0)) common = t;
        EXPECT_NEAR((t - common).norm(), 0.0, 1e-9 * common.norm());
    }
    return common;
}

TEST(SoilLayers, StrainInSeriesAcrossALevelFace)
{
    const Problem problem = three_by_three_cells();
    const Particles particles = strained(problem, [](const Vector2& x) { return x.y() > 1.25 ? 1 : 0; });
    const Vector2 t = common_traction(particles, Vector2::UnitY());
    // a quarter stiff: with e_xx that of both, M = 3 G and lambda = G
    //   s_yy (1/4/M_1 + 3/4/M_2) = e_yy + e_xx (1/4 lambda/M + 3/4 lambda/M)
    const double e_xx = 2e-6, e_yy = -1e-5, gamma = 2e-5;
    const double compliance = 0.25 / G_stiff + 0.75 / G_soft;
    EXPECT_NEAR(t.y(), 3.0 * (e_yy + e_xx / 3.0) / compliance, 1e-9 * std::abs(t.y()));
    EXPECT_NEAR(t.x(), gamma / compliance, 1e-9 * std::abs(t.x()));
}

TEST(SoilLayers, KnowAFaceAtAnyAngle)
{
    const Problem problem = three_by_three_cells();
    const Particles particles =
        strained(problem, [](const Vector2& x) { return x.x() + x.y() > 3.01 ? 1 : 0; });
    common_traction(particles, Vector2(1.0, 1.0).normalized());
}

TEST(SoilLayers, KnowASeamWithinARowOfCells)
{
    const Problem problem = three_by_three_cells();
    const Particles particles =
        strained(problem, [](const Vector2& x) { return std::abs(x.y() - 1.5) < 0.25 ? 1 : 0; });
    const Vector2 t = common_traction(particles, Vector2::UnitY());
    EXPECT_NEAR(t.x(), 2e-5 / (0.5 / G_stiff + 0.5 / G_soft), 1e-9 * std::abs(t.x()));
}

TEST(SoilLayers, OfThreeSoilsBearTheirMeanTractions)
{
    const Problem problem = three_by_three_cells();
    const Particles particles =
        strained(problem, [](const Vector2& x) { return x.y() > 1.5 ? 1 : (x.y() > 1.25 ? 2 : 0); });
    common_traction(particles, Vector2::UnitY()); // 0 and 2 are alike
}

// As if the others were not there: away from the face, and of the velocity gradients, nothing changes.
TEST(SoilLayers, LeaveCellsOfOneSoilAndTheMotion)
{
    const Problem problem = three_by_three_cells();
    const Particles particles = strained(problem, [](const Vector2& x) { return x.y() > 1.25 ? 1 : 0; });
    for (std::size_t p = 0; p < particles.size(); ++p) {
        EXPECT_EQ(particles.velocity_gradient_solid.xy[p], 0.03);
        EXPECT_EQ(particles.velocity_gradient_solid.yx[p], -0.01);
        EXPECT_EQ(particles.velocity_gradient_solid.yy[p], -0.01);
        const double y = particles.position.y[p], G = y < 1.0 ? G_stiff : G_soft;
        if (y > 1.0 && y < 2.0) continue;
        EXPECT_NEAR(particles.stress.yy[p], G * (2e-6 - 3.0 * 1e-5), 1e-9 * G);
    }
}

// Where one of the soils is dry, the total stresses are equal: grains of both bear a part of the pressure.
TEST(SoilLayers, BearTheWaterBetweenThem)
{
    Problem problem = three_by_three_cells();
    problem.strain = StrainForm::small;
    State state = fixtures::fill(problem, 4, [](const Vector2&) { return true; });
    Particles& particles = state.particles;
    particles.pore_pressure.assign(particles.size(), 0.0);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        particles.material[p] = particles.position.y[p] < 1.5 ? 0 : 1;
        if (particles.material[p] == 0) particles.pore_pressure[p] = 4000.0;
    }
    CellLists lists = make_cell_lists(problem.grid);
    sort_particles(problem.grid, 0.0, state, lists);
    CellStrain strain = make_cell_strain(problem);
    update_stress_of_cells(problem, dt, lists, particles, strain);
    const double jump = 4000.0 / (0.5 * 3.0 * (G_stiff + G_soft)); // of e_yy
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!is_in_middle(particles, p)) continue;
        const bool is_wet = particles.material[p] == 0;
        const double expected = (is_wet ? 3.0 * G_stiff : -3.0 * G_soft) * 0.5 * jump;
        EXPECT_NEAR(particles.stress.yy[p], expected, 1e-6 * std::abs(expected));
    }
}

TEST(SoilLayers, CostNothingInOneSoil)
{
    Problem problem = three_by_three_cells();
    problem.materials.resize(1);
    EXPECT_TRUE(make_cell_strain(problem).soil_of.empty());
}

} // namespace
} // namespace quicksand
