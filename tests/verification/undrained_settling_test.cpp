// Weight that comes at once: the water of soil that settles undrained bears it, and it goes when it
// consolidates.
#include "solver/run/staged_run.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double clay_height = 4.0, fill_height = 1.0, clay_modulus = 3.5e6,
                 clay_porosity = 0.5; // [m], M [Pa]

/// Clay under water up to its surface, on which dry fill can be placed, between rollers.
Problem clay_and_fill(StrainForm strain, double height = clay_height)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 4, 12};
    problem.strain = strain;
    problem.scheme = TimeScheme::implicit;
    Material clay = stiff_sand();
    clay.law = LinearElastic{1e6, 0.3}; // M = 2 G (1 - nu)/(1 - 2 nu)
    clay.porosity = clay_porosity;
    clay.hydraulic_conductivity = 1e-8;
    Material fill = stiff_sand();
    fill.porosity = clay_porosity;
    fill.saturated = false;
    problem.materials = {clay, fill};
    problem.region_names = {"clay", "fill"};
    problem.water = water_to(height);
    problem.boundaries =
        rectangle(0.0, 0.0, 2.0, height + fill_height, FixedWall{}, RollerWall{}, FreeFace{});
    return problem;
}

/// Soil up to `top` [m], the fill to a width [m], with `rows` of particles a cell.
State drawn_state(const Problem& problem, double top, double fill_width = 2.0, int rows = 2)
{
    const double height = problem.water->level;
    State state = fill(problem, rows, [&](const Vector2& x) {
        return x.y() < height || (x.y() < top && x.x() < fill_width);
    });
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p)
        if (particles.position.y[p] > height) particles.material[p] = particles.region[p] = 1;
    state.stage = Stage::relaxation;
    return state;
}

/// Weight of the fill on the clay [Pa].
double fill_weight(const Problem& problem)
{
    const Material& fill = problem.materials[1];
    return fill_height * (1.0 - fill.porosity) * fill.grain_density * problem.gravity;
}

RelaxationControls precisely()
{
    return {0.7, 1e-7, 200'000};
}

/// The clay at rest under its own weight.
State settled_clay(const Problem& problem)
{
    State state = drawn_state(problem, clay_height);
    EXPECT_TRUE(relax(problem, precisely(), state).settled);
    return state;
}

class UndrainedSettling : public testing::TestWithParam<StrainForm> {};

// The grains' share of a weight is M / (M + K_w / n) where nothing flows, and all of it at the end.
TEST_P(UndrainedSettling, LetsTheWaterBearWhatIsPlaced)
{
    Problem problem = clay_and_fill(GetParam());
    const State clay = settled_clay(problem);
    problem.water->while_settling = WaterFlow::undrained;
    const RunControls controls{400.0 * 86400.0, ColumnsComputed::all, true};
    StagedRun run(problem, drawn_state(problem, clay_height + fill_height), controls);
    run.go_on_from(clay, {.settles = true});
    ASSERT_TRUE(run.settle(precisely()).settled);

    const double weight = fill_weight(problem), water = problem.water->bulk_modulus / clay_porosity;
    const double borne = weight * water / (clay_modulus + water);
    const std::size_t count = clay.particles.size();
    const auto& particles = run.state().particles;
    ASSERT_GT(particles.size(), count);
    for (std::size_t p = 0; p < count; ++p) {
        EXPECT_NEAR(particles.pore_pressure[p], borne, 0.01 * weight) << particles.position.y[p];
        EXPECT_NEAR(particles.stress.yy[p], clay.particles.stress.yy[p], 0.01 * weight);
    }
    for (std::size_t p = count; p < particles.size(); ++p) EXPECT_EQ(particles.pore_pressure[p], 0.0);

    StagedRun again(problem, drawn_state(problem, clay_height + fill_height), controls);
    again.go_on_from(run.state(), {.settles = true});
    ASSERT_TRUE(again.settle(precisely()).settled);
    for (std::size_t p = 0; p < particles.size(); ++p)
        EXPECT_NEAR(again.state().particles.pore_pressure[p], particles.pore_pressure[p], 1e-3 * weight);

    ASSERT_TRUE(run.shake({}));
    double settlement = 0.0, sunk = 0.0; // of the clay's uppermost row, after placing and in all [m]
    const auto& drained = run.state().particles;
    for (std::size_t p = 0; p < drained.size(); ++p) {
        if (drained.region[p] == 1) continue;
        EXPECT_NEAR(drained.pore_pressure[p], 0.0, 0.01 * weight);
        settlement = std::max(settlement, drained.reference_position.y[p] - drained.position.y[p]);
        if (GetParam() == StrainForm::small || drained.position.y[p] < clay_height - 0.2) continue;
        sunk = clay_height - 0.125 - drained.position.y[p];
    }
    // the fill is lighter by the water that it displaces where it has sunk below it
    const double carried = weight - problem.water->density * problem.gravity * sunk;
    const double of_surface = carried * (clay_height - 0.125) / clay_modulus;
    EXPECT_NEAR(settlement, of_surface, 0.01 * of_surface);
}

INSTANTIATE_TEST_SUITE_P(Strains, UndrainedSettling, testing::Values(StrainForm::large, StrainForm::small));

/// The largest difference between the water's pressure and the weight of what is placed, over the weight:
/// clay of a modulus above whole cells, water to a height within them, fill of another modulus [-].
double error_of_pressure(double height, double clay_above, double fill)
{
    constexpr int rows = 4;
    Problem problem = clay_and_fill(StrainForm::large, height);
    problem.materials.push_back(problem.materials[0]);
    problem.materials[1].law = LinearElastic{fill, 0.3};
    problem.materials[2].law = LinearElastic{clay_above, 0.3};
    const auto drawn = [&](double top) {
        State state = drawn_state(problem, top, 2.0, rows);
        Particles& particles = state.particles;
        for (std::size_t p = 0; p < particles.size(); ++p)
            if (particles.material[p] == 0 && particles.position.y[p] > clay_height)
                particles.material[p] = 2;
        return state;
    };
    State clay = drawn(height);
    EXPECT_TRUE(relax(problem, precisely(), clay).settled);
    problem.water->while_settling = WaterFlow::undrained;
    StagedRun run(problem, drawn(height + fill_height), {400.0 * 86400.0, ColumnsComputed::all, true});
    run.go_on_from(clay, {.settles = true});
    EXPECT_TRUE(run.settle(precisely()).settled);
    const double weight = fill_weight(problem);
    const Particles& particles = run.state().particles;
    double error = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double expected = particles.region[p] == 0 ? weight : 0.0;
        error = std::max(error, std::abs(particles.pore_pressure[p] - expected));
    }
    return error / weight;
}

// A cell of wet and dry soil has one strain, which its wet part would not have: with it the pressure was 1.2
// to 2.6 times the weight. The wet part of the cell still takes the strain of the
// dry one beside it, so that soft soil errs by more.
TEST(UndrainedSettling, LetsWaterWithinACellBearWhatIsPlaced)
{
    const double stiff = std::get<LinearElastic>(stiff_sand().law).shear_modulus;
    for (const double height : {4.125, 4.25, 4.375}) { // parts of a cell above whole ones [m]
        EXPECT_LT(error_of_pressure(height, 1e6, 1e5), 0.15) << height; // 0.136
        EXPECT_LT(error_of_pressure(height, 1e6, 1e6), 0.04) << height; // 0.036
        for (const double fill : {1e7, stiff})
            EXPECT_LT(error_of_pressure(height, 1e6, fill), 0.02) << height << ' ' << fill;
    }
    EXPECT_LT(error_of_pressure(4.125, 1e5, 1e6), 0.04);
    EXPECT_LT(error_of_pressure(4.25, 1e7, 1e6), 0.07); // 0.065
}

// Elastic soil that consolidates after it was loaded undrained comes to where drained soil is at once.
TEST(UndrainedSettling, EndsAsDrainedSettlingDoes)
{
    Problem problem = clay_and_fill(StrainForm::small);
    const State clay = settled_clay(problem), drawn = drawn_state(problem, clay_height + fill_height, 1.0);
    const RunControls controls{400.0 * 86400.0, ColumnsComputed::all, false};
    StagedRun drained(problem, drawn, controls);
    drained.go_on_from(clay, {.settles = true});
    ASSERT_TRUE(drained.settle(precisely()).settled);
    Problem keeping = problem;
    keeping.water->while_settling = WaterFlow::undrained;
    StagedRun run(keeping, drawn, controls);
    run.go_on_from(clay, {.settles = true});
    ASSERT_TRUE(run.settle(precisely()).settled);
    const double weight = fill_weight(problem);
    EXPECT_GT(*std::max_element(run.state().particles.pore_pressure.begin(),
                                run.state().particles.pore_pressure.end()),
              0.5 * weight);
    ASSERT_TRUE(run.shake({}));
    const SymmetricTensors &one = run.state().particles.stress, &other = drained.state().particles.stress;
    for (std::size_t p = 0; p < one.xx.size(); ++p) {
        EXPECT_NEAR(one.xx[p], other.xx[p], 2e-3 * weight);
        EXPECT_NEAR(one.yy[p], other.yy[p], 2e-3 * weight);
        EXPECT_NEAR(one.xy[p], other.xy[p], 2e-3 * weight);
    }
}

} // namespace
} // namespace quicksand
