// What the water of the pores is made of and how fast it flows: air, cavities, conductivity.
#include "solver/step_length/time_step_control.hpp"
#include "solver/water/pore_pressure.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace quicksand {
namespace {

using namespace fixtures;

TEST(Permeability, FollowsThePorosityByItsLaw)
{
    Material sand = stiff_sand();
    sand.porosity = 0.4;
    sand.hydraulic_conductivity = 1e-4;
    EXPECT_EQ(hydraulic_conductivity(sand, 0.3), 1e-4);
    sand.permeability_law = PermeabilityLaw::kozeny_carman;
    EXPECT_DOUBLE_EQ(hydraulic_conductivity(sand, 0.4), 1e-4);
    // 0.027/0.49 over 0.064/0.36
    EXPECT_NEAR(hydraulic_conductivity(sand, 0.3), 0.309949e-4, 1e-10);
    sand.permeability_law = PermeabilityLaw::specific_volume_squared;
    // the specific volume 1 + e falls from 1/0.6 to 1/0.7
    EXPECT_NEAR(hydraulic_conductivity(sand, 0.3), 0.734694e-4, 1e-10);
}

TEST(Permeability, SetsTheDrag)
{
    Material sand = stiff_sand();
    const double before = drag_coefficient(sand, water_to(0.0), 0.5);
    sand.permeability_law = PermeabilityLaw::kozeny_carman;
    const double ratio = hydraulic_conductivity(sand, 0.5) / sand.hydraulic_conductivity;
    EXPECT_GT(ratio, 1.0);
    EXPECT_DOUBLE_EQ(drag_coefficient(sand, water_to(0.0), 0.5), before / ratio);
}

TEST(EntrappedAir, SoftensTheWaterAndSlowsTheUndrainedWave)
{
    EXPECT_DOUBLE_EQ(modulus_with_air(2.2e9, 1.0, 1e5), 2.2e9);
    // one per cent of air at 100 kPa: 0.99/2.2e9 + 0.01/1e5 = 1.0045e-7
    EXPECT_NEAR(modulus_with_air(2.2e9, 0.99, 1e5), 9.95520e6, 20.0);
    Water water = water_to(0.0);
    water.bulk_modulus = modulus_with_air(2.2e9, 0.99, 1e5);
    const Material sand = stiff_sand();
    const double M = 350e6, density = 0.57 * 2650.0 + 0.43 * 1000.0;
    EXPECT_NEAR(wave_speeds(sand, water, 0.43).undrained, std::sqrt((M + 9.9552e6 / 0.43) / density), 0.01);
    EXPECT_NEAR(wave_speeds(sand, water_to(0.0), 0.43).undrained / wave_speeds(sand, water, 0.43).undrained,
                3.8, 0.1);
}

/// Cells whose pressure changes by given amounts in semi-implicit steps of changing length.
class ActingPressure : public testing::Test {
protected:
    ActingPressure()
    {
        problem_.grid = {{0.0, 0.0}, 0.1, 3, 3};
        problem_.materials = {stiff_sand()};
        problem_.water = water_to(0.0);
        state_ = fill(problem_, 2, [](const Vector2&) { return true; });
        state_.particles.pore_pressure_rate.assign(state_.particles.size(), 0.0);
        lists_ = make_cell_lists(problem_.grid);
        update_cell_lists(problem_.grid, state_.particles, lists_);
        means_ = make_cell_means(problem_);
        for (Scalars* by_cell : {&storage_, &expected_, &increment_, &change_})
            by_cell->resize(problem_.grid.cell_count());
    }

    /// Let the pressure change by `rate` times dt; returns what it acts with beyond the pressure before [Pa].
    double advance(double dt, double rate)
    {
        Particles& particles = state_.particles;
        for_each_tile(lists_, [&](const Tile& tile) {
            prepare_increments(problem_, dt, lists_, tile, particles, storage_, expected_);
        });
        for (std::size_t c = 0; c < change_.size(); ++c) {
            change_[c] = dt * rate;
            increment_[c] = acting_weight * change_[c] - expected_[c];
        }
        advance_solved_pressure(problem_, dt, lists_, {expected_, increment_, change_}, particles, means_);
        return increment_[static_cast<std::size_t>(lists_.cell_of_particle[0])];
    }

    Problem problem_;
    State state_;
    CellLists lists_;
    CellMeans means_;
    Scalars storage_, expected_, increment_, change_;
};

TEST_F(ActingPressure, IsThatBeforeTheStepWhereThePressureGrowsSteadily)
{
    for (int step = 0; step < 40; ++step) advance(step % 2 == 0 ? 0.1 : 0.07, 50.0);
    EXPECT_NEAR(state_.particles.pore_pressure_rate[0], 50.0, 1e-12);
    EXPECT_NEAR(advance(0.1, 50.0), 0.0, 1e-12);
    EXPECT_NEAR(state_.particles.pore_pressure[0], 20 * 50.0 * 0.17 + 5.0, 1e-9);
}

TEST_F(ActingPressure, OfAVibrationTakesEnergyInItsThirdOrderAlone)
{
    // p = Re z^k with z = e^(i angle) acts as Re G z^k, G = 1 + b (z-1)^2/(z-1+b)
    const double angle = 0.2, dt = 0.01;
    const std::complex<double> z = std::polar(1.0, angle);
    const std::complex<double> G = 1.0 + acting_weight * (z - 1.0) * (z - 1.0) / (z - 1.0 + acting_weight);
    EXPECT_NEAR(G.imag(), 0.5 * angle * angle * angle, 0.02 * angle * angle * angle);
    for (int k = 0; k < 60; ++k) {
        const std::complex<double> p = std::polar(1.0, k * angle);
        const double acting = advance(dt, ((z - 1.0) * p).real() / dt) + p.real();
        if (k > 40) { // the start is forgotten
            EXPECT_NEAR(acting, (G * p).real(), 1e-9) << k;
        }
    }
}

/// Cells of undrained soil that a given velocity gradient strains step by step.
class Cavitation : public testing::Test {
protected:
    Cavitation()
    {
        problem_.grid = {{0.0, 0.0}, 0.1, 3, 3};
        problem_.materials = {stiff_sand()};
        problem_.water = water_to(0.3);
        problem_.water->flow = WaterFlow::undrained;
        problem_.water->cavitation_pressure = 2e3;
        problem_.strain = StrainForm::small;
        state_ = fill(problem_, 2, [](const Vector2&) { return true; });
        lists_ = make_cell_lists(problem_.grid);
        update_cell_lists(problem_.grid, state_.particles, lists_);
        means_ = make_cell_means(problem_);
        increment_.resize(problem_.grid.cell_count());
    }

    /// Strain by `strain` times (1 + x/0.3), in ten steps.
    void strain(double strain)
    {
        Particles& particles = state_.particles;
        for (int step = 0; step < 10; ++step) {
            for (std::size_t p = 0; p < particles.size(); ++p)
                particles.velocity_gradient_solid.yy[p] =
                    0.1 * strain * (1.0 + particles.position.x[p] / 0.3);
            for_each_tile(lists_, [&](const Tile& tile) {
                undrained_increments(problem_, 1.0, lists_, tile, particles, increment_);
                apply_increments(problem_, 1.0, lists_, tile, increment_, particles, means_);
            });
            for_each_tile(lists_, [&](const Tile& tile) {
                reconstruct_pore_pressure(problem_, lists_, tile, means_, particles);
            });
        }
    }

    double lowest(std::size_t p) const
    {
        return 2e3 - atmospheric_pressure - static_water_pressure(problem_, state_.particles.position.y[p]);
    }

    /// Pressure times volume, cavities included: the water's volume.
    double sum_with_cavities() const
    {
        const Particles& particles = state_.particles;
        double sum = 0.0;
        for (std::size_t p = 0; p < particles.size(); ++p)
            sum += particles.volume[p] * (particles.pore_pressure[p] + particles.tension_deficit[p]);
        return sum;
    }

    Problem problem_;
    State state_;
    CellLists lists_;
    CellMeans means_;
    Scalars increment_;
};

TEST_F(Cavitation, HoldsTheAbsolutePressureAtItsLimit)
{
    strain(1e-4); // asks for tensions of 0.5 to 1 MPa
    for (std::size_t p = 0; p < state_.particles.size(); ++p) {
        EXPECT_DOUBLE_EQ(state_.particles.pore_pressure[p], lowest(p));
        EXPECT_LT(state_.particles.tension_deficit[p], -4e5);
    }
}

TEST_F(Cavitation, KeepsTheVolumeOfTheWater)
{
    const double K_by_n = 2.2e9 / 0.43;
    double strained = 0.0;
    for (std::size_t p = 0; p < state_.particles.size(); ++p)
        strained += state_.particles.volume[p] * (1.0 + state_.particles.position.x[p] / 0.3);
    const double before = sum_with_cavities();
    strain(1.7e-5);
    EXPECT_NEAR(sum_with_cavities(), before - K_by_n * 1.7e-5 * strained, 1e-9 * K_by_n * 1.7e-5);
}

TEST_F(Cavitation, CavitiesCloseBeforeThePressureRises)
{
    strain(1e-4);
    strain(-0.85e-4);
    for (std::size_t p = 0; p < state_.particles.size(); ++p)
        EXPECT_GE(state_.particles.pore_pressure[p], lowest(p));
    EXPECT_LT(
        *std::min_element(state_.particles.tension_deficit.begin(), state_.particles.tension_deficit.end()),
        0.0);
    strain(-0.15e-4);
    strain(-1e-5); // now beyond the start
    for (std::size_t p = 0; p < state_.particles.size(); ++p) {
        EXPECT_NEAR(state_.particles.tension_deficit[p], 0.0, 1e-6);
        EXPECT_GT(state_.particles.pore_pressure[p], 4e4);
    }
    strain(1e-5);
    for (const double pressure : state_.particles.pore_pressure) EXPECT_NEAR(pressure, 0.0, 1e-5);
}

} // namespace
} // namespace quicksand
