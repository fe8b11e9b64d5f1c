// The cell's rate of volume change in place of the particle's, where a material asks for it.
#include "solver/cell_strain/cell_stress.hpp"
#include "solver/measure/balances.hpp"
#include "solver/motion/particle_order.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

Problem two_by_two_cells(VolumetricStrain strain)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0, 2, 2};
    problem.materials = {fixtures::stiff_sand()};
    problem.materials[0].volumetric_strain = strain;
    return problem;
}

State filled(const Problem& problem)
{
    return fixtures::fill(problem, 2, [](const Vector2&) { return true; });
}

/// Rates of volume change that alternate within every cell about a mean, 0.03 in the left cells and -0.01 in
/// the right ones [1/s]; and a shear of 0.2.
void set_alternating_rates(Particles& particles)
{
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 x = particles.position[p];
        const double mean = x.x() < 1.0 ? 0.03 : -0.01;
        const double sign =
            std::fmod(std::floor(2.0 * x.x()) + std::floor(2.0 * x.y()), 2.0) < 1.0 ? 1.0 : -1.0;
        particles.velocity_gradient_solid.xx[p] = mean + 0.5 * sign;
        particles.velocity_gradient_solid.xy[p] = 0.2;
    }
}

Particles stressed(const Problem& problem)
{
    State state = filled(problem);
    CellLists lists = make_cell_lists(problem.grid);
    sort_particles(problem.grid, 0.0, state, lists);
    set_alternating_rates(state.particles);
    CellStrain strain = make_cell_strain(problem, Stage::shaking);
    update_stress_of_cells(problem, 1e-3, lists, state.particles, strain);
    return state.particles;
}

double mean_stress(const Particles& particles, std::size_t p)
{
    const SymmetricTensors& s = particles.stress;
    return (s.xx[p] + s.yy[p] + s.zz[p]) / 3.0;
}

TEST(VolumetricAverage, GivesTheParticlesOfACellOneMeanStress)
{
    const Problem problem = two_by_two_cells(VolumetricStrain::cell);
    const Particles particles = stressed(problem);
    const double K = lame_modulus(std::get<LinearElastic>(problem.materials[0].law)) + 200e6 / 3.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double rate = particles.position.x[p] < 1.0 ? 0.03 : -0.01;
        // in the plane: the out-of-plane strain stays zero
        EXPECT_NEAR(mean_stress(particles, p), K * rate * 1e-3, 1e-9 * K);
        EXPECT_NEAR(particles.stress.xy[p], 100e6 * 0.2e-3, 0.2 * 100e6 * 1e-3 * 1e-3);
    }
}

TEST(VolumetricAverage, LeavesTheParticlesTheirOwnRates)
{
    const Particles particles = stressed(two_by_two_cells(VolumetricStrain::cell));
    for (std::size_t p = 0; p < particles.size(); ++p)
        EXPECT_NEAR(std::abs(particles.velocity_gradient_solid.xx[p] -
                             (particles.position.x[p] < 1.0 ? 0.03 : -0.01)),
                    0.5, 1e-15);
}

TEST(VolumetricAverage, CostsNothingWhereNoMaterialAsks)
{
    const Problem problem = two_by_two_cells(VolumetricStrain::particle);
    EXPECT_TRUE(make_volumetric_average(problem).of_strain.empty());
    const Particles particles = stressed(problem);
    EXPECT_GT(std::abs(mean_stress(particles, 0)), 1e4);
}

// A block of sand that falls apart on its base: it was free of stress, so that it has nothing to give. Its
// skeleton dissipates; with the cell's rate of volume change it gave back more than the weight did.
TEST(VolumetricAverage, MakesNoEnergyInSoilThatDilates)
{
    Problem problem;
    problem.grid = {{-4.0, 0.0}, 1.0, 12, 8};
    Material sand = fixtures::stiff_sand();
    constexpr double degree = 0.017453292519943295;
    sand.law = MohrCoulomb{.shear_modulus = 25e6,
                           .poisson_ratio = 0.45,
                           .friction_angle = 30.0 * degree,
                           .dilation_angle = 25.0 * degree};
    sand.volumetric_strain = VolumetricStrain::cell;
    problem.materials = {sand};
    problem.boundaries = fixtures::rectangle(0.0, 0.0, 4.0, 4.0, FixedWall{}, FreeFace{}, FreeFace{});
    State state = fixtures::fill(problem, 3,
                                 [](const Vector2& x) { return x.x() > 0.0 && x.x() < 4.0 && x.y() < 4.0; });
    open_balances(problem, state);
    EXPECT_TRUE(run(problem, 0.25, {}, state));
    EXPECT_GT(state.balance_terms->gravity_work, 0.0);
    EXPECT_GT(state.balance_terms->skeleton_work, 0.0);
    EXPECT_LT(balance(problem, state).numerical_loss, 0.5 * state.balance_terms->gravity_work);
}

// Nodes that feel the mean of the dilating soil alone did up to 0.8 % less work than both soils.
TEST(VolumetricAverage, LetsNodesDoTheWorkOfBothSoilsWhereOneDilates)
{
    Problem problem = two_by_two_cells(VolumetricStrain::cell);
    problem.materials.push_back(problem.materials[0]);
    problem.materials[1].law = MohrCoulomb{
        .shear_modulus = 25e6, .poisson_ratio = 0.3, .friction_angle = 0.5, .dilation_angle = 0.3};
    State state = filled(problem);
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p)
        particles.material[p] = std::fmod(particles.position.y[p], 1.0) < 0.5 ? 0 : 1;
    CellLists lists = make_cell_lists(problem.grid);
    sort_particles(problem.grid, 0.0, state, lists);
    set_alternating_rates(particles);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        particles.stress.xx[p] = -1e3 * std::fmod(7.0 * static_cast<double>(p), 5.0);
        particles.stress.yy[p] = -2e3 * std::fmod(3.0 * static_cast<double>(p), 7.0);
    }
    const auto power = [&](const Gradients& L, const SymmetricTensors& stress) {
        double sum = 0.0;
        for (std::size_t p = 0; p < particles.size(); ++p)
            sum += particles.volume[p] * (stress.xx[p] * L.xx[p] + stress.yy[p] * L.yy[p]);
        return sum;
    };
    const VolumetricAverage average = make_volumetric_average(problem);
    const Gradients own_rates = particles.velocity_gradient_solid;
    const SymmetricTensors own_stress = particles.stress;
    average_volume_change(lists, average, particles);
    average_mean_stress(lists, average, particles);
    const double of_law = power(particles.velocity_gradient_solid, own_stress);
    EXPECT_NEAR(power(own_rates, particles.stress), of_law, 1e-12 * std::abs(of_law));
    EXPECT_GT(std::abs(power(own_rates, own_stress) - of_law), 0.01 * std::abs(of_law));
}

TEST(VolumetricAverage, PassesOverTheParticlesOfOtherMaterials)
{
    Problem problem = two_by_two_cells(VolumetricStrain::particle);
    problem.materials.push_back(problem.materials[0]);
    problem.materials[1].volumetric_strain = VolumetricStrain::cell;
    State state = filled(problem);
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        state.particles.material[p] = state.particles.position.y[p] < 0.5 ? 0 : 1;
    CellLists lists = make_cell_lists(problem.grid);
    sort_particles(problem.grid, 0.0, state, lists);
    set_alternating_rates(state.particles);
    const Scalars rates = state.particles.velocity_gradient_solid.xx;
    CellStrain strain = make_cell_strain(problem, Stage::shaking);
    update_stress_of_cells(problem, 1e-3, lists, state.particles, strain);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        if (state.particles.material[p] != 0) continue;
        const double M = constrained_modulus(std::get<LinearElastic>(problem.materials[0].law));
        EXPECT_NEAR(state.particles.stress.xx[p], M * rates[p] * 1e-3, 2e-3 * M * 1e-3);
    }
}

} // namespace
} // namespace quicksand
