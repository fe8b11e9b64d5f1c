// The report on a run: one page that needs nothing else and shows the user's words as text.
#include "tests/examples/program.hpp"
#include "tests/fixtures/checkout.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

using namespace testing_program;

/// A short run of the column, whose title is not what a page should take for markup.
class Report : public testing::Test {
protected:
    void SetUp() override
    {
        const std::string scene = (folder / "scene").string();
        const Outcome run = run_shell(
            "cp -r " + example("column") + " " + scene + " && sed -i 's|^title.*|title = \"<script>" +
            "alert(1)</script> \\& Co\"|' " + scene + "/scene.toml && \"$QUICKSAND\" run " + scene +
            " --until 2e-3 --set output.frame_interval=5e-4 -o " + results);
        ASSERT_EQ(run.code, 0) << run.output;
    }
    /// What report_check.py finds wrong, and how many pictures there are.
    static Outcome check(const std::string& page, const std::string& texts = "")
    {
        return run_shell("python3 " + in_checkout("tests/examples/report_check.py") + " " + page + " " +
                         texts);
    }

    WorkFolder folder;
    const std::string results = (folder / "out").string();
};

TEST_F(Report, IsOneFileWithAllItsPictures)
{
    const Outcome made = run_program("report " + results + " --required-height 0.1");
    ASSERT_EQ(made.code, 0) << made.output;
    EXPECT_NE(made.output.find("report.html ("), std::string::npos) << made.output;
    const Outcome checked = check(results + "/report.html",
                                  "'<script>alert(1)</script> & Co' 'The crest keeps the required height.' "
                                  "'Verdict on its balances: good' 'scene_version = 1' 'PGA'");
    EXPECT_EQ(checked.code, 0) << checked.output;
    EXPECT_EQ(read_file(results + "/report.html").find("<script>alert"), std::string::npos);
}

// Every picture of the page can be seen.
TEST_F(Report, OpensInABrowser)
{
    if (run_shell("command -v chromium").code != 0) GTEST_SKIP() << "chromium is not installed";
    ASSERT_EQ(run_program("report " + results).code, 0);
    // the page, with a script behind it that counts what a reader sees
    const std::string page = results + "/report.html", counted = results + "/counted.html";
    std::ofstream(counted) << read_file(page)
                           << "<script>onload = () => document.title = 'seen ' + [...document.images].filter("
                              "image => image.naturalWidth > 100).length + ' of ' + document.images.length;"
                              "</script>";
    const Outcome seen = run_shell("timeout 60 chromium --headless --no-sandbox --disable-gpu "
                                   "--virtual-time-budget=5000 --dump-dom \"file://" +
                                   counted + "\" 2>/dev/null");
    ASSERT_EQ(seen.code, 0) << seen.output;
    const Outcome checked = check(page);
    const std::string pictures = checked.output.substr(0, checked.output.find(' '));
    EXPECT_NE(seen.output.find("<title>seen " + pictures + " of " + pictures + "</title>"), std::string::npos)
        << pictures << '\n'
        << seen.output.substr(0, 2000);
}

// The shape of small strain is that of the drawing.
TEST_F(Report, TellsOfSettlementThatTheShapeDoesNotHave)
{
    const std::string stages = (folder / "scene/stages.toml").string(), staged = (folder / "staged").string();
    std::ofstream(stages) << "scene_version = 1\nbase = \"scene.toml\"\n[analysis]\nstrain = \"small\"\n"
                             "[[stages]]\nname = \"rest\"\nkind = \"settle\"\n"
                             "[[stages]]\nname = \"again\"\nkind = \"settle\"\n"
                             "[stages.boundaries.surface]\npressure = \"10 kPa\"\n"
                             "[[stages]]\nname = \"shaking\"\nkind = \"shake\"\nduration = \"1 ms\"\n";
    ASSERT_EQ(run_program("run " + stages + " -o " + staged).code, 0);
    ASSERT_EQ(run_program("report " + staged).code, 0);
    const std::string told = "In small strain soil that settles in later stages keeps the shape as drawn";
    EXPECT_NE(read_file(staged + "/shaking/report.html").find(told), std::string::npos);
    ASSERT_EQ(run_program("report " + results).code, 0);
    EXPECT_EQ(read_file(results + "/report.html").find(told), std::string::npos);
}

TEST_F(Report, TellsWhatItIsAskedInVain)
{
    const auto refuse = [&](const std::string& words, const std::string& text) {
        const Outcome outcome = run_program("report " + words);
        EXPECT_EQ(outcome.code, 2) << words << '\n' << outcome.output;
        EXPECT_NE(outcome.output.find(text), std::string::npos) << outcome.output;
    };
    refuse(folder.string(), "there are no results in ");
    refuse(results + " --field ruu", "there is no field 'ruu' in the results. Available: ");
    refuse(results + " --required-height high", "--required-height: high is not a finite number");
    EXPECT_FALSE(std::filesystem::exists(results + "/report.html"));
}

} // namespace

} // namespace quicksand
