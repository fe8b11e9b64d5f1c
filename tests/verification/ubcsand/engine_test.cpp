// UBCSAND in the engine: a box of a few cells, shaken at its base, follows the paths of the element
// laboratory.
#include "solver/element/cyclic_laboratory.hpp"
#include "tests/fixtures/sand_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace quicksand {
namespace {

using namespace fixtures;

/// The particle's path through the run, a point a step.
class PathObserver : public Observer {
public:
    PathObserver(const State& state, std::size_t p) : state_(state), p_(p) {}
    double next_time() const override { return std::numeric_limits<double>::infinity(); }
    void observe(const Problem&, const State&, const StepReport&) override {}
    void after_step(const StepReport& report) override
    {
        const Gradients& L = state_.particles.velocity_gradient_solid;
        const double dt = report.time_step.dt;
        increments.push_back(
            {-dt * L.xx[p_], -dt * L.yy[p_], -dt * (L.xy[p_] + L.yx[p_]), 0.5 * dt * (L.yx[p_] - L.xy[p_])});
        tau.push_back(-state_.particles.stress.xy[p_]);
        vertical.push_back(-state_.particles.stress.yy[p_]);
        pressure.push_back(state_.particles.pore_pressure[p_]);
    }

    std::vector<UbcSandIncrement> increments;
    std::vector<double> tau, vertical, pressure; // [Pa]

private:
    const State& state_;
    std::size_t p_;
};

/// A particle of the middle cells of the sand.
std::size_t middle_particle(const Particles& particles)
{
    std::size_t p = 0;
    while (std::abs(particles.position.y[p] - SandBox::probed) > 0.01) ++p;
    return p;
}

TEST(UbcSandInTheEngine, AParticleHasTheStressOfItsOwnStrainPath)
{
    const SandBox box;
    const Problem problem = make_problem(box);
    State state = make_state(box, problem);
    const std::size_t p = middle_particle(state.particles);
    UbcSandState point;
    point.sigma_x = point.sigma_z = 50e3;
    point.sigma_y = 100e3;
    const UbcSand law = make_ubcsand(sand_of_runs());
    begin_shaking(law, point);
    PathObserver path(state, p);
    run(problem, 0.9, {&path}, state);
    for (const UbcSandIncrement& increment : path.increments) update(law, increment, point);
    const SymmetricTensors& stress = state.particles.stress;
    // the engine turns the stress by the same angle in another order of operations
    EXPECT_NEAR(-stress.xx[p], point.sigma_x, 1e-6 * 100e3);
    EXPECT_NEAR(-stress.yy[p], point.sigma_y, 1e-6 * 100e3);
    EXPECT_NEAR(-stress.zz[p], point.sigma_z, 1e-6 * 100e3);
    EXPECT_NEAR(-stress.xy[p], point.tau_xy, 1e-6 * 100e3);
    EXPECT_EQ(state.particles.memory[column_of(memory_of(UbcSand()), "half_cycles")][p], point.half_cycles);
    EXPECT_GT(point.half_cycles, 3.0);
}

/// Excess pressure ratio where tau passes through zero, a half cycle apart.
template <class Path, class Tau, class Ratio>
std::vector<double> ratios_at_zero_shear(const Path& path, std::size_t count, Tau&& tau, Ratio&& ratio)
{
    std::vector<double> ratios;
    for (std::size_t k = 1; k < count; ++k) {
        if (tau(path, k - 1) * tau(path, k) < 0.0) ratios.push_back(ratio(path, k));
    }
    return ratios;
}

class BoxOfSand : public testing::TestWithParam<WaterFlow> {};

INSTANTIATE_TEST_SUITE_P(Flows, BoxOfSand, testing::Values(WaterFlow::coupled, WaterFlow::undrained));

TEST_P(BoxOfSand, FollowsTheSimpleShearTest)
{
    const SandBox box;
    Problem problem = make_problem(box);
    problem.water->flow = GetParam();
    State state = make_state(box, problem);
    PathObserver path(state, middle_particle(state.particles));
    run(problem, 1.2, {&path}, state);
    const CyclicTest test =
        shear_cyclically(make_ubcsand(nevada_sand_55()), {100e3, 0.5, 0.0}, StressCycles{0.2, 5.0, 0.1});
    const auto in_box = ratios_at_zero_shear(
        path, path.tau.size(), [](const PathObserver& o, std::size_t k) { return o.tau[k]; },
        [](const PathObserver& o, std::size_t k) { return 1.0 - o.vertical[k] / 100e3; });
    const auto in_test = ratios_at_zero_shear(
        test.path, test.path.size(), [](const ElementPath& e, std::size_t k) { return e[k].tau; },
        [](const ElementPath& e, std::size_t k) { return e[k].ru; });
    // the box begins at tau = 0, the test's first such point is after half a cycle. The test keeps its
    // volume; in the box water of K_w/n = 5.5 GPa beside sand of K' = 0.1 GPa gives way by 2 % of the
    // contraction.
    ASSERT_GE(in_box.size(), 7U);
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_NEAR(in_box[k + 1], in_test[k], 0.02) << "half cycle " << k + 1;
    }
}

} // namespace
} // namespace quicksand
