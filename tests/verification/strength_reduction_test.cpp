// Factors of safety against known ones, and the locking of plastic flow with and without its cure.
#include "solver/measure/pressure_oscillations.hpp"
#include "solver/run/strength_reduction.hpp"
#include "solver/verification/solutions/griffiths_lane.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

Material soil(const MohrCoulomb& law, VolumetricStrain strain)
{
    Material material;
    material.name = "soil";
    material.law = law;
    material.porosity = 0.25;
    material.grain_density = 20e3 / standard_gravity / (1.0 - material.porosity); // gamma = 20 kN/m3
    material.volumetric_strain = strain;
    return material;
}

/// A vertical cut of height 10 m in clay with undrained strength c = gamma H / 3.78: about to fail. The
/// stability number lies between 3.777 and 3.786 (Pastor, Thai and Francescato 2000; recalled).
Problem vertical_cut(int cells, VolumetricStrain strain)
{
    const double H = 10.0, h = H / cells, depth = std::round(0.6 * cells) * h;
    Problem problem;
    problem.grid = {{-H, -depth}, h, 3 * cells, cells + static_cast<int>(std::lround(depth / h)) + 1};
    const MohrCoulomb clay{100e6 / 2.98, 0.49, 20e3 * H / 3.78, 0.0, 0.0};
    problem.materials = {soil(clay, strain)};
    problem.boundaries = {{"base", FixedWall{}, Drained{}, {{{-H, -depth}, {2.0 * H, -depth}}}},
                          {"right", RollerWall{}, Drained{}, {{{2.0 * H, -depth}, {2.0 * H, H}}}},
                          {"left", RollerWall{}, Drained{}, {{{-H, 0.0}, {-H, -depth}}}}};
    return problem;
}

State cut_ground(const Problem& problem)
{
    const auto inside = [](const Vector2& x) { return x.y() < (x.x() > 0.0 ? 10.0 : 0.0); };
    State state = fixtures::fill(problem, 2, inside);
    SymmetricTensors& stress = state.particles.stress;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Vector2 x = state.particles.position[p];
        stress.yy[p] = -20e3 * ((x.x() > 0.0 ? 10.0 : 0.0) - x.y());
        stress.xx[p] = stress.zz[p] = 0.9 * stress.yy[p];
    }
    return state;
}

StrengthReductionControls coarse()
{
    StrengthReductionControls controls;
    controls.tolerance = 0.02;
    return controls;
}

TEST(StrengthReduction, FindsTheVerticalCutOfClayWhereVolumeIsAveraged)
{
    // measured with tolerance 0.005: 1.115 at 5 cells and 1.057 at 10 cells over the height
    const Problem problem = vertical_cut(5, VolumetricStrain::cell);
    State state = cut_ground(problem);
    EXPECT_NEAR(safety_factor(problem, coarse(), state).factor, 1.0, 0.14);
}

TEST(StrengthReduction, LocksWhereVolumeIsNotAveraged)
{
    // proof that the test above can fail: measured 3.6
    const Problem problem = vertical_cut(5, VolumetricStrain::particle);
    State state = cut_ground(problem);
    EXPECT_GT(safety_factor(problem, coarse(), state).factor, 2.0);
}

TEST(StrengthReduction, AveragedVolumeKeepsTheMeanStressSmooth)
{
    const auto scatter = [](VolumetricStrain strain) {
        const Problem problem = vertical_cut(5, strain);
        State state = cut_ground(problem);
        safety_factor(problem, coarse(), state);
        return measure_pressure_oscillations(problem, state.particles).mean_stress_scatter;
    };
    EXPECT_LT(scatter(VolumetricStrain::cell), 0.5 * scatter(VolumetricStrain::particle));
}

/// Example 1 of Griffiths and Lane (1999) on columns of particles whose uppermost ones are cut to the face.
State slope_of_columns(const Problem& problem, const HomogeneousSlope& slope)
{
    const BackgroundGrid& grid = problem.grid;
    const double s = 0.5 * grid.cell_size, right = grid.upper_corner().x();
    State state;
    Particles& particles = state.particles;
    std::vector<Vector2> centres, halves;
    for (double x = 0.5 * s; x < right; x += s) {
        const double top = std::min(slope.height, x / slope.run);
        for (double y = 0.0; y < top - 1e-9;) {
            const double height = top - y < 1.5 * s ? top - y : s;
            centres.emplace_back(x, y + 0.5 * height);
            halves.emplace_back(0.5 * s, 0.5 * height);
            y += height;
        }
    }
    resize(particles, centres.size(), std::nullopt);
    for (std::size_t p = 0; p < centres.size(); ++p) {
        particles.identifier[p] = static_cast<std::int32_t>(p);
        particles.position.set(p, centres[p]);
        particles.half_edge_1.set(p, {halves[p].x(), 0.0});
        particles.half_edge_2.set(p, {0.0, halves[p].y()});
        particles.volume[p] = 4.0 * halves[p].x() * halves[p].y();
        particles.mass_solid[p] = slope.unit_weight / problem.gravity * particles.volume[p];
        const double above = std::min(slope.height, centres[p].x() / slope.run) - centres[p].y();
        particles.stress.yy[p] = -slope.unit_weight * above;
        particles.stress.xx[p] = particles.stress.zz[p] = 0.43 * particles.stress.yy[p];
    }
    begin_shaking(state);
    return state;
}

Problem griffiths_lane(int cells, const HomogeneousSlope& slope)
{
    const double h = slope.height / cells, right = 3.5 * slope.height;
    Problem problem;
    problem.grid = {{0.0, 0.0}, h, static_cast<int>(std::lround(right / h)), cells + 1};
    const MohrCoulomb law{100e6 / 2.6, 0.3, slope.cohesion, slope.friction_angle, 0.0};
    problem.materials = {soil(law, VolumetricStrain::cell)};
    problem.boundaries = {{"base", FixedWall{}, Drained{}, {{{0.0, 0.0}, {right, 0.0}}}},
                          {"right", RollerWall{}, Drained{}, {{{right, 0.0}, {right, slope.height}}}}};
    return problem;
}

TEST(StrengthReduction, FindsTheSlopeOfGriffithsAndLane)
{
    // measured with tolerance 0.005: 1.404 at 10 cells, 1.375 at 20; Bishop's method 1.378
    HomogeneousSlope slope;
    slope.friction_angle = 20.0 * degree;
    slope.cohesion = 0.05 * slope.unit_weight * slope.height;
    const Problem problem = griffiths_lane(10, slope);
    State state = slope_of_columns(problem, slope);
    StrengthReductionControls controls;
    controls.tolerance = 0.01;
    const SafetyFactor safety = safety_factor(problem, controls, state);
    EXPECT_NEAR(safety.factor / critical_circle(slope).factor_of_safety, 1.0, 0.025);
    EXPECT_TRUE(safety.trials.front().stands);
    EXPECT_EQ(safety.failure.size(), state.particles.size());
}

// Particles with volume changes of their own locked: 1.15 times, from the least dilation on.
TEST(StrengthReduction, DilationRaisesTheFactorOfASlopeALittle)
{
    HomogeneousSlope slope;
    slope.friction_angle = 20.0 * degree;
    slope.cohesion = 0.05 * slope.unit_weight * slope.height;
    const auto factor = [&](double dilation_deg) {
        Problem problem = griffiths_lane(10, slope);
        std::get<MohrCoulomb>(problem.materials[0].law).dilation_angle = dilation_deg * degree;
        State state = slope_of_columns(problem, slope);
        StrengthReductionControls controls;
        controls.tolerance = 0.01;
        return safety_factor(problem, controls, state).factor;
    };
    const double without = factor(0.0);
    EXPECT_NEAR(factor(1.0) / without, 1.0, 0.03);
    EXPECT_NEAR(factor(20.0) / without, 1.04, 0.05);
}

TEST(StrengthReduction, ASlopeThatIsTooWeakHasAFactorBelowOne)
{
    HomogeneousSlope slope;
    slope.friction_angle = 13.0 * degree;
    slope.cohesion = 0.02 * slope.unit_weight * slope.height;
    const Problem problem = griffiths_lane(6, slope);
    State state = slope_of_columns(problem, slope);
    const SafetyFactor safety = safety_factor(problem, coarse(), state);
    EXPECT_LT(safety.fails, 1.0);
    EXPECT_NEAR(safety.factor / critical_circle(slope).factor_of_safety, 1.0, 0.06);
}

TEST(StrengthReduction, ABodyOutOfBalanceComesToRestFirst)
{
    // stresses of ten times its weight, which lift it by more than the displacement of a failure
    HomogeneousSlope slope;
    slope.friction_angle = 20.0 * degree;
    slope.cohesion = 0.05 * slope.unit_weight * slope.height;
    const Problem problem = griffiths_lane(6, slope);
    State state = slope_of_columns(problem, slope);
    for (Scalars* part : {&state.particles.stress.xx, &state.particles.stress.yy, &state.particles.stress.zz})
        for (double& stress : *part) stress *= 10.0;
    const SafetyFactor safety = safety_factor(problem, coarse(), state);
    EXPECT_FALSE(safety.trials.front().stands);
    EXPECT_NEAR(safety.factor / critical_circle(slope).factor_of_safety, 1.0, 0.06);
}

TEST(StrengthReduction, SoilThatMovesByAQuarterOfTheLargestDisplacementIsTheFailure)
{
    Particles failure;
    failure.identifier = {0, 1, 2, 3};
    failure.volume = {0.1, 0.2, 0.4, 0.8};
    failure.reference_position = {{1.0, 2.0, 3.0, 4.0}, {5.0, 7.0, 6.0, 8.0}};
    failure.position = failure.reference_position;
    failure.position.x[1] += 0.04;
    failure.position.y[2] -= 0.012;
    failure.position.x[3] -= 0.009;
    const MovingSoil moving = moving_soil(failure);
    EXPECT_NEAR(moving.area, 0.6, 1e-12);
    EXPECT_EQ(moving.low, Vector2(2.0, 6.0));
    EXPECT_EQ(moving.high, Vector2(3.0, 7.0));
}

TEST(StrengthReduction, SoilThatCannotFailIsSafe)
{
    HomogeneousSlope slope;
    slope.friction_angle = 20.0 * degree;
    slope.cohesion = 1e6;
    Problem problem = griffiths_lane(4, slope);
    StrengthReductionControls controls = coarse();
    controls.greatest_factor = 4.0;
    State state = slope_of_columns(problem, slope);
    const SafetyFactor safety = safety_factor(problem, controls, state);
    EXPECT_EQ(safety.factor, 4.0);
    EXPECT_TRUE(std::isinf(safety.fails));
    EXPECT_TRUE(has_strength(problem, state.particles));
    problem.materials.push_back(problem.materials[0]); // of no particle
    problem.materials[0].law = LinearElastic{1e7, 0.3};
    EXPECT_FALSE(has_strength(problem, state.particles));
}

} // namespace
} // namespace quicksand
