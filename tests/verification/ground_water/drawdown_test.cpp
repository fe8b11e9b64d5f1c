// The water beside a dike falls in a stage of its own, after the steady flow of a flood.
#include "io/scene/scene_file.hpp"
#include "solver/measure/balances.hpp"
#include "solver/run/staged_run.hpp"
#include "tests/fixtures/drawn_section.hpp"
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double flood = 3.0; // head on the left slope [m]

/// A dike 5 m high on 2 m of ground; the last stage has these keys, and these of the left slope.
std::string drawdown_scene(const std::string& stage, const std::string& river)
{
    return R"(scene_version = 1
[geometry]
file = "drawing.geo"
[grid]
cell_size = 0.5
[sampling]
particles_per_cell = [2, 2]
[analysis]
scheme = "semi_implicit"
[water]
level = 0.0
[materials.soil]
hydraulic_conductivity = 1e-5
)" + elastic.substr(elastic.find("]") + 1) +
           R"(
)" + base_and_sides +
           R"([boundaries.river]
water = "drained"
[boundaries.land]
water = "drained"
[[stages]]
name = "gravity"
kind = "settle"
[[stages]]
name = "flood"
kind = "seepage"
[stages.boundaries.river]
water = "head"
head = 3.0
[[stages]]
name = "fall"
)" + stage +
           "[stages.boundaries.river]\n" + river;
}

Section drawdown_dike()
{
    return polygon_section({{{-15.0, -2.0}, "base"},
                            {{15.0, -2.0}, "right"},
                            {{15.0, 0.0}, "land"},
                            {{12.0, 0.0}, "land"},
                            {{2.0, 5.0}, "surface"},
                            {{-2.0, 5.0}, "river"},
                            {{-12.0, 0.0}, "river"},
                            {{-15.0, 0.0}, "left"}});
}

std::vector<SceneReading> stages_of(const std::string& scene)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "drawing.geo") << "Point(1) = {0, 0, 0};\n";
    std::ofstream(folder / "scene.toml") << scene;
    return read_scene_stages(folder / "scene.toml", {});
}

std::vector<AssembledCase> assembled_stages(const std::string& scene)
{
    std::vector<AssembledCase> stages;
    for (SceneReading& reading : stages_of(scene)) {
        if (!stages.empty()) reading.parted_before = stages.front().water_lines; // as in a run
        stages.push_back(assemble_case(std::move(reading), drawdown_dike()));
    }
    return stages;
}

AssembledCase assembled_stage(const std::string& scene, std::size_t stage)
{
    return assemble_case(std::move(stages_of(scene)[stage]), drawdown_dike());
}

double wet_volume(const AssembledCase& stage)
{
    const Particles& particles = stage.state.particles;
    double volume = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p)
        if (is_wet(stage.problem.materials[static_cast<std::size_t>(particles.material[p])]))
            volume += particles.volume[p];
    return volume;
}

const Boundary& river_of(const AssembledCase& stage)
{
    return *std::find_if(stage.problem.boundaries.begin(), stage.problem.boundaries.end(),
                         [](const Boundary& boundary) { return boundary.name == "river"; });
}

TEST(Drawdown, LeavesSoilWetThatWasUnderWater)
{
    const auto stages =
        assembled_stages(drawdown_scene("kind = \"shake\"\nduration = 0.1\n", "head = 0.0\n"));
    EXPECT_GT(wet_volume(stages[1]), wet_volume(stages[0]) + 5.0);
    EXPECT_EQ(wet_volume(stages[2]), wet_volume(stages[1]));
}

/// Corners of a particle that is no piece.
std::array<Vector2, 4> corners_of(const Particles& particles, std::size_t p)
{
    const Vector2 centre = particles.position[p], a = particles.half_edge_1[p], b = particles.half_edge_2[p];
    return {centre - a - b, centre + a - b, centre + a + b, centre - a + b};
}

/// How far the water of a stage stands within single particles at most [m].
double table_within_particles(const AssembledCase& stage)
{
    const Particles& particles = stage.state.particles;
    const std::vector<std::uint8_t>& pieces = stage.problem.cut_domains.pieces;
    double within = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (pieces[p] != 0) continue;
        double above = 0.0, below = 0.0;
        for (const Vector2& corner : corners_of(particles, p)) {
            const double rise = corner.y() - stage.initial_flow->field.surface(corner.x()).value_or(-2.0);
            above = std::max(above, rise);
            below = std::max(below, -rise);
        }
        within = std::max(within, std::min(above, below));
    }
    return within;
}

// Later stages have their lines from the first one on: their particles are those of the first.
TEST(Drawdown, PartsTheParticlesOfAllStagesAtTheLinesOfEach)
{
    const auto stages = assembled_stages(drawdown_scene("kind = \"seepage\"\n", "head = 1.3\n"));
    for (const AssembledCase& stage : stages)
        EXPECT_EQ(stage.state.particles.size(), stages[0].state.particles.size());
    // their boxes are 0.25 m high, and a line is straight over each of them
    for (const std::size_t flows : {1, 2}) EXPECT_LT(table_within_particles(stages[flows]), 0.005) << flows;
}

TEST(Drawdown, SoilSettlesAnewWithTheWaterOfItsStage)
{
    const auto stages = assembled_stages(drawdown_scene("kind = \"seepage\"\n", "head = 0.0\n"));
    EXPECT_NEAR(wet_volume(stages[2]), wet_volume(stages[0]), 1e-9);
}

TEST(Drawdown, RampsFromTheHeadOfTheStageBefore)
{
    const auto stages = assembled_stages(
        drawdown_scene("kind = \"shake\"\nduration = 4.0\n", "head = 1.0\nramp_time = 4.0\n"));
    const AssembledCase& fall = stages[2];
    const Vector2 toe(-12.0, 0.0);
    const auto head_at = [&](double time) {
        return outer_excess_pressure(fall.problem, river_of(fall), toe,
                                     outer_factor(river_of(fall).water, time)) /
               (fall.problem.water->density * fall.problem.gravity);
    };
    EXPECT_NEAR(head_at(0.0), flood, 1e-12);
    EXPECT_NEAR(head_at(1.0), 2.5, 1e-12);
    EXPECT_NEAR(head_at(4.0), 1.0, 1e-12);
    EXPECT_NEAR(wet_volume(fall), wet_volume(stages[1]), 0.2); // the line is found on another mesh
}

const std::string in_time = "kind = \"seepage\"\nduration = ";

// Pores drain as fast as water falls through them: by 3 mm in 100 s, less than a particle.
TEST(Drawdown, DrainsTheSoilInTime)
{
    const auto wet_after = [&](const std::string& duration) {
        return wet_volume(
            assembled_stage(drawdown_scene(in_time + "\"" + duration + "\"\n", "head = 0.0\n"), 2));
    };
    const std::string sudden = drawdown_scene("kind = \"seepage\"\n", "head = 0.0\n");
    const double flooded = wet_volume(assembled_stage(sudden, 1)),
                 steady = wet_volume(assembled_stage(sudden, 2)), part = 0.05 * (flooded - steady);
    EXPECT_NEAR(wet_after("100 s"), flooded, part);
    const double day = wet_after("1 d");
    EXPECT_LT(day, flooded - part);
    EXPECT_GT(day, steady + part);
}

// What flows in time is told by no heads: later stages have the flow that it has come to, and the water
// beyond the slope stays as it is then.
TEST(Drawdown, LaterStagesKeepTheFlowInTime)
{
    const std::string search = R"([[stages]]
name = "safety"
kind = "stability"
[[stages]]
name = "rest"
kind = "consolidate"
duration = "1 d"
)";
    const auto stages = assembled_stages(fixtures::replaced(
        drawdown_scene(in_time + "\"1 d\"\n", "head = 1.0\nramp_time = \"2 d\"\n" + search),
        "model = \"linear_elastic\"", "model = \"mohr_coulomb\"\ncohesion = 1000\nfriction_angle = 30"));
    for (const std::size_t later : {3, 4}) {
        EXPECT_EQ(wet_volume(stages[later]), wet_volume(stages[2]));
        EXPECT_EQ(stages[later].initial_flow->field.head({0.0, 1.0}),
                  stages[2].initial_flow->field.head({0.0, 1.0}));
    }
    const Vector2 toe(-12.0, 0.0);
    const auto head_at = [&](std::size_t stage, double time) {
        const AssembledCase& of_stage = stages[stage];
        return outer_excess_pressure(of_stage.problem, river_of(of_stage), toe,
                                     outer_factor(river_of(of_stage).water, time)) /
               (of_stage.problem.water->density * of_stage.problem.gravity);
    };
    EXPECT_NEAR(head_at(2, 0.0), 2.0, 1e-9); // half of the fall from 3 to 1
    EXPECT_NEAR(head_at(2, 1e6), 2.0, 1e-9);
    EXPECT_NEAR(head_at(3, 0.0), 2.0, 1e-9);
    EXPECT_NEAR(head_at(4, 43200.0), 1.5, 1e-9); // and goes on in what is left of its two days
    EXPECT_NEAR(head_at(4, 86400.0), 1.0, 1e-9);
}

// A second stage in time goes on from the first.
TEST(Drawdown, FlowsOnInTime)
{
    const std::string second = R"([[stages]]
name = "more"
kind = "seepage"
duration = "1 d"
)";
    const auto one = assembled_stage(drawdown_scene(in_time + "\"2 d\"\n", "head = 0.0\n"), 2),
               two = assembled_stage(drawdown_scene(in_time + "\"1 d\"\n", "head = 0.0\n" + second), 3);
    EXPECT_NEAR(two.initial_flow->field.head({0.0, 1.0}), one.initial_flow->field.head({0.0, 1.0}), 0.03);
}

/// The state at the end of the last of three stages, the first two of which settle.
State end_of(std::vector<AssembledCase>& stages)
{
    State state;
    for (std::size_t k = 0; k < stages.size(); ++k) {
        const bool settles = k < 2;
        StagedRun run(stages[k].problem, std::move(stages[k].state),
                      {settles ? 0.0 : stages[k].scene.end_time, ColumnsComputed::all, true});
        StageStart start;
        start.settles = settles;
        if (k > 0) run.go_on_from(std::move(state), start);
        if (settles) {
            run.settle(*stages[k].scene.relaxation);
        } else {
            run.shake({});
        }
        state = run.state();
    }
    return state;
}

// Soil above the new level lost its water, and kept its pressures: steps seemed to make energy.
TEST(Drawdown, KeepsItsEnergyWhenTheWaterFallsAtOnce)
{
    for (const std::string scheme : {"semi_implicit", "implicit"}) {
        auto stages = assembled_stages(drawdown_scene(
            "kind = \"shake\"\nduration = 0.5\n[stages.analysis]\nscheme = \"" + scheme + "\"\n",
            "head = 0.0\n"));
        const State state = end_of(stages);
        EXPECT_NEAR(state.time, 0.5, 1e-12) << scheme;
        EXPECT_LT(std::abs(energy_balance(stages[2].problem, state).error()), 0.01) << scheme;
    }
}

std::string replaced_all(std::string text, const std::string& from, const std::string& to)
{
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

// Dashpots alone let the soil sink out of the grid within the hour.
TEST(Drawdown, CurvesThatLetWavesOutHoldTheSoilOverHours)
{
    const std::string scene = replaced_all(
        replaced_all(drawdown_scene("kind = \"consolidate\"\nduration = \"1 h\"\n", "head = 0.0\n"),
                     "\"roller\"", "\"free_field\""),
        "\"fixed\"", "\"viscous\"");
    auto stages = assembled_stages(scene);
    const State state = end_of(stages);
    EXPECT_NEAR(state.time, 3600.0, 1e-6);
    const Particles& particles = state.particles;
    double of_base = 0.0, of_sides = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 from = particles.reference_position[p], moved = particles.position[p] - from;
        if (from.y() < -1.75) of_base = std::max(of_base, moved.norm());
        if (std::abs(from.x()) > 14.75) of_sides = std::max(of_sides, std::abs(moved.x()));
    }
    EXPECT_LT(of_base, 1e-3);
    EXPECT_LT(of_sides, 1e-3);
}

} // namespace
} // namespace quicksand
