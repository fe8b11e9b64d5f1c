// What `motion` says of records and of wrong words, and what it writes.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

using namespace testing_program;

constexpr const char* loma_prieta = "level_ground_motion/apeel2_loma_prieta_1989_133.AT2";

/// A record of two columns in a folder of its own.
class Motion : public testing::Test {
protected:
    void SetUp() override { std::ofstream(record) << "time,a\n0,0\n0.01,0.1\n0.02,-0.2\n0.03,0\n"; }
    void expect_refusal(const std::string& words, const std::string& text, int code = 2) const
    {
        const Outcome outcome = run_program("motion " + words + " -o " + (folder / "out").string());
        EXPECT_EQ(outcome.code, code) << words << '\n' << outcome.output;
        expect_mention(outcome, text);
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }

    WorkFolder folder;
    const std::string record = (folder / "record.csv").string();
};

TEST_F(Motion, IsMeasuredAndWritten)
{
    const std::string out = (folder / "out").string();
    for (int call = 0; call < 2; ++call) { // the second replaces what the first has written
        const Outcome outcome = run_program("motion " + example(loma_prieta) + " -o " + out);
        ASSERT_EQ(outcome.code, 0) << outcome.output;
        expect_mention(outcome, "  PGA 0.227 g at 7.55 s, PGV 0.352 m/s");
        expect_mention(outcome, "significant duration D5-95 11.9 s\n");
        expect_mention(outcome,
                       "predominant period 0.661 s, where the spectrum of 5 % damping has its peak, 0.813 g");
        expect_mention(outcome, "record.csv for a scene's motion.file with motion.unit = \"m/s2\"");
    }
    for (const char* file :
         {"histories.csv", "histories.png", "spectrum.csv", "spectrum.png", "record.csv", "motion.txt"})
        EXPECT_TRUE(std::filesystem::exists(out + "/" + file)) << file;
}

TEST_F(Motion, IsTrimmedFilteredAndScaled)
{
    const std::string out = (folder / "out").string();
    const Outcome outcome =
        run_program("motion " + example(loma_prieta) +
                    " --trim 2:25 --baseline linear --low-cut 0.1 --high-cut 20 --peak '0.3 g' -o " + out);
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    expect_mention(outcome, "  trimmed: 2 to 25 s of the record\n"
                            "  freed of the straight line that fits its accelerations best\n"
                            "  filtered: what lies from 0.1 to 20 Hz is kept\n"
                            "  multiplied by 1.331 to a peak of 0.3 g\n"
                            "  PGA 0.3 g at ");
    const Outcome again =
        run_program("motion " + out + "/record.csv --unit m/s2 -o " + (folder / "b").string());
    ASSERT_EQ(again.code, 0) << again.output;
    expect_mention(again, "  PGA 0.3 g at 5.54 s");
}

TEST_F(Motion, TellsWhatIsWrongWithARecord)
{
    expect_refusal(record, "record.csv' does not state the unit of its accelerations\n"
                           "expected: --unit g or --unit m/s2");
    expect_refusal(example(loma_prieta) + " --unit m/s2", "says G\nhint: leave --unit out");
    expect_refusal((folder / "none.AT2").string(), "none.AT2: error[file]: does not exist");
    expect_refusal(folder.string(), "error[file]: is a folder, not a file");
    std::ofstream(record) << "time,a\n0,0\n0.01,0.1\n0.03,-0.2\n";
    expect_refusal(record + " --unit g", "its time steps are between 0.01 s (line 3) and 0.02 s (line 4)");
}

TEST_F(Motion, WarnsOfAPeakThatCannotBeInItsUnit)
{
    std::ofstream(folder / "r.AT2") << "UNITS OF G\nNPTS= 3, DT= .01 SEC\n12.5 -187.2 40\n";
    const Outcome outcome =
        run_program("motion " + (folder / "r.AT2").string() + " -o " + (folder / "out").string());
    EXPECT_EQ(outcome.code, 0);
    expect_mention(outcome, "r.AT2: warning[plausibility]: the record's peak of 187.2 g is unusually large\n"
                            "expected: usually at most 2 g\n"
                            "hint: the header says UNITS OF G: are the values in another unit, as cm/s2?");
}

TEST_F(Motion, TellsWhatIsWrongWithWords)
{
    const std::string motion = record + " --unit g ";
    expect_refusal(motion + "--trim 9:10",
                   "--trim 9:10: there are fewer than two values between 9 s and 10 s\n"
                   "expected: FROM:TO within 0:0.03");
    expect_refusal(motion + "--trim 9", "'9' is no range: write two numbers");
    expect_refusal(motion + "--peak 0.3", "--peak: '0.3' is no peak acceleration\nexpected: a number above 0 "
                                          "with its unit, as \"0.3 g\" or \"2.9 m/s2\"");
    expect_refusal(
        motion + "--low-cut 5 --high-cut 2",
        "no frequency passes from --low-cut 5 Hz to --high-cut 2 Hz: the first must be the smaller one");
    expect_refusal(motion + "--damping 60", "--damping: 60 is out of range\nexpected: 0 to 50");
    expect_refusal(record + " --unit ft", "--unit: ft not in {g,m/s2}");
}

TEST_F(Motion, LeavesAUsersFolderAlone)
{
    const Outcome outcome = run_program("motion " + record + " --unit g -o " + folder.string());
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome,
                   "holds files, but no motion.txt of a former call: nothing was written. Choose another "
                   "folder with -o");
    const Outcome file = run_program("motion " + record + " --unit g -o " + record);
    EXPECT_EQ(file.code, 2);
    expect_mention(file, "record.csv is a file, not a folder for results");
}

} // namespace

} // namespace quicksand
