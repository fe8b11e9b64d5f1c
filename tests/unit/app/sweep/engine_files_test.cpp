#include "app/sweep/engine_files.hpp"

#include <gtest/gtest.h>

namespace quicksand {

TEST(ShellLine, QuotesWhatAShellWouldChange)
{
    EXPECT_EQ(shell_line({"run", "a/b.toml", "--set", "x=[1,2]"}), "run a/b.toml --set 'x=[1,2]'");
    EXPECT_EQ(shell_line({"--set", "motion.amplitude=\"0.2 g\""}), "--set 'motion.amplitude=\"0.2 g\"'");
    EXPECT_EQ(shell_line({"it's", "$HOME", "", "a;b", "*"}), "'it'\\''s' '$HOME' '' 'a;b' '*'");
}

} // namespace quicksand
