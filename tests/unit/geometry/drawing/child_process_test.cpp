#include "geometry/drawing/child_process.hpp"
#include "solver/base/failure.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace quicksand {
namespace {

TEST(ChildProcess, ReturnsTheExitCode)
{
    const ChildResult result = run_program("/bin/sh", {"-c", "exit 7"}, 10.0);
    EXPECT_EQ(result.end, ChildEnd::exited);
    EXPECT_EQ(result.code, 7);
}

TEST(ChildProcess, TellsACrashFromAnExit)
{
    const ChildResult result = run_program("/bin/sh", {"-c", "kill -ABRT $$"}, 10.0);
    EXPECT_EQ(result.end, ChildEnd::signalled);
    EXPECT_EQ(result.code, SIGABRT);
}

TEST(ChildProcess, StopsAtTheTimeLimit)
{
    EXPECT_EQ(run_program("/bin/sleep", {"60"}, 0.05).end, ChildEnd::out_of_time);
}

TEST(ChildProcess, SaysWhenAProgramCannotBeStarted)
{
    try {
        run_program("/nowhere/program", {}, 1.0);
        FAIL();
    } catch (const FileError& error) {
        EXPECT_EQ(error.path, "/nowhere/program");
        EXPECT_STREQ(error.what(), "/nowhere/program: cannot be started: No such file or directory\n"
                                   "hint: is Quicksand installed completely?");
    }
}

} // namespace
} // namespace quicksand
