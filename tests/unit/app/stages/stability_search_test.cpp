// The factor of safety that a search has left in its folder.
#include "app/stages/stability_search.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace quicksand {
namespace {

using fixtures::TemporaryFolder;

/// That of a search with these rows.
std::optional<double> factor_of(const std::string& rows)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "stability.csv")
        << "# strength reduction\nfactor,displacement_m,out_of_balance,stands,steps\n"
        << rows;
    return read_factor_of_safety({folder.path()});
}

TEST(StabilitySearch, LeavesTheMiddleOfItsBracket)
{
    EXPECT_EQ(factor_of("1,0,0,1,50\n1.25,0.1,1e-3,0,800\n1.125,0.1,1e-3,1,800\n"), 1.1875);
    EXPECT_EQ(factor_of("1,0.1,1e-3,0,50\n0.8,0.1,1e-3,1,800\n0.9,0.1,1e-3,0,800\n"), 0.85);
    EXPECT_EQ(factor_of("1,0.1,1e-3,0,50\n0.59,0.1,1e-3,1,800\n0.592,0.1,1e-3,0,800\n"), 0.591);
}

TEST(StabilitySearch, CountsNoFailureBeforeTheBodyCameToRest)
{
    EXPECT_EQ(factor_of("1,0.1,1e-3,0,50\n1,0,0,1,800\n1.25,0.1,1e-3,0,800\n"), 1.125);
}

TEST(StabilitySearch, TellsABodyThatStandsAtNoStrengthOrAtAny)
{
    EXPECT_EQ(factor_of("1,0.1,1e-3,0,50\n0.8,0.1,1e-3,0,800\n"), 0.0);
    EXPECT_EQ(factor_of("1,0,0,1,50\n32,0,0,1,800\n"), 32.0);
    EXPECT_EQ(read_factor_of_safety({TemporaryFolder().path()}), std::nullopt);
}

} // namespace
} // namespace quicksand
