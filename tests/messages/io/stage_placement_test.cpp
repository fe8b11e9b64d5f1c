// Soil that stages place and remove: what is said of mistakes.
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::column_message;
using fixtures::settle_stage;

const std::string build = "[[stages]]\nname = \"build\"\nkind = \"settle\"\n";
const std::string berm = "[regions.berm]\nmaterial = \"sand\"\n";

TEST(StagePlacementMessages, RegionsAreThoseOfTheScene)
{
    EXPECT_EQ(column_message(berm + settle_stage + build + "place = [\"bern\"]\n"),
              R"_(scene.toml:62:10: error[stage]: there is no region "bern"
   62 | place = ["bern"]
      |          ^~~~~~
expected: one of sand, berm
hint: did you mean "berm"?
)_");
}

TEST(StagePlacementMessages, TheFirstStagePlacesNothing)
{
    EXPECT_EQ(
        column_message(berm + settle_stage + "place = [\"berm\"]\n"),
        R"_(scene.toml:59:10: error[stage]: the first stage cannot place soil on the ground of a stage before
   59 | place = ["berm"]
      |          ^~~~~~
expected: regions that a later stage places
hint: soil that is there from the start is not named
)_");
}

TEST(StagePlacementMessages, ARegionIsPlacedOnce)
{
    EXPECT_EQ(column_message(berm + settle_stage + build + "place = [\"berm\"]\n" +
                             "[[stages]]\nname = \"again\"\nkind = \"settle\"\nplace = [\"berm\"]\n"),
              R"_(scene.toml:66:10: error[stage]: the region "berm" has soil already when it is placed
   66 | place = ["berm"]
      |          ^~~~~~
expected: regions without soil in the stage before
hint: a region is placed once, or again after a stage that removes it
)_");
}

TEST(StagePlacementMessages, ARegionIsReplacedInTwoStages)
{
    EXPECT_EQ(column_message(berm + settle_stage + build + "remove = [\"berm\"]\nplace = [\"berm\"]\n"),
              R"_(scene.toml:63:10: error[stage]: the region "berm" has soil already when it is placed
   63 | place = ["berm"]
      |          ^~~~~~
expected: regions without soil in the stage before
hint: remove it in a stage of its own, before this one
)_");
}

TEST(StagePlacementMessages, WhatIsRemovedIsThere)
{
    EXPECT_EQ(column_message(berm + settle_stage + build + "remove = [\"berm\"]\n" +
                             "[[stages]]\nname = \"again\"\nkind = \"settle\"\nremove = [\"berm\"]\n"),
              R"_(scene.toml:66:11: error[stage]: there is no soil in the region "berm" to remove
   66 | remove = ["berm"]
      |           ^~~~~~
expected: a region that has soil in the stage before
)_");
}

TEST(StagePlacementMessages, TheFirstStageRemovesNothing)
{
    EXPECT_EQ(column_message(berm + settle_stage + "remove = [\"berm\"]\n"),
              R"_(scene.toml:59:11: error[stage]: the first stage cannot remove soil
   59 | remove = ["berm"]
      |           ^~~~~~
expected: regions that a later stage removes
hint: soil that is not there from the start is regions.berm.soil = "absent"
)_");
}

TEST(StagePlacementMessages, SomeSoilIsThereInEveryStage)
{
    EXPECT_EQ(column_message(settle_stage + build + "remove = [\"sand\"]\n"),
              R"_(scene.toml:57:1: error[stage]: no region has soil in the stage "build"
   57 | [[stages]]
      | ^~~~~~~~~~
expected: soil in at least one region of every stage
)_");
}

TEST(StagePlacementMessages, SoilIsPlacedWhereItComesToRest)
{
    EXPECT_EQ(column_message(berm + settle_stage +
                             "[[stages]]\nkind = \"shake\"\nduration = 1\nplace = [\"berm\"]\n"),
              R"_(scene.toml:62:1: error[unused-key]: stages.shake.place is not used with kind = "shake"
   62 | place = ["berm"]
      | ^~~~~
hint: remove it, or set kind = "settle"
)_");
}

TEST(StagePlacementMessages, SoilIsPresentOrAbsent)
{
    EXPECT_EQ(column_message("[regions.berm]\nmaterial = \"sand\"\nsoil = \"absend\"\n"),
              R"_(scene.toml:57:8: error[word]: regions.berm.soil = "absend" is not known
   57 | soil = "absend"
      |        ^~~~~~~~
expected: one of present, absent
hint: did you mean "absent"?
)_");
}

} // namespace
} // namespace quicksand
