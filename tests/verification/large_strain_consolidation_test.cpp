// Consolidation of a layer that loses a third of its height.
#include "solver/verification/solutions/large_strain_consolidation.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

TEST(LargeStrainConsolidation, AgreesWithTheClosedFormAtHalfTheModulus)
{
    const int cells = 20;
    const double M = 1e6, q = 0.5 * M;
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0 / cells, 1, cells + 1};
    Material clay = stiff_sand();
    clay.law = LinearElastic{0.5 * M, 0.0};
    clay.porosity = 0.6;
    clay.hydraulic_conductivity = 2e-3; // slow beside the waves of the skeleton
    clay.permeability_law = PermeabilityLaw::specific_volume_squared;
    problem.materials = {clay};
    problem.water = water_to(1.0);
    problem.water->bulk_modulus = 2e8; // stiff beside the skeleton: n/K_w is 0.3 % of 1/M
    problem.gravity = 0.0;
    problem.boundaries =
        rectangle(0.0, 0.0, problem.grid.cell_size, 1.0, FixedWall{}, RollerWall{}, FreeFace{});
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 1.0; });
    Particles& particles = state.particles;
    std::fill(particles.pore_pressure.begin(), particles.pore_pressure.end(), q);
    std::fill(particles.stress.yy.begin(), particles.stress.yy.end(), q);

    const LargeStrainConsolidation layer{M, q};
    const double c_v = clay.hydraulic_conductivity * M / (1000.0 * standard_gravity);
    for (const double T : {0.1, 0.3}) {
        run(problem, T / c_v, {}, state);
        double squares = 0.0, volume = 0.0, highest = 0.0, settlement = 0.0;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const double Y = particles.reference_position.y[p], V = particles.volume[p];
            const double error = (particles.pore_pressure[p] - pore_pressure(layer, 1.0 - Y, T)) / q;
            squares += V * error * error;
            volume += V;
            if (Y > highest) highest = Y, settlement = Y - particles.position.y[p];
        }
        const double expected = settlement_ratio(layer, 1.0 - highest, T);
        EXPECT_LT(std::sqrt(squares / volume), 0.01) << "T = " << T;
        EXPECT_NEAR(settlement, expected, 0.01 * expected) << "T = " << T;
    }
}

} // namespace
} // namespace quicksand
