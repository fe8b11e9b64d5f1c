// Mistakes on the command line: exit code 2, what is allowed, and the word that was meant.
#include "tests/examples/program.hpp"
#include "tests/fixtures/checkout.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

using namespace testing_program;

TEST(CommandLine, WithoutWordsShowsTheHelp)
{
    const Outcome outcome = run_program("");
    EXPECT_EQ(outcome.code, 0);
    for (const char* command :
         {"run", "sweep", "check", "stability", "new", "element", "motion", "keys", "probe", "picture",
          "figures", "demo", "verify", "bench", "stress", "manual", "version"}) {
        expect_mention(outcome, command);
    }
    expect_mention(outcome, "Exit codes");
}

TEST(CommandLine, EveryCommandHasHelp)
{
    for (const char* command :
         {"run", "sweep", "check", "stability", "new", "element", "motion", "keys", "probe", "picture",
          "figures", "demo", "verify", "bench", "stress", "manual", "version"}) {
        EXPECT_EQ(run_program(std::string(command) + " --help").code, 0) << command;
    }
}

TEST(CommandLine, HelpIsAWordToo)
{
    EXPECT_EQ(run_program("help").output, run_program("--help").output);
    const Outcome of_command = run_program("help run");
    EXPECT_EQ(of_command.code, 0);
    EXPECT_EQ(of_command.output, run_program("run --help").output);
}

TEST(CommandLine, TheVersionIsTheNewestOfTheChangelog)
{
    const std::string changelog = read_file(in_checkout("CHANGELOG.md"));
    const std::size_t begin = changelog.find("\n## [", changelog.find("## [Unreleased]")) + 5;
    const std::string newest = changelog.substr(begin, changelog.find(']', begin) - begin);
    EXPECT_EQ(run_program("version").output, "Quicksand " + newest + "\n");
    EXPECT_EQ(run_program("--version").output, "Quicksand " + newest + "\n");
}

TEST(CommandLine, AMisspeltCommandIsGuessed)
{
    const Outcome outcome = run_program("chek examples/dike");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "there is no command 'chek'");
    expect_mention(outcome, "did you mean check?");
}

TEST(CommandLine, AnUnknownCommandListsTheCommands)
{
    const Outcome outcome = run_program("frobnicate");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome,
                   "expected: run, sweep, check, stability, new, element, motion, validity, calibrate, "
                   "probe, picture, figures, "
                   "compare, report, demo, "
                   "verify, bench, stress, keys, manual, version");
}

TEST(CommandLine, AnUnknownPageOfTheManualListsThePages)
{
    const Outcome outcome = run_program("manual scenes");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "scenes not in {quicksand,quicksand-scene,quicksand-element}");
}

TEST(CommandLine, OneBenchTakesOneScene)
{
    for (const std::string subject : {"kernel", "grid", "scale"}) {
        const Outcome outcome =
            run_program("bench " + subject + " " + example("dike") + " " + example("column"));
        EXPECT_EQ(outcome.code, 2);
        expect_mention(outcome, "bench kernel, grid and scale measure one scene, 2 are given");
        expect_mention(outcome, "hint: bench skip compares several scenes");
    }
}

TEST(CommandLine, ABenchOfNothingKnownListsItsSubjects)
{
    const Outcome outcome = run_program("bench speed");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "SUBJECT: speed not in {kernel,error,grid,scale,skip}");
    expect_mention(outcome, "hint: quicksand bench --help shows what is allowed");
}

TEST(CommandLine, AMisspeltOptionIsGuessed)
{
    const Outcome outcome = run_program("run " + example("dike") + " --thread 2");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "run knows no option '--thread'");
    expect_mention(outcome, "did you mean --threads?");
}

TEST(CommandLine, AMisspeltOptionWithEqualsSignIsGuessed)
{
    const Outcome outcome = run_program("check " + example("dike") + " --untill=0.1");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "check knows no option '--untill'");
    expect_mention(outcome, "did you mean --until?");
}

TEST(CommandLine, AMissingSceneIsNamed)
{
    const Outcome outcome = run_program("run");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "SCENE is required");
}

TEST(CommandLine, AFurtherWordIsRefused)
{
    const Outcome outcome = run_program("version now");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "version knows no further word 'now'\nexpected: quicksand version --help shows");
}

TEST(CommandLine, ThreadsHaveARange)
{
    const Outcome outcome = run_program("run " + example("dike") + " --threads 0");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "--threads");
}

TEST(CommandLine, UntilMustBePositive)
{
    const Outcome outcome = run_program("run " + example("dike") + " --until -1");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "--until");
}

TEST(CommandLine, ResumeAndOverwriteExcludeEachOther)
{
    const Outcome outcome = run_program("run " + example("dike") + " --resume --overwrite");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "excludes");
}

TEST(CommandLine, APlaceNeedsTwoNumbers)
{
    const Outcome outcome = run_program("probe results --at 0.1 --fields ru -o a.csv");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "--at");
}

TEST(CommandLine, AFullDiskUnderStandardOutputIsAFileError)
{
    for (const std::string words : {"version", "keys", "--help"}) {
        const Outcome outcome = run_shell("\"$QUICKSAND\" " + words + " > /dev/full");
        EXPECT_EQ(outcome.code, 4) << words;
        expect_mention(outcome, "standard output cannot be written");
    }
}

TEST(Installation, WithoutItsReaderOfDrawingsIsNamed)
{
    const WorkFolder folder;
    std::filesystem::create_directory(folder / "bin");
    const Outcome outcome =
        run_shell("cp \"$QUICKSAND\" " + folder.string() + "/bin/quicksand && " + folder.string() +
                  "/bin/quicksand check " + example("column") + " -o " + folder.string() + "/out");
    EXPECT_EQ(outcome.code, 4) << outcome.output;
    expect_mention(outcome,
                   "cannot find the program that reads .geo and .msh files: it is neither here nor ");
    expect_mention(outcome, "hint: install Quicksand completely");
}

TEST(Keys, APatternSelects)
{
    const Outcome outcome = run_program("keys porosity");
    EXPECT_EQ(outcome.code, 0);
    expect_mention(outcome, "porosity");
    EXPECT_EQ(outcome.output.find("end_time"), std::string::npos);
}

TEST(Keys, APatternWithoutKeysIsAMistake)
{
    const Outcome outcome = run_program("keys xyzzy");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "no key of a scene contains 'xyzzy'");
}

TEST(New, AnUnknownKindIsGuessed)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("new dyke " + (folder / "mine").string());
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "there is no kind of scene 'dyke'\nexpected: one of column, dike, river_dike, "
                            "sea_dike, level_site, slope\n");
    expect_mention(outcome, "did you mean dike?");
}

TEST(New, ANameThatNoFileCanHaveIsRefused)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("new dike " + folder.string() + "/'my\"dike'");
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "my\"dike' cannot be the name of a scene: it must be a plain folder name");
    EXPECT_TRUE(std::filesystem::is_empty(folder.string()));
}

TEST(New, AnExistingFolderIsLeftAlone)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("new dike " + folder.string());
    EXPECT_EQ(outcome.code, 2);
    expect_mention(outcome, "exists already");
    EXPECT_TRUE(std::filesystem::is_empty(folder.string()));
}

} // namespace

} // namespace quicksand
