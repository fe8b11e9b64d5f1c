// Random scenes: the same from the same seed wherever they are made, and all of them readable.
#include "app/stress/rows/row_files.hpp"
#include "app/stress/scenes/random_numbers.hpp"
#include "app/stress/scenes/random_scene.hpp"
#include "io/scene/scene_file.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

TEST(RandomNumbers, AreThoseOfTheStandardsEngine)
{
    // mt19937_64 seeded with splitmix64(splitmix64(1) + 1), from another implementation of both
    RandomNumbers random(1, 1);
    EXPECT_EQ(random.fraction(), 0.7166913209529362);
    EXPECT_EQ(random.fraction(), 0.7461285092453199);
    EXPECT_EQ(random.whole(1, 1000), 612);
}

TEST(RandomNumbers, StayWithinTheirLimits)
{
    RandomNumbers random(3, 4);
    bool first = false, last = false;
    for (int k = 0; k < 1000; ++k) {
        const double between = random.between(-2.0, 3.0), logarithmic = random.logarithmic(1e-3, 1e2);
        EXPECT_TRUE(between >= -2.0 && between < 3.0);
        EXPECT_TRUE(logarithmic >= 1e-3 && logarithmic < 1e2);
        const int whole = random.whole(2, 4);
        EXPECT_TRUE(whole >= 2 && whole <= 4);
        first = first || whole == 2;
        last = last || whole == 4;
    }
    EXPECT_TRUE(first && last);
}

TEST(RandomScenes, AreTheSameFromTheSameSeed)
{
    for (int number = 1; number <= 5; ++number) {
        const StressRows once = random_rows(7, number), again = random_rows(7, number);
        ASSERT_EQ(once.size(), again.size());
        EXPECT_EQ(once.front().scene, again.front().scene);
        EXPECT_EQ(once.front().drawing, again.front().drawing);
        EXPECT_NE(once.front().drawing, random_rows(8, number).front().drawing);
        EXPECT_NE(once.front().drawing, random_rows(7, number + 1).front().drawing);
    }
}

TEST(RandomScenes, DifferBetweenTwinsInTheSchemeAlone)
{
    for (int number = 1; number <= 20; ++number) {
        const StressRows rows = random_rows(1, number);
        if (rows.size() < 3) continue; // its water does not flow
        EXPECT_EQ(rows[1].twin, rows[0].name);
        EXPECT_EQ(rows[1].drawing, rows[0].drawing);
        std::string twin = rows[1].scene;
        twin.replace(twin.find("\"semi_implicit\"\n"), 15, "\"explicit\"");
        EXPECT_EQ(twin.substr(twin.find('\n')), rows[0].scene.substr(rows[0].scene.find('\n')));
    }
}

TEST(RandomScenes, HaveARowInImplicitSteps)
{
    for (int number = 1; number <= 20; ++number) {
        const StressRow row = random_rows(1, number).back();
        if (row.scene.find("flow = \"undrained\"") != std::string::npos) continue;
        EXPECT_NE(row.scene.find("scheme = \"implicit\"\n"), std::string::npos) << row.id();
        EXPECT_TRUE(row.twin.empty());
    }
}

TEST(RandomScenes, HaveKeysThatScenesKnow)
{
    const fixtures::TemporaryFolder folder;
    for (int number = 1; number <= 40; ++number) {
        for (const StressRow& row : random_rows(2, number)) {
            const RowFiles files = files_of(folder.path(), row);
            write_row(row, files);
            EXPECT_NO_THROW(read_scene_file(files.scene(), {})) << row.id();
        }
    }
}

} // namespace
} // namespace quicksand
