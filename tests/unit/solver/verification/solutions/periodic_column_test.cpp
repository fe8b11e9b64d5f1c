#include "solver/verification/solutions/periodic_column.hpp"
#include "tests/fixtures/closed_forms.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

PeriodicColumn column_with(double conductivity, double frequency)
{
    PeriodicColumn column;
    column.soil.hydraulic_conductivity = conductivity;
    column.frequency = frequency;
    return column;
}

TEST(PeriodicColumn, BasePressureIsThePublishedOne)
{
    const double table[][3] = {{1e-2, 1.0, 0.70424},
                               {1e-2, 30.0, 2.00134},
                               {1e-4, 1.0, 0.93674},
                               {1e-4, 30.0, 2.16205},
                               {1e-4, 100.0, 1.13551}};
    for (const auto& [k, f, pressure] : table) {
        EXPECT_NEAR(std::abs(periodic_amplitude(column_with(k, f), 0.0).pore_pressure), pressure, 5e-6)
            << k << " " << f;
    }
}

TEST(PeriodicColumn, MeetsTheEquationsOfMotionAndItsBoundaries)
{
    const PeriodicColumn column = column_with(1e-2, 30.0);
    const SaturatedSoil& soil = column.soil;
    const double omega = column.angular_frequency(), C = soil.drag(), n = soil.porosity, d = 1e-3;
    const Complex i(0.0, 1.0);
    for (const double x : {1.0, 5.0, 9.5}) {
        const ColumnAmplitude below = periodic_amplitude(column, x - d), here = periodic_amplitude(column, x),
                              above = periodic_amplitude(column, x + d);
        const Complex u_s = here.displacement_solid, u_w = here.displacement_fluid;
        const Complex slope = (above.pore_pressure - below.pore_pressure) / (2.0 * d);
        const Complex bend = (above.displacement_solid - 2.0 * u_s + below.displacement_solid) / (d * d);
        const Complex drag = i * omega * C * (u_w - u_s);
        const Complex water = -n * slope - drag + omega * omega * soil.partial_density_fluid() * u_w;
        const Complex solid = soil.constrained_modulus * bend - (1.0 - n) * slope + drag +
                              omega * omega * soil.partial_density_solid() * u_s;
        EXPECT_LT(std::abs(water), 1e-5 * std::abs(slope));
        EXPECT_LT(std::abs(solid), 1e-4 * std::abs(slope));
        const Complex strain = (above.displacement_solid - below.displacement_solid) / (2.0 * d);
        const Complex fluid_strain = (above.displacement_fluid - below.displacement_fluid) / (2.0 * d);
        const Complex stored = -soil.storage_modulus() * ((1.0 - n) * strain + n * fluid_strain);
        EXPECT_LT(std::abs(stored - here.pore_pressure), 1e-6);
    }
    const ColumnAmplitude base = periodic_amplitude(column, 0.0), top = periodic_amplitude(column, 10.0);
    EXPECT_LT(std::abs(base.displacement_solid) + std::abs(base.displacement_fluid), 1e-20);
    EXPECT_LT(std::abs(top.pore_pressure), 1e-12);
}

TEST(PeriodicColumn, TheLoadsPowerIsTheDragsDissipation)
{
    for (const double k : {1e-2, 1e-3}) {
        const PeriodicColumn column = column_with(k, 30.0);
        const double omega = column.angular_frequency();
        const Complex speed = Complex(0.0, omega) * periodic_amplitude(column, 10.0).displacement_solid;
        const double power = -0.5 * speed.real(); // the load of unit amplitude points down
        constexpr int slabs = 4000;
        double dissipation = 0.0;
        for (int j = 0; j < slabs; ++j) {
            const auto here = periodic_amplitude(column, (j + 0.5) * 10.0 / slabs);
            dissipation += 0.5 * column.soil.drag() * omega * omega *
                           std::norm(here.displacement_fluid - here.displacement_solid) * 10.0 / slabs;
        }
        EXPECT_NEAR(dissipation / power, 1.0, 1e-4) << k;
    }
}

TEST(PeriodicColumn, SlowLoadsAreDrainedAndTightSoilIsUndrained)
{
    const auto slow = periodic_amplitude(column_with(1e-2, 1e-6), 10.0);
    EXPECT_NEAR(slow.displacement_solid.real() * 350e6 / 10.0, -1.0, 1e-6);
    EXPECT_NEAR(std::abs(periodic_amplitude(column_with(1e-2, 1e-6), 0.0).pore_pressure), 0.0, 1e-5);
    const PeriodicColumn tight = column_with(1e-9, 0.1);
    const auto base = periodic_amplitude(tight, 0.0);
    EXPECT_NEAR(base.pore_pressure.real(), fixtures::undrained_pressure_ratio(tight.soil), 1e-4);
}

TEST(PeriodicColumn, ThePressureDependsOnTheMapsParametersOnly)
{
    // twice the height at half the frequency and twice the conductivity is the same place of the paper's map
    PeriodicColumn column = column_with(1e-3, 20.0), twin = column_with(2e-3, 10.0);
    twin.height = 2.0 * column.height;
    for (const double Z : {0.1, 0.6}) {
        const Complex p = periodic_amplitude(column, Z * 10.0).pore_pressure;
        EXPECT_LT(std::abs(periodic_amplitude(twin, Z * 20.0).pore_pressure - p), 1e-10);
    }
}

} // namespace
} // namespace quicksand
