// The implicit step: the equations of the other schemes with steps beyond the waves of the skeleton.
#include "solver/base/threads.hpp"
#include "solver/inertia/inertia_solve.hpp"
#include "solver/measure/balances.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/run/simulation.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step/stepper.hpp"
#include "solver/step/two_phase_step.hpp"
#include "solver/step_length/accuracy_control.hpp"
#include "solver/step_length/time_step_control.hpp"
#include "solver/verification/solutions/terzaghi.hpp"
#include "tests/fixtures/inertia_apart.hpp"
#include "tests/fixtures/restless_patch.hpp"
#include "tests/fixtures/same_bits.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

namespace quicksand {
namespace {

using namespace fixtures;
using std::numbers::pi;

/// A dry column of `cells` cells of 1 m on a fixed base between tied sides, in small strain.
Problem dry_column(int cells)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 1.0, 2, cells + 2};
    problem.materials = {stiff_sand()};
    problem.gravity = 0.0;
    problem.strain = StrainForm::small;
    problem.scheme = TimeScheme::implicit;
    problem.boundaries = rectangle(0.0, 0.0, 2.0, cells, FixedWall{}, TiedSide{}, FreeFace{});
    problem.tied_sides = TiedSides{"left", "right", 0.0, 2.0};
    return problem;
}

State first_shear_mode(const Problem& problem, int cells)
{
    State state = fill(problem, 2, [&](const Vector2& x) { return x.y() < cells; });
    const double wave_number = 0.5 * pi / cells;
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        particles.velocity_solid.x[p] = std::sin(wave_number * particles.position.y[p]);
        particles.affine_velocity_solid.xy[p] = wave_number * std::cos(wave_number * particles.position.y[p]);
    }
    return state;
}

/// Period of the free vibration from the first two upward passages of the top through zero [s].
double measured_period(const Problem& problem, State state, double dt)
{
    const std::unique_ptr<Stepper> stepper = make_stepper(problem);
    double before = 0.0, first = -1.0;
    for (int k = 0; k < 100000; ++k) {
        stepper->advance(problem, dt, state);
        const std::size_t top = state.particles.size() - 1;
        const double moved = state.particles.position.x[top] - state.particles.reference_position.x[top];
        if (k > 0 && before < 0.0 && moved >= 0.0) {
            const double passage = state.time - dt * moved / (moved - before);
            if (first >= 0.0) return passage - first;
            first = passage;
        }
        before = moved;
    }
    return 0.0;
}

TEST(ImplicitStep, PeriodGrowsWithTheSquareOfTheStepAsForOneMode)
{
    constexpr int cells = 20;
    const Problem problem = dry_column(cells);
    const State state = first_shear_mode(problem, cells);
    const double c_s = std::sqrt(100e6 / (0.57 * 2650.0));
    const double frequency = 0.5 * pi * c_s / cells; // omega [1/s]
    const double short_period = measured_period(problem, state, 0.01 / frequency);
    for (const double step : {0.0314, 0.0628, 0.157, 0.314}) { // omega dt
        const double period = measured_period(problem, state, step / frequency);
        const double expected = (inertia_fraction - 1.0 / 12.0) * 0.5 * (step * step - 1e-4);
        EXPECT_NEAR(period / short_period - 1.0, expected, 0.2 * expected + 2e-5) << step;
    }
}

/// A free block that moves and turns, without gravity.
/// D of u_n+1 = T u_n - D u_n-1, by least squares over the displacements of the top in steps of dt.
double measured_determinant(const Problem& problem, State state, double dt)
{
    const std::unique_ptr<Stepper> stepper = make_stepper(problem);
    std::vector<double> top;
    for (int k = 0; k < 12; ++k) {
        stepper->advance(problem, dt, state);
        const std::size_t p = state.particles.size() - 1;
        top.push_back(state.particles.position.x[p] - state.particles.reference_position.x[p]);
    }
    Eigen::MatrixX2d before(top.size() - 2, 2);
    Eigen::VectorXd after(top.size() - 2);
    for (std::size_t k = 0; k + 2 < top.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        before.row(row) << top[k + 1], -top[k];
        after[row] = top[k + 2];
    }
    return before.colPivHouseholderQr().solve(after)[1];
}

TEST(ImplicitStep, DampsVibrationsThatItDoesNotFollowWhereNothingMovesTheSoil)
{
    constexpr int cells = 20;
    const Problem problem = dry_column(cells);
    State state = first_shear_mode(problem, cells);
    const double c_s = std::sqrt(100e6 / (0.57 * 2650.0));
    const double frequency = 0.5 * pi * c_s / cells;    // omega [1/s]
    state.time = 25.0 * 2.0 * pi / frequency;           // when it is no longer followed
    for (const double step : {0.3, 2.0, 10.0, 100.0}) { // omega dt
        const double dt = step / frequency, z = step * step;
        state.whole_step = 0.0;
        EXPECT_NEAR(measured_determinant(problem, state, dt), 1.0, 1e-3) << "given step " << step;
        state.whole_step = dt;
        const double expected =
            (1.0 + inertia_fraction * z) / (1.0 + (inertia_fraction + damping_of_vibrations) * z);
        EXPECT_NEAR(measured_determinant(problem, state, dt), expected, 1e-3) << "chosen step " << step;
    }
}

TEST(ImplicitStep, KeepsTheMomentumOfAFreeBody)
{
    for (const bool saturated : {false, true}) {
        Problem problem = patch(1e-4, saturated);
        problem.grid = {{-0.03, -0.03}, 0.0075, 20, 20};
        problem.boundaries = {};
        problem.scheme = TimeScheme::implicit;
        State state = restless(problem);
        state = fill(problem, 3, [](const Vector2& x) {
            return x.x() > 0.0 && x.x() < 0.05 && x.y() > 0.0 && x.y() < 0.04;
        });
        for (std::size_t p = 0; p < state.particles.size(); ++p) {
            const Vector2 x = state.particles.position[p];
            const Vector2 v(0.02 - 1.0 * x.y() + 0.01 * std::sin(200.0 * x.x()), 0.01 + 1.0 * x.x());
            state.particles.velocity_solid.set(p, v);
            if (saturated) state.particles.velocity_fluid.set(p, v);
        }
        const Monitors before = monitor(problem, state, {});
        const std::unique_ptr<Stepper> stepper = make_stepper(problem);
        open_balances(problem, state);
        for (int k = 0; k < 40; ++k) stepper->advance(problem, 5e-5, state);
        const BalanceErrors errors = balance(problem, state);
        const double scale = before.mass_solid * 0.02;
        EXPECT_NEAR(errors.momentum_error_x / scale, 0.0, 1e-12) << saturated;
        EXPECT_NEAR(errors.momentum_error_y / scale, 0.0, 1e-12) << saturated;
        EXPECT_LT(std::abs(errors.energy_error), saturated ? 0.1 : 1e-12);
    }
}

TEST(ImplicitStep, FindsItsInertiaWithTheCavitiesThatItLeaves)
{
    Problem problem = patch(1e-4, true);
    problem.grid = {{-0.03, -0.03}, 0.0075, 20, 20};
    problem.boundaries = {};
    problem.scheme = TimeScheme::implicit;
    problem.water->cavitation_pressure = 2e3;
    State state = restless(problem);
    state = fill(problem, 3,
                 [](const Vector2& x) { return x.x() > 0.0 && x.x() < 0.05 && x.y() > 0.0 && x.y() < 0.04; });
    for (std::size_t p = 0; p < state.particles.size(); ++p) { // torn in the middle, pressed at the sides
        const Vector2 v(std::sin(2.0 * pi * (state.particles.position.x[p] - 0.025) / 0.05), 0.0);
        state.particles.velocity_solid.set(p, v);
        state.particles.velocity_fluid.set(p, v);
    }
    SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
    constexpr double dt = 2e-5;
    std::size_t cavities = 0;
    for (int k = 0; k < 20; ++k) {
        advance_semi_implicit_step(problem, dt, state, work);
        for (const std::uint8_t cavity : work.pressure.cavity.cavities) cavities += cavity;
        EXPECT_LT(inertia_apart(problem, dt, work), 1e-3) << k;
    }
    EXPECT_GT(cavities, 50U);
}

TEST(ImplicitStep, IsNoLongerThanTheFastestStrainAllows)
{
    Problem problem = patch(1e-4, true);
    problem.scheme = TimeScheme::implicit;
    State state = restless(problem);
    state.whole_step = 1.0;
    state.time = 1.0; // long after what follows vibrations
    for (Scalars* part :
         {&state.particles.affine_velocity_solid.xx, &state.particles.affine_velocity_solid.xy,
          &state.particles.affine_velocity_solid.yx, &state.particles.affine_velocity_solid.yy})
        part->assign(state.particles.size(), 0.0);
    EXPECT_NE(stable_time_step(problem, state).limiter, TimeStepLimiter::strain);
    state.particles.affine_velocity_solid.xx[0] = -100.0;
    const TimeStep strained = stable_time_step(problem, state);
    EXPECT_EQ(strained.limiter, TimeStepLimiter::strain);
    EXPECT_NEAR(strained.dt, 0.05 / 100.0, 1e-12);
    state.particles.affine_velocity_solid.xx[0] = -1e9;
    EXPECT_GT(stable_time_step(problem, state).dt, 1e-6) << "not below the step of the waves";
}

TEST(ImplicitStep, RandomMotionDoesNotGrowAtAnyStep)
{
    for (const double conductivity : {1e-2, 1e-4, 1e-6}) {
        for (const double dt : {2e-5, 1e-4, 1e-3}) {
            Problem problem = patch(conductivity, true);
            problem.scheme = TimeScheme::implicit;
            State state = restless(problem);
            const double before = monitor(problem, state, {}).kinetic_energy;
            const std::unique_ptr<Stepper> stepper = make_stepper(problem);
            for (int k = 0; k < 200; ++k) stepper->advance(problem, dt, state);
            EXPECT_LT(monitor(problem, state, {}).kinetic_energy, 1.05 * before) << conductivity << ' ' << dt;
        }
    }
}

TEST(ImplicitStep, DoesNotGrowWherePointsLieAtTheSidesOfCells)
{
    Problem problem = patch(1e-4, false);
    problem.scheme = TimeScheme::implicit;
    problem.interpolation = Interpolation::linear;
    problem.boundaries = {};
    const double h = problem.grid.cell_size;
    for (const Vector2& place : {Vector2(0.45, 0.0), Vector2(0.45, -0.45)}) { // in cells from the middle
        State state = fill(problem, 1, [&](const Vector2& x) {
            return x.x() > 2.0 * h && x.x() < 7.0 * h && x.y() > 2.0 * h && x.y() < 7.0 * h;
        });
        std::mt19937 generator(1);
        std::normal_distribution<double> speed(0.0, 1e-6);
        Particles& particles = state.particles;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            particles.position.set(p, particles.position[p] + h * place);
            particles.velocity_solid.set(p, {speed(generator), speed(generator)});
        }
        const double before = monitor(problem, state, {}).kinetic_energy;
        const std::unique_ptr<Stepper> stepper = make_stepper(problem);
        for (int k = 0; k < 200; ++k) stepper->advance(problem, 1e-3, state);
        EXPECT_LT(monitor(problem, state, {}).kinetic_energy, 1.05 * before) << place.transpose();
    }
}

/// Waits for the multiples of an interval, and keeps what it is shown.
class Onlooker final : public Observer {
public:
    Onlooker(double interval, bool looks_into) : interval_(interval), looks_into_(looks_into) {}
    double next_time() const override { return interval_ * static_cast<double>(count_); }
    bool looks_into_steps() const override { return looks_into_; }
    void before_step(const Problem&, const State& state, double end) override
    {
        EXPECT_GE(end, next_time());
        start_ = state.time;
    }
    void observe(const Problem&, const State& state, const StepReport&) override
    {
        const double start = steps.empty() ? 0.0 : steps.back();
        EXPECT_TRUE(next_time() == state.time || start_ == start) << "the step's start was not shown";
        for (; next_time() <= state.time; ++count_) EXPECT_FALSE(start_ > next_time());
    }
    void after_step(const StepReport& report) override { steps.push_back(report.time); }

    std::vector<double> steps; // their ends [s]

private:
    double interval_;
    bool looks_into_;
    double start_ = NAN; // of the step that was shown last [s]
    int count_ = 0;
};

TEST(ImplicitStep, IsNotShortenedForThoseWhoLookIntoIt)
{
    Problem problem = patch(1e-4, false);
    problem.scheme = TimeScheme::implicit;
    const State state = restless(problem);
    const auto steps_seen_by = [&](std::vector<Onlooker> onlookers) {
        State run_state = state;
        std::vector<Observer*> observers;
        for (Onlooker& onlooker : onlookers) observers.push_back(&onlooker);
        run(problem, 1e-3, observers, run_state);
        return onlookers.back().steps;
    };
    const double never = 1.0;
    const std::vector<double> alone = steps_seen_by({{never, true}});
    ASSERT_GT(alone.size(), 3U);
    const double interval = 0.3 * (alone[1] - alone[0]);
    EXPECT_EQ(steps_seen_by({{interval, true}, {4.7 * interval, true}}), alone);
    EXPECT_GT(steps_seen_by({{interval, false}}).size(), 3 * alone.size());
}

TEST(ImplicitStep, ShowsItsStartOrHitsTheTimeWhereExplicitStepsTakeItsPlace)
{
    Problem problem = patch(1e-4, true);
    problem.scheme = TimeScheme::implicit;
    State state = restless(problem);
    const double dt = stable_time_step(problem, state).dt;
    state.explicit_end = 50; // as the watchdog asks for
    Onlooker onlooker(0.013 * dt, true);
    run(problem, 2.0 * dt, {&onlooker}, state);
    EXPECT_GT(onlooker.steps.size(), 50U);
}

TEST(ImplicitStep, GrowsPastStepsThatWereShortened)
{
    Problem problem = patch(1e-4, false);
    problem.scheme = TimeScheme::implicit;
    State state = fill(problem, 3, [](const Vector2& x) { return x.y() < 0.0625; });
    const double first = stable_time_step(problem, state).dt;
    Onlooker exact(1.5 * first, false);
    run(problem, 30.0 * first, {&exact}, state);
    EXPECT_GE(state.whole_step, 5.0 * first);
    EXPECT_LE(state.last_step, 1.5 * first * (1.0 + 1e-12));
}

/// Consolidation of a column of 20 cells under a load that the water carries at first.
TEST(ImplicitStep, ConsolidatesWithStepsThatGrow)
{
    constexpr int cells = 20;
    constexpr double load = 1000.0; // [Pa]
    Problem problem = dry_column(cells);
    problem.grid.cell_size = 0.05;
    problem.grid.cells_y = cells + 2;
    problem.boundaries =
        rectangle(0.0, 0.0, 0.1, 1.0, FixedWall{}, TiedSide{}, FreeFace{SurfaceLoad{{0.0, -load}, 0.0, {}}});
    problem.tied_sides = TiedSides{"left", "right", 0.0, 0.1};
    problem.water = water_to(1.0);
    State state = fill(problem, 2, [&](const Vector2& x) { return x.x() < 0.1 && x.y() < 1.0; });
    std::int32_t number = 0;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        state.particles.pore_pressure[p] = load;
        const Vector2 x = state.particles.position[p];
        if (x.y() < 0.975) continue;
        number = state.particles.identifier[p];
        problem.boundaries[2].pieces.push_back({number, {1.0, 1.0}, {-1.0, 1.0}, 0.025});
    }
    const double M = constrained_modulus(std::get<LinearElastic>(problem.materials[0].law));
    const double c_v = 1e-4 / (1000.0 * standard_gravity * (1.0 / M + 0.43 / 2.2e9));
    std::int64_t steps = 0;
    for (const double T : {0.1, 0.5, 1.0}) {
        run(problem, T / c_v, {}, state);
        double squares = 0.0;
        for (std::size_t p = 0; p < state.particles.size(); ++p) {
            const double depth = 1.0 - state.particles.reference_position.y[p];
            const double apart = state.particles.pore_pressure[p] / load - terzaghi_pressure_ratio(depth, T);
            squares += apart * apart;
        }
        const double error = std::sqrt(squares / static_cast<double>(state.particles.size()));
        steps = state.step;
        EXPECT_LT(error, 0.015) << T;
    }
    EXPECT_LT(steps, 600);
}

} // namespace
} // namespace quicksand
