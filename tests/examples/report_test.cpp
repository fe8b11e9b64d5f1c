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
