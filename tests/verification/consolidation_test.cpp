// Terzaghi's one-dimensional consolidation.
#include "solver/measure/balances.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/verification/solutions/terzaghi.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

struct ConsolidatedColumn {
    double pressure_error = 0.0;   // L2 over the particles, relative to p0 [-]
    double settlement_error = 0.0; // of the topmost particle, relative to the final settlement [-]
};

constexpr double small_pressure = 10.0; // the series knows no change of geometry [Pa]

/// A layer of 1 m with excess pressure p0 everywhere that its total stress of zero leaves to the skeleton.
ConsolidatedColumn consolidate_column(int cells, double time_factor, double p0 = small_pressure,
                                      StrainForm strain = StrainForm::large)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0 / cells, 1, cells + 1};
    Material sand = stiff_sand();
    sand.law = LinearElastic{5e6, 0.0}; // M = 10 MPa
    sand.porosity = 0.3;
    sand.hydraulic_conductivity = 1e-3;
    problem.materials = {sand};
    problem.strain = strain;
    problem.water = water_to(1.0);
    problem.gravity = 0.0;
    problem.boundaries =
        rectangle(0.0, 0.0, problem.grid.cell_size, 1.0, FixedWall{}, RollerWall{}, FreeFace{});
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 1.0; });
    std::fill(state.particles.pore_pressure.begin(), state.particles.pore_pressure.end(), p0);
    std::fill(state.particles.stress.yy.begin(), state.particles.stress.yy.end(), p0);

    const double M = 10e6, storage = 1.0 / M + sand.porosity / problem.water->bulk_modulus;
    const double c_v = sand.hydraulic_conductivity / (problem.water->density * standard_gravity * storage);
    run(problem, time_factor / c_v, {}, state);

    double top = 0.0, highest = 0.0, volume = 0.0;
    ConsolidatedColumn result;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const double y = state.particles.reference_position.y[p], V = state.particles.volume[p];
        const double difference =
            state.particles.pore_pressure[p] / p0 - terzaghi_pressure_ratio(1.0 - y, time_factor);
        result.pressure_error += V * difference * difference;
        volume += V;
        if (y > highest) highest = y, top = y - state.particles.position.y[p];
    }
    result.pressure_error = std::sqrt(result.pressure_error / volume);
    result.settlement_error =
        std::abs(top / (p0 / M) - terzaghi_settlement_degree(1.0 - highest, time_factor));
    return result;
}

TEST(Terzaghi, PressureAndSettlementAgreeWithTheSeriesAt20Cells)
{
    for (const double time_factor : {0.1, 0.2, 0.5, 1.0}) {
        const ConsolidatedColumn result = consolidate_column(20, time_factor);
        EXPECT_LT(result.pressure_error, 0.0012) << "T = " << time_factor;
        EXPECT_LT(result.settlement_error, 0.0006) << "T = " << time_factor;
    }
}

TEST(Terzaghi, ALoadOfAThousandTimesIsAsGoodInSmallStrain)
{
    const ConsolidatedColumn large = consolidate_column(20, 0.2),
                             small = consolidate_column(20, 0.2, 10e3, StrainForm::small);
    EXPECT_NEAR(small.pressure_error, large.pressure_error, 1e-5);
    EXPECT_NEAR(small.settlement_error, large.settlement_error, 1e-5);
    EXPECT_GT(std::abs(consolidate_column(20, 0.2, 10e3).pressure_error - small.pressure_error), 1e-4)
        << "large strain sees the strain of 0.1 %";
}

TEST(Terzaghi, PressureConvergesFasterThanFirstOrderOnceTheFirstWavesAreGone)
{
    const double coarse = consolidate_column(10, 0.5).pressure_error,
                 fine = consolidate_column(20, 0.5).pressure_error;
    EXPECT_GT(std::log2(coarse / fine), 1.6);
}

/// 1 m of clay under 0.5 m of sand of a million times the conductivity, in cells of 0.125 m, four of them
/// wide, with an excess pressure of 10 kPa that leaves through the sand.
Problem sand_over_clay()
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.125, 4, 13};
    Material clay = stiff_sand();
    clay.law = LinearElastic{1e6, 0.3};
    clay.hydraulic_conductivity = 1e-9;
    Material sand = stiff_sand();
    sand.law = LinearElastic{1e7, 0.3};
    sand.hydraulic_conductivity = 1e-3;
    problem.materials = {clay, sand};
    problem.region_names = {"clay", "sand"};
    problem.strain = StrainForm::small;
    problem.scheme = TimeScheme::implicit;
    problem.water = water_to(1.5);
    problem.gravity = 0.0;
    problem.boundaries = rectangle(0.0, 0.0, 0.5, 1.5, FixedWall{}, RollerWall{}, FreeFace{});
    return problem;
}

/// The state at the start; the face rises by so much over the width [m].
State loaded_clay(const Problem& problem, double rise)
{
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 1.5; });
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (particles.position.y[p] > 1.0 + rise * (particles.position.x[p] / 0.5 - 0.5))
            particles.material[p] = particles.region[p] = 1;
        particles.pore_pressure[p] = particles.stress.yy[p] = 10e3;
    }
    return state;
}

// Pressures bend at the face. With slopes across it rolls of water arose in the sand from rounding: their
// drag was 40 times the work of the soil, and the run was called bad.
TEST(Consolidation, OfClayUnderSandKeepsItsEnergy)
{
    const Problem problem = sand_over_clay();
    State state = loaded_clay(problem, 0.0);
    const Particles& particles = state.particles;
    open_balances(problem, state);
    run(problem, 3e7, {}, state);
    EXPECT_LT(std::abs(balance(problem, state).energy_error), 1e-3);
    double fastest = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p)
        if (particles.position.y[p] > 1.0)
            fastest =
                std::max(fastest, std::abs(particles.velocity_fluid.y[p] - particles.velocity_solid.y[p]));
    EXPECT_LT(fastest, 1e-8); // what the clay gives: 1e-9 m/s times a slope of 1 to 10
}

// The clay's own slopes drive the water of nodes that it shares with the sand: 30 % of the energy of a face
// at 1:2.7, which was called bad.
TEST(Consolidation, KeepsItsEnergyUnderASlantedFace)
{
    const Problem problem = sand_over_clay();
    for (const double rise : {0.05, 0.1, 0.2, 0.4}) {
        State state = loaded_clay(problem, rise);
        open_balances(problem, state);
        run(problem, 3e7, {}, state);
        EXPECT_LT(std::abs(balance(problem, state).energy_error), 3e-3) << rise;
    }
}

/// The largest difference of pore pressures at one height, of those of 10 kPa at the start of the
/// consolidation of a square of 1 m, 8 cells wide, between rollers [Pa].
double difference_across(TimeScheme scheme)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.125, 8, 9};
    Material sand = stiff_sand();
    sand.law = LinearElastic{5e6, 0.3};
    sand.hydraulic_conductivity = 1e-3;
    problem.materials = {sand};
    problem.strain = StrainForm::small;
    problem.scheme = scheme;
    problem.water = water_to(1.0);
    problem.gravity = 0.0;
    problem.boundaries = rectangle(0.0, 0.0, 1.0, 1.0, FixedWall{}, RollerWall{}, FreeFace{});
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 1.0; });
    Particles& particles = state.particles;
    std::fill(particles.pore_pressure.begin(), particles.pore_pressure.end(), 10e3);
    std::fill(particles.stress.yy.begin(), particles.stress.yy.end(), 10e3);
    run(problem, 0.1, {}, state); // a time factor of 0.2
    double difference = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p)
        for (std::size_t q = 0; q < p; ++q)
            if (std::abs(particles.reference_position.y[p] - particles.reference_position.y[q]) < 1e-9)
                difference =
                    std::max(difference, std::abs(particles.pore_pressure[p] - particles.pore_pressure[q]));
    return difference;
}

// The profile's curvature along the sides is no slope across them.
TEST(Consolidation, BetweenRollersIsThatOfAColumn)
{
    EXPECT_LT(difference_across(TimeScheme::semi_implicit), 1.0);
    EXPECT_LT(difference_across(TimeScheme::implicit), 1.0);
}

} // namespace
} // namespace quicksand
