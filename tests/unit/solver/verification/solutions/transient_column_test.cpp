#include "solver/verification/solutions/terzaghi.hpp"
#include "solver/verification/solutions/transient_column.hpp"
#include "tests/fixtures/closed_forms.hpp"
#include "tests/fixtures/half_space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace quicksand {
namespace {

/// The published half space: lambda 5.5833, mu 8.375 MPa, n 0.33, rho_s 2000, k 1e-2 m/s at g = 10 m/s2.
SaturatedSoil half_space_soil()
{
    SaturatedSoil soil;
    soil.shear_modulus = 8.375e6;
    soil.constrained_modulus = 5.5833e6 + 2.0 * soil.shear_modulus;
    soil.porosity = 0.33;
    soil.grain_density = 2000.0;
    soil.hydraulic_conductivity = 1e-2;
    soil.conductivity_gravity = 10.0;
    return soil;
}

TransientColumn column_of(double conductivity, double ramp)
{
    TransientColumn column;
    column.soil.hydraulic_conductivity = conductivity;
    column.height = 0.3175;
    column.ramp_duration = ramp;
    return column;
}

double ramp_of(const TransientColumn& column, double t)
{
    if (t <= 0.0) return 0.0;
    if (t >= column.ramp_duration) return column.load;
    return 0.5 * column.load * (1.0 - std::cos(std::numbers::pi * t / column.ramp_duration));
}

TEST(HalfSpace, SettlementIsPublished)
{
    const auto load = [](double t) { return 3e3 * (1.0 - std::cos(75.0 * t)); };
    const double table[][3] = {{0.0, 0.05, 0.230263}, {0.0, 0.1, 0.157325}, {0.0, 0.2, 0.317979},
                               {1.0, 0.05, 0.056113}, {1.0, 0.1, 0.105923}, {1.0, 0.2, 0.180603},
                               {5.0, 0.05, 0.0},      {5.0, 0.1, 0.000618}, {5.0, 0.2, 0.014339}};
    for (const auto& [z, t, u] : table)
        EXPECT_NEAR(1e3 * fixtures::half_space_settlement(half_space_soil(), load, z, t), u, 5.1e-7)
            << z << " " << t;
    EXPECT_NEAR(fixtures::half_space_front_speed(half_space_soil()), 90.94, 5e-3);
}

TEST(HalfSpace, WithoutDragTheLoadTravelsUnchanged)
{
    SaturatedSoil soil = half_space_soil();
    soil.hydraulic_conductivity = 1e9;
    const auto load = [](double t) { return 1e3 * t; };
    const double c = fixtures::half_space_front_speed(soil), z = 2.0, t = 0.1;
    const double expected = c / soil.constrained_modulus * 0.5e3 * (t - z / c) * (t - z / c);
    EXPECT_NEAR(fixtures::half_space_settlement(soil, load, z, t) / expected, 1.0, 1e-6);
}

TEST(TransientColumn, IncompressibleColumnIsTheHalfSpaceBeforeItsReflection)
{
    TransientColumn column;
    column.soil = half_space_soil();
    column.soil.water_bulk_modulus = 1e17;
    column.height = 10.0;
    column.load = 3e3;
    column.ramp_duration = 0.04;
    const auto load = [&](double t) { return ramp_of(column, t); };
    const std::vector<double> times = {0.05, 0.1};
    for (const double z : {0.0, 1.0, 5.0}) {
        const auto motion = column_motion(column, 10.0 - z, times);
        for (std::size_t i = 0; i < times.size(); ++i) {
            const double exact = fixtures::half_space_settlement(column.soil, load, z, times[i]);
            EXPECT_NEAR(-motion[i].displacement_solid, exact, 1e-10) << z << " " << times[i];
        }
    }
}

TEST(TransientColumn, LateMotionIsConsolidation)
{
    const TransientColumn column = column_of(1e-6, 0.05); // 66 periods of the fast wave: no ringing
    const SaturatedSoil& soil = column.soil;
    const double t = 0.6, T = time_factor(soil, column.height, t - 0.5 * column.ramp_duration);
    const double p0 = fixtures::undrained_pressure_ratio(soil);
    for (const double Z : {0.3, 1.0}) {
        const auto motion = column_motion(column, column.height * (1.0 - Z), {t});
        EXPECT_NEAR(motion[0].pore_pressure, p0 * terzaghi_pressure_ratio(Z, T), 1e-4) << Z;
    }
    // undrained compression at once, then the transfer of p_0 to the skeleton
    const double strain = (1.0 - p0 + p0 * terzaghi_settlement_degree(0.0, T)) / soil.constrained_modulus;
    const double top = column_motion(column, column.height, {t})[0].displacement_solid;
    EXPECT_NEAR(-top / (strain * column.height), 1.0, 2e-4);
}

TEST(TransientColumn, EarlyMotionIsTheUndrainedWave)
{
    const TransientColumn column = column_of(1e-7, 5e-5);
    const double c = std::sqrt(column.soil.undrained_modulus() / column.soil.density());
    const double x = 0.2, arrival = (column.height - x) / c;
    const std::vector<double> times = {0.9 * arrival, arrival + 1e-5, arrival + 2.5e-5, arrival + 8e-5};
    const auto motion = column_motion(column, x, times); // the reflection comes 2 x / c = 0.24 ms later
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double expected =
            fixtures::undrained_pressure_ratio(column.soil) * ramp_of(column, times[i] - arrival);
        EXPECT_NEAR(motion[i].pore_pressure, expected, 3e-3) << i;
    }
    EXPECT_NEAR(motion[0].pore_pressure, 0.0, 1e-5); // nothing outruns the front
}

TEST(TransientColumn, InversionDoesNotDependOnItsWindow)
{
    for (const double ramp : {5e-5, 2e-3}) {
        const TransientColumn column = column_of(1e-4, ramp);
        const double drained = column.height / column.soil.constrained_modulus;
        for (const double x : {0.0, 0.2, column.height}) {
            const auto near = column_motion(column, x, {1e-3, 4e-3});
            const auto far = column_motion(column, x, {1e-3, 4e-3, 2e-2});
            for (std::size_t i = 0; i < 2; ++i) {
                EXPECT_NEAR(near[i].pore_pressure, far[i].pore_pressure, 1e-8);
                EXPECT_NEAR(near[i].displacement_solid, far[i].displacement_solid, 3e-9 * drained);
                EXPECT_NEAR(near[i].displacement_fluid, far[i].displacement_fluid, 3e-9 * drained);
            }
        }
    }
}

TEST(TransientColumn, RestsBeforeTheLoad)
{
    EXPECT_EQ(column_motion(column_of(1e-4, 2e-3), 0.1, {0.0, 1e-3})[0].pore_pressure, 0.0);
    EXPECT_EQ(column_motion(column_of(1e-4, 2e-3), 0.1, {0.0})[0].displacement_solid, 0.0);
    EXPECT_TRUE(column_motion(column_of(1e-4, 2e-3), 0.1, {}).empty());
}

/// The equations of motion on a staggered grid, leapfrog in time: velocities on nodes, stress in cells.
struct StaggeredColumn {
    std::vector<double> v_s, v_w, stress, pressure;
    double top_displacement = 0.0;
};

StaggeredColumn integrate_column(const TransientColumn& column, double until, int cells)
{
    const SaturatedSoil& soil = column.soil;
    const double h = column.height / cells, n = soil.porosity, C = soil.drag();
    const double r1 = soil.partial_density_solid(), r2 = soil.partial_density_fluid();
    const auto steps = static_cast<int>(until / (0.5 * h / undragged_speeds(soil).fast));
    const double dt = until / steps;
    const auto N = static_cast<std::size_t>(cells);
    StaggeredColumn state{std::vector<double>(N + 1), std::vector<double>(N + 1), std::vector<double>(N),
                          std::vector<double>(N)};
    auto& [v_s, v_w, stress, pressure, top] = state;
    for (int step = 0; step < steps; ++step) {
        const double load = ramp_of(column, step * dt);
        for (std::size_t i = 1; i <= N; ++i) {
            const double width = i == N ? 0.5 * h : h; // the top node holds half a cell
            const double above = i == N ? -load : stress[i], p_above = i == N ? 0.0 : pressure[i];
            const double f_s = (above - stress[i - 1] - (1.0 - n) * (p_above - pressure[i - 1])) / width;
            const double f_w = -n * (p_above - pressure[i - 1]) / width;
            // the mean relative velocity of the step, drag being implicit in it
            const double w = v_w[i] - v_s[i], a = f_w / r2 - f_s / r1, rate = C * (1.0 / r1 + 1.0 / r2);
            const double mean = (w + 0.5 * dt * a) / (1.0 + 0.5 * dt * rate);
            v_s[i] += dt * (f_s + C * mean) / r1;
            v_w[i] += dt * (f_w - C * mean) / r2;
        }
        for (std::size_t i = 0; i < N; ++i) {
            const double e_s = dt * (v_s[i + 1] - v_s[i]) / h, e_w = dt * (v_w[i + 1] - v_w[i]) / h;
            stress[i] += soil.constrained_modulus * e_s;
            pressure[i] -= soil.storage_modulus() * ((1.0 - n) * e_s + n * e_w);
        }
        top += dt * v_s[N];
    }
    return state;
}

TEST(TransientColumn, AgreesWithAStaggeredGrid)
{
    for (const double k : {1e-3, 1e-5}) {
        const TransientColumn column = column_of(k, 2e-3);
        for (const double t : {1e-3, 4e-3}) {
            const StaggeredColumn grid = integrate_column(column, t, 200);
            const double half_cell = 0.5 * column.height / 200;
            const auto base = column_motion(column, half_cell, {t})[0];
            const auto top = column_motion(column, column.height, {t})[0];
            EXPECT_NEAR(grid.pressure[0], base.pore_pressure, 1e-5) << k << " " << t;
            EXPECT_NEAR(grid.top_displacement / top.displacement_solid, 1.0, 1e-3) << k << " " << t;
        }
    }
}

TEST(TransientColumn, UnderAFinePolygonIsThatUnderTheSmoothRamp)
{
    const TransientColumn column = column_of(1e-4, 2e-3);
    LoadPolygon polygon;
    for (int k = 0; k <= 200; ++k) {
        polygon.times.push_back(column.ramp_duration * k / 200);
        polygon.values.push_back(ramp_of(column, polygon.times.back()));
    }
    const std::vector<double> times = {1e-3, 2e-3, 4e-3};
    const auto smooth = column_motion(column, 0.1, times);
    const auto sampled = column_motion(column.soil, column.height, polygon, 0.1, times);
    for (std::size_t k = 0; k < times.size(); ++k) {
        EXPECT_NEAR(sampled[k].pore_pressure, smooth[k].pore_pressure, 1e-4 * column.load);
        EXPECT_NEAR(sampled[k].displacement_solid / smooth[k].displacement_solid, 1.0, 1e-4);
    }
}

TEST(TransientColumn, UnderALinearRampIsTheSameShiftedInTime)
{
    // the load 0 -> 1 over 2 ms is that of two ramps of half the height, the second 1 ms later
    const TransientColumn column = column_of(1e-4, 1.0);
    const LoadPolygon whole{{0.0, 2e-3}, {0.0, 1.0}}, half{{0.0, 1e-3}, {0.0, 0.5}};
    const auto at_once = column_motion(column.soil, column.height, whole, 0.1, {3e-3})[0];
    const auto parts = column_motion(column.soil, column.height, half, 0.1, {2e-3, 3e-3});
    EXPECT_NEAR(parts[0].pore_pressure + parts[1].pore_pressure, at_once.pore_pressure, 5e-4);
    EXPECT_NEAR((parts[0].displacement_solid + parts[1].displacement_solid) / at_once.displacement_solid, 1.0,
                1e-4);
}

} // namespace
} // namespace quicksand
