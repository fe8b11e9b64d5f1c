// Drawings start no programs, whatever their text hides from the reading of it.
#include "geometry/drawing/execution_guard.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/scratch_files.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

namespace quicksand {
namespace {

TEST(ExecutionGuard, LetsNoProgramStart)
{
    const pid_t child = fork();
    if (child == 0) {
        forbid_other_programs();
        execl("/bin/true", "true", static_cast<char*>(nullptr));
        _exit(errno == EPERM ? 7 : 8);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(ExecutionGuard, HoldsForADrawingThatHidesItsWish)
{
    // gmsh takes the EndIf inside the string for that of If(0), and runs what follows
    const ScratchFolder folder;
    const std::filesystem::path mark = folder.path() / "mark";
    const std::string text = "If(0)\n a=\" EndIf\nSystemCall 'touch " + mark.string() + "'; b=\" \";\n";
    EXPECT_THROW(read_geo(text), InputError);
    EXPECT_FALSE(std::filesystem::exists(mark));
}

} // namespace
} // namespace quicksand
