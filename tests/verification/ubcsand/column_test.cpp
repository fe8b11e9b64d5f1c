// A column of UBCSAND on a shaken base, as in the example but coarse: does the law count the cycles of the
// shaking, or the waves and the noise of the run?
#include "tests/fixtures/sand_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double model_height = 0.3175, shaking_frequency = 180.0, shaking_cycles = 10.0; // [m, Hz, -]
constexpr int cells_of_height = 12;

/// The column of the examples, two coarse cells wide, shaken by a sine without end.
Problem make_column(double amplitude)
{
    const double cell = model_height / cells_of_height;
    Problem problem = centrifuge_column();
    problem.grid = {{0.0, 0.0}, cell, 2, cells_of_height + 2};
    Material& sand = problem.materials[0];
    sand.law = make_ubcsand(sand_of_runs());
    sand.grain_density = 2670.0;
    sand.porosity = 0.405;
    sand.hydraulic_conductivity = 5.8e-5;
    problem.boundaries = rectangle(0.0, 0.0, 2.0 * cell, model_height, FixedWall{}, TiedSide{}, FreeFace{});
    problem.tied_sides = TiedSides{"left", "right", 0.0, 2.0 * cell};
    problem.base_motion = SineMotion{amplitude, shaking_frequency, 1e9, 2.0};
    return problem;
}

/// Legs of a history that go back by at least `least`.
class LegCounter {
public:
    void follow(double value, double least)
    {
        highest_ = std::max(highest_, value);
        lowest_ = std::min(lowest_, value);
        const bool down = sense_ >= 0 && value <= highest_ - least,
                   up = sense_ <= 0 && value >= lowest_ + least;
        if (!down && !up) return;
        if (sense_ != 0) ++turns_;
        sense_ = up ? 1 : -1;
        highest_ = lowest_ = value;
    }
    int turns() const { return turns_; }

private:
    double highest_ = 0.0, lowest_ = 0.0;
    int sense_ = 0, turns_ = 0;
};

/// Counts the reversals of every particle's shear strain.
class StrainObserver : public Observer {
public:
    explicit StrainObserver(const State& state)
        : legs(state.particles.size()), state_(state), gamma_(state.particles.size())
    {
    }
    double next_time() const override { return std::numeric_limits<double>::infinity(); }
    void observe(const Problem&, const State&, const StepReport&) override {}
    void after_step(const StepReport& report) override
    {
        const Gradients& L = state_.particles.velocity_gradient_solid;
        for (std::size_t p = 0; p < gamma_.size(); ++p) {
            gamma_[p] += report.time_step.dt * (L.xy[p] + L.yx[p]);
            legs[p].follow(gamma_[p], UbcSandRunSettings().ripple_strain);
        }
    }

    std::vector<LegCounter> legs;

private:
    const State& state_;
    std::vector<double> gamma_;
};

double mean(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

TEST(UbcSandColumn, CountsTheCyclesOfTheShaking)
{
    const Problem problem = make_column(8.0 * standard_gravity);
    State state = fill(problem, 3, [](const Vector2& x) { return x.y() < model_height; });
    set_level_ground_stress(problem, model_height, 0.5, state);
    begin_shaking(problem, state);
    StrainObserver strains(state);
    run(problem, shaking_cycles / shaking_frequency, {&strains}, state);

    // liquefaction comes down from the surface; liquefied soil is shaken no more, and counts fewer
    const Particles& particles = state.particles;
    std::vector<double> deep, all;
    double worst_of_strain = 0.0, highest_ru = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double counted = particles.memory[column_of(memory_of(UbcSand()), "half_cycles")][p];
        const double ru = 1.0 + particles.stress.yy[p] / particles.initial_vertical_effective_stress[p];
        highest_ru = std::max(highest_ru, ru);
        all.push_back(counted);
        if (particles.position.y[p] > 0.6 * model_height) continue;
        EXPECT_LT(ru, 0.95);
        deep.push_back(counted);
        worst_of_strain = std::max(worst_of_strain, std::abs(counted - strains.legs[p].turns()));
    }
    const auto [least, most] = std::minmax_element(deep.begin(), deep.end());
    RecordProperty("least", std::to_string(*least));
    RecordProperty("most", std::to_string(*most));
    RecordProperty("mean_of_deep", std::to_string(mean(deep)));
    RecordProperty("mean_of_all", std::to_string(mean(all)));
    RecordProperty("highest_ru", std::to_string(highest_ru));
    RecordProperty("worst_of_strain", std::to_string(worst_of_strain));
    EXPECT_NEAR(*least, 2.0 * shaking_cycles, 0.1 * 2.0 * shaking_cycles);
    EXPECT_NEAR(*most, 2.0 * shaking_cycles, 0.1 * 2.0 * shaking_cycles);
    EXPECT_LE(worst_of_strain, 1.0);
    EXPECT_NEAR(mean(all), 2.0 * shaking_cycles, 0.1 * 2.0 * shaking_cycles);
    EXPECT_GT(highest_ru, 0.95); // liquefaction has begun
    EXPECT_LT(highest_ru, 1.0);
}

} // namespace
} // namespace quicksand
