// Two soils in one cell strain as layers that touch along a plane.
#include "solver/cell_strain/cell_stress.hpp"
#include "solver/cell_strain/soil_layers.hpp"
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
    problem.gravity = 0.0;
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
    CellStrain strain = make_cell_strain(problem, Stage::shaking);
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

// The stress of neo-Hookean soil is that of its deformation: a jump of the strain rate would not reach it.
TEST(SoilLayers, LeaveSoilAloneWhoseStressFollowsItsDeformation)
{
    Problem problem = three_by_three_cells();
    problem.materials[1].law = NeoHookean{G_soft, nu};
    EXPECT_TRUE(make_shared_soils(problem, Stage::shaking).of_material[1] < 0);
    problem.materials.resize(2);
    EXPECT_TRUE(make_shared_soils(problem, Stage::shaking).of_material.empty());
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

// A stiff seam that fills no cell bears by its shear, as a wall does; a soft one does not.
TEST(SoilLayers, LetAStiffSeamShearWithItsCell)
{
    Problem problem = three_by_three_cells();
    std::get<LinearElastic>(problem.materials[0].law).shear_modulus = G_soft;
    std::get<LinearElastic>(problem.materials[1].law).shear_modulus = G_stiff;
    const Particles particles =
        strained(problem, [](const Vector2& x) { return std::abs(x.y() - 1.5) < 0.25 ? 1 : 0; });
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double G = particles.material[p] == 1 ? G_stiff : G_soft;
        EXPECT_NEAR(particles.stress.xy[p], 2e-5 * G, 1e-3 * G * 2e-5); // a spin of 2e-5 turns e_xx - e_yy
    }
}

// Water that cannot leave has one pressure for both: neither changes its volume otherwise than the other.
TEST(SoilLayers, ShareWaterThatCannotFlow)
{
    Problem problem = three_by_three_cells();
    problem.water = fixtures::water_to(3.0);
    problem.water->flow = WaterFlow::undrained;
    const Particles particles = strained(problem, [](const Vector2& x) { return x.y() > 1.25 ? 1 : 0; });
    const double shear = 2e-5 / (0.25 / G_stiff + 0.75 / G_soft);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!is_in_middle(particles, p)) continue;
        const double G = particles.material[p] == 1 ? G_soft : G_stiff;
        EXPECT_NEAR(particles.stress.yy[p], G * (2e-6 - 3.0 * 1e-5), 1e-4 * G * 3e-5);
        EXPECT_NEAR(particles.stress.xy[p], shear, 1e-3 * shear);
    }
}

// Level ground of two soils of unlike weight, at rest with K0: faces within cells leave it there, though the
// means of both soils lie at unlike depths.
TEST(SoilLayers, LeaveGroundAtRestThatYields)
{
    constexpr double height = 3.0, phi = 0.5;
    Problem problem = three_by_three_cells();
    problem.strain = StrainForm::small;
    for (std::size_t m = 0; m < 3; ++m) {
        problem.materials[m].law =
            MohrCoulomb{.shear_modulus = 10e6, .poisson_ratio = 0.3, .friction_angle = phi};
        problem.materials[m].porosity = m == 1 ? 0.6 : 0.3;
    }
    State state = fixtures::fill(problem, 4, [](const Vector2&) { return true; });
    Particles& particles = state.particles;
    const double k0 = (1.0 - std::sin(phi)) / (1.0 + std::sin(phi)); // active: at failure
    const double light = 0.4 * 2650.0 * 9.81, heavy = 0.7 * 2650.0 * 9.81, face = 1.25;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double y = particles.position.y[p];
        particles.material[p] = y > face ? 1 : 0;
        particles.mass_solid[p] = (y > face ? 0.4 : 0.7) * 2650.0 * particles.volume[p];
        const double vertical =
            y > face ? light * (height - y) : light * (height - face) + heavy * (face - y);
        particles.stress.yy[p] = -vertical;
        particles.stress.xx[p] = particles.stress.zz[p] = -k0 * vertical;
    }
    problem.gravity = 9.81;
    CellLists lists = make_cell_lists(problem.grid);
    sort_particles(problem.grid, 0.0, state, lists);
    CellStrain strain = make_cell_strain(problem, Stage::shaking);
    for (int step = 0; step < 100; ++step) update_stress_of_cells(problem, dt, lists, particles, strain);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double y = particles.position.y[p];
        const double vertical =
            y > face ? light * (height - y) : light * (height - face) + heavy * (face - y);
        EXPECT_NEAR(particles.stress.yy[p], -vertical, 0.02 * light * height) << y;
    }
}

TEST(SoilLayers, CostNothingInOneSoil)
{
    Problem problem = three_by_three_cells();
    problem.materials.resize(1);
    EXPECT_TRUE(make_cell_strain(problem, Stage::shaking).shared.of_material.empty());
}

// Specific volumes of sand, and the weight of a cell, which its settling form knows, hang on the density of
// the grains.
TEST(SoilLayers, SandsThatDifferByWeightAloneAreOne)
{
    Problem problem = three_by_three_cells();
    UbcSandParameters heavy = nevada_sand_55();
    heavy.largest_specific_volume = 7e-4; // [m3/kg]
    const UbcSand sand = make_ubcsand(nevada_sand_55()), heavier = make_ubcsand(heavy);
    for (const bool settles : {false, true}) {
        problem.materials[0].law = settles ? SkeletonLaw(settling_form(sand, 10e3)) : SkeletonLaw(sand);
        problem.materials[2].law = settles ? SkeletonLaw(settling_form(heavier, 11e3)) : SkeletonLaw(heavier);
        const SharedSoils shared = make_shared_soils(problem, Stage::relaxation);
        EXPECT_EQ(shared.of_material[2], shared.of_material[0]);
        EXPECT_NE(shared.of_material[1], shared.of_material[0]);
    }
}

} // namespace
} // namespace quicksand
