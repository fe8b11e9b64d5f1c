#include "solver/verification/solutions/mandel.hpp"
#include "tests/fixtures/closed_forms.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

/// The slab of the published overshoot: nu = 0.2, n = 0.4, G = 10 MPa.
MandelSlab slab()
{
    MandelSlab slab;
    slab.soil = fixtures::elastic_soil(24e6, 0.2);
    slab.soil.porosity = 0.4;
    slab.half_width = 2.0;
    slab.force = 5e3;
    return slab;
}

double centre_ratio(const MandelSlab& slab, double T)
{
    return MandelState(slab, T).pore_pressure(0.0) / slab.initial_pressure();
}

TEST(Mandel, OvershootIsPublished)
{
    EXPECT_NEAR(centre_ratio(slab(), 0.05), 1.0986, 6e-5);
    EXPECT_NEAR(centre_ratio(slab(), 0.1), 1.0949, 5e-5);
    EXPECT_NEAR(centre_ratio(slab(), 0.5), 0.5919, 5e-5);
    EXPECT_NEAR(slab().poisson_ratio(), 0.2, 1e-12);
}

TEST(Mandel, VerticalStressCarriesTheForce)
{
    for (const double T : {1e-3, 0.05, 1.0}) {
        const MandelState state(slab(), T);
        constexpr int strips = 2000;
        double force = 0.0;
        for (int i = 0; i < strips; ++i)
            force += state.vertical_stress((i + 0.5) * 2.0 / strips) * 2.0 / strips;
        EXPECT_NEAR(force, -5e3, 1e-3) << T;
    }
}

TEST(Mandel, StartsUndrainedAndEndsDrained)
{
    const MandelState start(slab(), 1e-6), end(slab(), 20.0);
    const double p0 = slab().initial_pressure(), nu_u = slab().undrained_poisson_ratio();
    const double G = slab().soil.shear_modulus;
    EXPECT_NEAR(start.pore_pressure(0.0) / p0, 1.0, 1e-3);
    EXPECT_NEAR(start.pore_pressure(1.5) / p0, 1.0, 1e-3);
    EXPECT_NEAR(start.vertical_stress(1.0), -2.5e3, 5.0);
    EXPECT_NEAR(start.displacement_x(2.0) / (0.5 * 5e3 * nu_u / G), 1.0, 5e-3);
    EXPECT_NEAR(start.displacement_y(1.0) / (-0.25 * 5e3 * (1.0 - nu_u) / G), 1.0, 5e-3);
    EXPECT_NEAR(end.pore_pressure(0.0), 0.0, 1e-9);
    EXPECT_NEAR(end.vertical_stress(0.7), -2.5e3, 1e-9);
    EXPECT_NEAR(end.displacement_x(2.0), 0.5 * 5e3 * 0.2 / G, 1e-15);
    EXPECT_NEAR(end.displacement_y(1.0), -0.25 * 5e3 * 0.8 / G, 1e-15);
    EXPECT_NEAR(MandelState(slab(), 0.05).pore_pressure(2.0), 0.0, 1e-9); // drained side
}

TEST(Mandel, MeetsElasticityEquilibriumAndDarcy)
{
    const MandelSlab mandel = slab();
    const double M = mandel.soil.constrained_modulus, G = mandel.soil.shear_modulus, d = 1e-3;
    const double to_time = 4.0 / mandel.soil.consolidation_coefficient(); // t / T
    const double mobility = mandel.soil.hydraulic_conductivity / (1000.0 * standard_gravity);
    const auto water = [&](double x, double T) { // volume of water gained per volume
        const MandelState state(mandel, T);
        const double strain = (state.displacement_x(x + d) - state.displacement_x(x - d)) / (2.0 * d) +
                              state.displacement_y(1.0);
        return strain + state.pore_pressure(x) / mandel.soil.storage_modulus();
    };
    for (const double T : {0.02, 0.1, 0.5}) {
        const MandelState state(mandel, T);
        for (const double x : {0.2, 1.0, 1.8}) {
            const double e_x = (state.displacement_x(x + d) - state.displacement_x(x - d)) / (2.0 * d);
            const double e_y = state.displacement_y(1.0), p = state.pore_pressure(x);
            EXPECT_NEAR(M * e_x + (M - 2.0 * G) * e_y - p, 0.0, 0.01); // the sides are free
            EXPECT_NEAR(M * e_y + (M - 2.0 * G) * e_x - p, state.vertical_stress(x), 0.01);
            const double curvature =
                (state.pore_pressure(x + d) - 2.0 * p + state.pore_pressure(x - d)) / (d * d);
            const double gain = (water(x, T + 1e-4) - water(x, T - 1e-4)) / (2e-4 * to_time);
            EXPECT_NEAR(gain / (mobility * curvature), 1.0, 1e-3) << x << " " << T;
        }
    }
}

} // namespace
} // namespace quicksand
