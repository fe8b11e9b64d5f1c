// The measures of oscillations on fields whose oscillations are known.
#include "solver/measure/pressure_oscillations.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

Problem block()
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 8, 6};
    problem.materials = {fixtures::stiff_sand()};
    problem.water = fixtures::water_to(3.0);
    return problem;
}

State filled(const Problem& problem)
{
    return fixtures::fill(problem, 2, [](const Vector2&) { return true; });
}

void set_mean_stress(std::size_t p, double pressure, Particles& particles)
{
    particles.stress.xx[p] = particles.stress.yy[p] = particles.stress.zz[p] = -pressure;
}

/// +1 and -1 by the squares of this size.
double alternating(const Vector2& x, double size)
{
    return std::fmod(std::floor(x.x() / size) + std::floor(x.y() / size), 2.0) < 1.0 ? 1.0 : -1.0;
}

TEST(PressureOscillations, OfALinearFieldIsZero)
{
    const Problem problem = block();
    State state = filled(problem);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Vector2 x = state.particles.position[p];
        set_mean_stress(p, 1e4 * (3.0 - x.y()) + 2e3 * x.x(), state.particles);
        state.particles.pore_pressure[p] = 1e3;
    }
    const PressureOscillations oscillations = measure_pressure_oscillations(problem, state.particles);
    EXPECT_LT(oscillations.mean_stress_scatter, 1e-12);
    EXPECT_LT(oscillations.pore_pressure_checkerboard, 1e-12);
    EXPECT_LT(oscillations.mean_stress_checkerboard, 1e-12); // as many cells of either colour in every row
}

TEST(PressureOscillations, OfACheckerboardIsItsPart)
{
    const Problem problem = block();
    State state = filled(problem);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const double sign = alternating(state.particles.position[p], 0.5);
        state.particles.pore_pressure[p] = 1e3 * (1.0 + 0.2 * sign);
        set_mean_stress(p, 1e4 * (1.0 + 0.1 * sign), state.particles);
    }
    const PressureOscillations oscillations = measure_pressure_oscillations(problem, state.particles);
    EXPECT_NEAR(oscillations.pore_pressure_checkerboard, 0.2, 1e-12);
    EXPECT_NEAR(oscillations.mean_stress_checkerboard, 0.1, 1e-12);
}

TEST(PressureOscillations, WithinCellsIsScatter)
{
    const Problem problem = block();
    State state = filled(problem);
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        set_mean_stress(p, 1e4 * (1.0 + 0.3 * alternating(state.particles.position[p], 0.25)),
                        state.particles);
    const PressureOscillations oscillations = measure_pressure_oscillations(problem, state.particles);
    EXPECT_NEAR(oscillations.mean_stress_scatter, 0.3, 1e-12);
    EXPECT_LT(oscillations.mean_stress_checkerboard, 1e-12);
}

// Mean stresses of a body in pure shear are rounding, however large beside the weight of half a cell.
TEST(PressureOscillations, OfPureShearIsZero)
{
    const Problem problem = block();
    State state = filled(problem);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        state.particles.stress.xy[p] = 1e12;
        set_mean_stress(p, 1e8 * alternating(state.particles.position[p], 0.5), state.particles);
    }
    EXPECT_EQ(measure_pressure_oscillations(problem, state.particles).mean_stress_checkerboard, 0.0);
    for (double& shear : state.particles.stress.xy) shear = 0.0;
    EXPECT_NEAR(measure_pressure_oscillations(problem, state.particles).mean_stress_checkerboard, 1.0, 1e-12);
}

TEST(PressureOscillations, OfSoilWithoutPressureIsZero)
{
    const Problem problem = block();
    State state = filled(problem);
    state.particles.pore_pressure[3] = 1e-6; // rounding
    const PressureOscillations oscillations = measure_pressure_oscillations(problem, state.particles);
    EXPECT_EQ(oscillations.pore_pressure_checkerboard, 0.0);
    EXPECT_EQ(oscillations.mean_stress_scatter, 0.0);
}

} // namespace
} // namespace quicksand
