// What the element laboratory says when it cannot do what is asked.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

using namespace testing_program;

const std::string shear_test = R"(test_version = 1
[materials.sand]
model = "ubcsand"
n1_60 = 13.9
[tests.shear]
kind = "monotonic_shear"
largest_shear_strain = "0.1 %"
)";

void write(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
}

TEST(Element, AMissingFileIsNamed)
{
    const Outcome outcome = run_program("element nowhere.toml");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "there is no file nowhere.toml");
    expect_mention(outcome, "hint: name a file of element tests, for example examples/element_dss/test.toml");
}

TEST(Element, AFolderWithoutTestsIsRefused)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("element " + folder.string());
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "holds no test.toml\nhint: name the test file itself");
}

TEST(Element, AMistakeInTheFileIsShownInItsPlaceAndNothingIsWritten)
{
    const WorkFolder folder;
    write(folder / "test.toml", shear_test + "k0 = \"half\"\n");
    const Outcome outcome = run_program("element " + folder.string() + " -o " + (folder / "out").string());
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "test.toml:8:6: error[type]: tests.shear.k0 is text");
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(Element, AStaticShearAboveTheStrengthIsRefused)
{
    const WorkFolder folder;
    write(folder / "test.toml", shear_test + "static_shear_ratio = 0.6\n");
    const Outcome outcome = run_program("element " + folder.string() + " -o " + (folder / "out").string());
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "the specimen fails in consolidation");
    expect_mention(outcome, "reduce static_shear_ratio");
}

TEST(Element, TheFolderOfTheTestIsNotThatOfTheResults)
{
    const WorkFolder folder;
    write(folder / "test.toml", shear_test);
    const Outcome outcome = run_program("element " + folder.string() + " -o " + folder.string());
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "is the folder of the test file: choose another one for the results");
}

TEST(Element, ResultsOfSomethingElseAreLeftAlone)
{
    const WorkFolder folder;
    write(folder / "test.toml", shear_test);
    std::filesystem::create_directory(folder / "out");
    write(folder / "out/run_manifest.json", "{}");
    const Outcome outcome = run_program("element " + folder.string() + " -o " + (folder / "out").string());
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "holds files that are not of element tests; nothing was removed");
    const Outcome other =
        run_program("element " + folder.string() + " -o " + (folder / "out/run_manifest.json").string());
    EXPECT_EQ(other.code, 2);
    expect_mention(other, "is a file, not a folder for results");
}

TEST(Element, AFolderThatCannotBeMadeIsAFileError)
{
    const WorkFolder folder;
    write(folder / "test.toml", shear_test);
    const Outcome outcome = run_program("element " + folder.string() + " -o /proc/quicksand/out");
    EXPECT_EQ(outcome.code, 4) << outcome.output;
    expect_mention(outcome, "/proc/quicksand/out: cannot create the folder: ");
}

TEST(Element, AnOverrideWithoutValueIsRefused)
{
    const WorkFolder folder;
    write(folder / "test.toml", shear_test);
    const Outcome outcome = run_program("element " + folder.string() + " --set tests.shear.k0");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "--set 'tests.shear.k0'");
}

TEST(Element, ASecondRunReplacesTheFirst)
{
    const WorkFolder folder;
    write(folder / "test.toml", shear_test);
    const std::string command = "element " + folder.string() + " -o " + (folder / "out").string();
    ASSERT_EQ(run_program(command).code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "out/shear/report.png"));
    const Outcome again = run_program(command + " --set materials.sand.n1_60=5");
    EXPECT_EQ(again.code, 0) << again.output;
    expect_mention(again, "(N1)60 = 5");
}

TEST(Element, KeysOfElementTestsAreListed)
{
    const Outcome outcome = run_program("keys --element k0");
    EXPECT_EQ(outcome.code, 0);
    expect_mention(outcome, "tests.NAME.k0");
    const Outcome none = run_program("keys --element porosity");
    EXPECT_EQ(none.code, 2);
    expect_mention(none, "no key of a test file contains 'porosity'");
    expect_mention(none, "hint: quicksand keys --element lists all");
}

} // namespace

} // namespace quicksand
