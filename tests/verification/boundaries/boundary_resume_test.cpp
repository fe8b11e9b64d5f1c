// A run with loads, a moving wall, a viscous base and prescribed heads goes on to the same bits after a stop.
#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/measure/balances.hpp"
#include "solver/run/simulation.hpp"
#include "tests/fixtures/sand_box.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace quicksand {
namespace {

using namespace fixtures;

/// Keeps a copy of the state at one time, as a checkpoint does.
class Copier : public Observer {
public:
    explicit Copier(double time) : time_(time) {}
    double next_time() const override { return time_; }
    void observe(const Problem&, const State& state, const StepReport&) override
    {
        copy = state;
        time_ = std::numeric_limits<double>::infinity();
    }
    State copy;

private:
    double time_;
};

/// A block of 1 x 0.6 m on a viscous base beside a wall that pushes it, loaded from above by water and
/// weights.
Problem busy_block(bool saturated)
{
    Problem problem;
    problem.grid = {{-0.3, 0.0}, 0.1, 16, 9};
    problem.materials = {stiff_sand()};
    problem.base_motion = SineMotion{2.0, 40.0, 100.0, 0.0};
    if (saturated) problem.water = water_to(0.6);
    problem.boundaries = rectangle(0.0, 0.0, 1.0, 0.6, ViscousFace{}, FreeFace{}, FreeFace{});
    problem.boundaries[0].water = Impervious{};
    problem.boundaries[1].soil = FreeFace{SurfaceLoad{{-200.0, 0.0}, 500.0, {SineHistory{30.0}, 0.01}}};
    problem.boundaries[2].soil = FreeFace{SurfaceLoad{{0.0, -800.0}, 0.0, {ConstantHistory{}, 0.004}}};
    problem.boundaries[3].soil =
        MovingWall{{MotionQuantity::velocity, WallGrip::smooth, {0.0, 0.0}, 6.0, {ConstantHistory{}, 0.02}}};
    problem.boundaries[3].water = Impervious{};
    if (saturated) problem.boundaries[2].water = PrescribedWater{WaterHead{0.8}, {ConstantHistory{}, 0.01}};
    return problem;
}

void expect_same(const State& resumed, const State& state)
{
    EXPECT_EQ(resumed.step, state.step);
    std::vector<const Scalars*> arrays;
    for_each_array(state.particles, [&](const char*, const Scalars& values) { arrays.push_back(&values); });
    std::size_t k = 0;
    for_each_array(resumed.particles,
                   [&](const char* name, const Scalars& values) { EXPECT_EQ(values, *arrays[k++]) << name; });
    ASSERT_TRUE(state.balance_terms && resumed.balance_terms);
    std::vector<double> sums;
    for_each_number(*state.balance_terms, [&](const char*, double value) { sums.push_back(value); });
    k = 0;
    for_each_number(*resumed.balance_terms,
                    [&](const char* name, double value) { EXPECT_EQ(value, sums[k++]) << name; });
}

TEST(BoundaryResume, IsTheSameRun)
{
    for (const bool saturated : {false, true}) {
        Problem problem = busy_block(saturated);
        State state = fill(problem, 2, [](const Vector2& x) {
            return x.x() > 0.0 && x.x() < 1.0 && x.y() > 0.0 && x.y() < 0.6;
        });
        set_level_ground_stress(problem, 0.6, 0.5, state);
        attach_boundaries(problem, state.particles);
        open_balances(problem, state);
        const double end = saturated ? 0.012 : 0.03; // the dry wall passes a row of nodes
        Copier copier(0.4 * end);
        run(problem, end, {&copier}, state);

        State resumed = copier.copy;
        ASSERT_FALSE(resumed.reactions.x.empty());
        run(problem, end, {}, resumed);
        expect_same(resumed, state);
    }
}

TEST(BoundaryResume, OnABaseThatFollowsTheStressOfTheSandIsTheSameRun)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 2, 10};
    problem.materials = {stiff_sand()};
    problem.materials[0].law = make_ubcsand(sand_of_runs());
    problem.base_motion = SineMotion{1.0, 5.0, 100.0, 0.0};
    problem.boundaries = rectangle(0.0, 0.0, 1.0, 4.0, ViscousFace{}, TiedSide{}, FreeFace{});
    problem.tied_sides = TiedSides{"left", "right", 0.0, 1.0};
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < 4.0; });
    set_level_ground_stress(problem, 4.0, 0.5, state);
    begin_shaking(problem, state); // with the memory of cycles
    attach_boundaries(problem, state.particles);
    open_balances(problem, state);
    constexpr double end = 0.1;
    Copier copier(0.4 * end);
    run(problem, end, {&copier}, state);
    State resumed = copier.copy;
    ASSERT_FALSE(resumed.reactions.x.empty());
    run(problem, end, {}, resumed);
    expect_same(resumed, state);
}

} // namespace
} // namespace quicksand
