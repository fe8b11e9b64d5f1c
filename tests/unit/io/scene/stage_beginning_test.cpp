// The water beyond a curve in scenes with stages: a head goes on from where the stage before left it.
#include "io/scene/stage_beginning.hpp"
#include "io/tables/scene_boundaries.hpp"
#include "solver/faces/water_condition.hpp"
#include "tests/fixtures/slope_example.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using fixtures::SceneFolder;
using fixtures::slope_scene;

const Boundary& ground_of(const Scene& scene)
{
    return find_boundary(scene, "ground")->boundary;
}

/// Surface of the water beyond the ground at the begin and the end of a stage [m].
struct Surface {
    double begin, end;
};

/// By the pressure at a place that is below all of the water.
double surface_at(const Scene& scene, double time)
{
    const Vector2 below(10.0, -7.0);
    const StillWater still{1.0, scene.water->level};
    const WaterCondition& water = ground_of(scene).water;
    return below.y() + pressure_below(still, still.level, below.y()) +
           outer_excess(water, still, below, outer_factor(water, time));
}

std::vector<Surface> surfaces(const std::string& water, const std::string& ground, const std::string& stages)
{
    const SceneFolder folder;
    folder.write("scene.toml", slope_scene(water, ground) + stages);
    std::vector<Surface> all;
    for (const SceneReading& stage : read_scene_stages(folder.file("scene.toml"), {}))
        all.push_back({surface_at(stage.scene, 0.0),
                       surface_at(stage.scene, stage.scene.stage->flow_duration.value_or(0.0))});
    return all;
}

void expect_surfaces(const std::vector<Surface>& got, const std::vector<Surface>& expected)
{
    ASSERT_EQ(got.size(), expected.size());
    for (std::size_t k = 0; k < got.size(); ++k) {
        EXPECT_NEAR(got[k].begin, expected[k].begin, 1e-12) << k;
        EXPECT_NEAR(got[k].end, expected[k].end, 1e-12) << k;
    }
}

const std::string risen = "soil = \"free\"\nwater = \"head\"\nhead = 4\nramp_time = \"2 d\"\n";
const std::string day = "kind = \"seepage\"\nduration = \"1 d\"\n";
const std::string two_days = "[[stages]]\nname = \"one\"\n" + day + "[[stages]]\nname = \"two\"\n" + day;

TEST(StageBeginning, ARampGoesOnWhereTheStageBeforeLeftIt)
{
    expect_surfaces(surfaces("level = 2", risen, two_days), {{2.0, 3.0}, {3.0, 4.0}});
    expect_surfaces(surfaces("level = 2", risen, two_days + "[[stages]]\nname = \"three\"\n" + day),
                    {{2.0, 3.0}, {3.0, 4.0}, {4.0, 4.0}});
}

TEST(StageBeginning, AnotherHeadRisesFromWhereTheWaterStands)
{
    const std::string change = "[stages.boundaries.ground]\nhead = 2.5\nramp_time = \"1 d\"\n";
    expect_surfaces(surfaces("level = 2", risen, two_days + change), {{2.0, 3.0}, {3.0, 2.5}});
    expect_surfaces(
        surfaces("level = 2", risen, two_days + change + "[[stages]]\nname = \"three\"\n" + day + change),
        {{2.0, 3.0}, {3.0, 2.5}, {2.5, 2.5}});
}

TEST(StageBeginning, AHeadHasRisenFromThePhreaticLine)
{
    const std::string change = "[stages.boundaries.ground]\nhead = 3.5\nramp_time = \"1 d\"\n";
    const auto all =
        surfaces("level = 0\nphreatic_line = [[0, 3.8], [6, 2], [12, 2]]", risen, two_days + change);
    expect_surfaces({all[1]}, {{3.0, 3.5}}); // the first stage gets the line in its assembly
}

TEST(StageBeginning, WaterThatStandsAtItsHeadVariesNoMore)
{
    const SceneFolder folder; // rounding: 1.1 + (3.3 - 1.1) is not 3.3
    folder.write("scene.toml", slope_scene("level = 1.1", "soil = \"free\"\nwater = \"head\"\nhead = 3.3\n"
                                                          "ramp_time = \"1 d\"\n") +
                                   two_days + "[stages.boundaries.ground]\nramp_time = \"2 d\"\n");
    const auto stages = read_scene_stages(folder.file("scene.toml"), {});
    EXPECT_FALSE(varies(std::get<PrescribedWater>(ground_of(stages[1].scene).water).history));
}

TEST(StageBeginning, WaterGoesOnWhereNoOtherStillWaterComes)
{
    const auto goes_on = [](const std::string& stages) {
        const SceneFolder folder;
        folder.write("scene.toml", slope_scene("level = 2", risen) + stages);
        const auto read = read_scene_stages(folder.file("scene.toml"), {});
        return find_boundary(read.back().scene, "ground")->water_goes_on;
    };
    const std::string rest = "[[stages]]\nkind = \"settle\"\n";
    EXPECT_TRUE(goes_on(two_days + rest));
    EXPECT_FALSE(goes_on(two_days + rest + "[stages.water]\nlevel = 1\n"));
}

TEST(StageBeginning, WaterThatHasBecomeGoesOnFromATimeToo)
{
    const SceneFolder folder;
    folder.write("scene.toml", slope_scene("level = 2", risen) + two_days);
    Scene scene = read_scene_stages(folder.file("scene.toml"), {}).back().scene;
    begin_later(0.0, scene);
    EXPECT_TRUE(find_boundary(scene, "ground")->water_goes_on);
}

} // namespace
} // namespace quicksand
