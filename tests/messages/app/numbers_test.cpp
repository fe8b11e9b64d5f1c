// Numbers of the command line: finite and in range, or exit code 2 with what is allowed.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

using namespace testing_program;

void expect_refused_number(const std::string& arguments, const std::string& what, const std::string& allowed)
{
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments << '\n' << outcome.output;
    EXPECT_NE(outcome.output.find(what), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("expected: " + allowed), std::string::npos) << outcome.output;
}

TEST(Numbers, AreFinite)
{
    const WorkFolder folder;
    const std::string output = " -o " + (folder / "out").string(), column = example("column");
    const auto refuse = [&](const std::string& command, const std::string& option, const std::string& word,
                            const std::string& allowed) {
        expect_refused_number(command + output + " " + option + " " + word,
                              option + ": " + word.substr(0, word.find(',')) + " is not a finite number",
                              allowed);
    };
    for (const std::string word : {"nan", "inf", "1e999"}) {
        refuse("run " + column, "--until", word, "more than 0");
        refuse("check " + column, "--until", word, "more than 0");
        refuse("stability " + column, "--tolerance", word, "1e-4 to 0.5");
        refuse("stability " + column, "--seismic-coefficient", word, "-2 to 2");
        refuse("probe results --fields ru", "--at", word + ",0", "any number");
        refuse("picture results", "--time", word, "any number");
        refuse("picture results", "--exaggeration", word, "more than 0");
        refuse("bench error", "--until", word, "more than 0");
        refuse("bench scale", "--largest", word, "1000 to 1e8");
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.string()));
}

TEST(Numbers, HaveTheirRange)
{
    const std::string column = example("column");
    expect_refused_number("run " + column + " --until 0", "--until: 0 is out of range", "more than 0");
    expect_refused_number("run " + column + " --threads 1025", "--threads: 1025 is out of range",
                          "1 to 1024");
    expect_refused_number("stability " + column + " --tolerance 0.6", "--tolerance: 0.6 is out of range",
                          "1e-4 to 0.5");
}

TEST(Threads, ThatTheSystemDoesNotStartAreRefused)
{
    const WorkFolder folder;
    const Outcome outcome =
        run_shell("ulimit -s 8192; ulimit -v 2500000\n\"$QUICKSAND\" run " + example("column") +
                  " --threads 1024 -o " + (folder / "results").string());
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    EXPECT_NE(outcome.output.find(" threads, not the 1024 asked for: "), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("hint: ask for fewer with --threads"), std::string::npos) << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(folder / "results"));
}

TEST(Threads, FarBeyondTheProcessorsAreWarnedOf)
{
    const WorkFolder folder;
    const Outcome outcome = run_shell("taskset 1 \"$QUICKSAND\" run " + example("column") +
                                      " --until 1e-5 --threads 5 -o " + (folder / "results").string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("warning: 5 threads share the machine's processors (1): the run takes "
                                  "longer than with --threads 1"),
              std::string::npos)
        << outcome.output;
}

TEST(Numbers, OfOverridesAreFinite)
{
    const WorkFolder folder;
    for (const std::string word : {"nan", "inf", "-inf"}) {
        const Outcome outcome = run_program("check " + example("column") + " --set run.end_time=" + word +
                                            " -o " + (folder / "out").string());
        EXPECT_EQ(outcome.code, 2) << outcome.output;
        EXPECT_NE(outcome.output.find("run.end_time = " + word + " is not a finite number"),
                  std::string::npos)
            << outcome.output;
    }
}

TEST(Overrides, LeaveTheNextWordASceneOrAProblem)
{
    const WorkFolder folder;
    const std::string output = " -o " + (folder / "out").string();
    for (const std::string command : {"bench error", "verify"}) {
        const Outcome outcome = run_program(command + output + " --set run.end_time=1 no_such_problem");
        EXPECT_NE(outcome.output.find("there is no problem 'no_such_problem'"), std::string::npos)
            << outcome.output;
    }
    for (const std::string command : {"run", "element"}) {
        const Outcome outcome = run_program(command + output + " --set a=1 --set b=2 no_such_file");
        EXPECT_EQ(outcome.code, 2);
        EXPECT_NE(outcome.output.find("no_such_file"), std::string::npos) << outcome.output;
        EXPECT_EQ(outcome.output.find("required"), std::string::npos) << outcome.output;
    }
}

TEST(Probe, TakesItsResultsFolderAfterItsOptions)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("probe -o " + (folder / "a.csv").string() +
                                        " --at 0.1,0.2 --fields ru " + folder.string());
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.output.find("Is this the results folder of a run?"), std::string::npos)
        << outcome.output;
}

} // namespace

} // namespace quicksand
