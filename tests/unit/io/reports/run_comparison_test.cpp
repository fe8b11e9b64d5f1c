#include "io/pictures/picture_table.hpp"
#include "io/reports/run_comparison.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

void write(const std::filesystem::path& file, const std::string& text)
{
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

/// Two runs, the second with other times, and a probe that only they have.
class Comparison : public testing::Test {
protected:
    void SetUp() override
    {
        write(folder / "a/history.csv", "# Quicksand\ntime_s,crest_settlement_m\n0,0\n1,-0.4\n2,0.3\n");
        write(folder / "b/history.csv", "time_s,crest_settlement_m,max_ru\n0,0,0\n0.5,0.1,1\n1.5,0.6,2\n");
        write(folder / "a/probes/P.csv", "time_s,ux_m\n0,0\n1,1\n");
        write(folder / "b/probes/P.csv", "time_s,ux_m\n0,0\n1,3\n");
        write(folder / "b/probes/line.csv", "time_s,distance_m,ux_m\n0,0,0\n0,1,0\n");
    }
    TemporaryFolder folder;
};

TEST_F(Comparison, TellsPeaksFinalValuesAndDifferences)
{
    const auto runs = read_compared_runs({folder / "a", folder / "b"});
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[1].name, "b");
    EXPECT_EQ(runs[1].tables.size(), 2U) << "profiles are left out";
    const auto values = compare_runs(runs);
    ASSERT_EQ(values.size(), 4U) << "max_ru has one run alone";
    EXPECT_EQ(values[0].column, "crest_settlement_m");
    EXPECT_EQ(values[0].peak, -0.4);
    EXPECT_EQ(values[0].peak_time, 1.0);
    EXPECT_EQ(values[0].final_value, 0.3);
    EXPECT_TRUE(std::isnan(values[0].peak_change));
    EXPECT_EQ(values[1].peak, 0.6);
    EXPECT_NEAR(values[1].peak_change, 0.2, 1e-15) << "in amount";
    EXPECT_NEAR(values[1].final_change, 0.3, 1e-15);
    // at 0 both are 0, at 1 the second has 0.35; it ends before 2
    EXPECT_NEAR(values[1].rms_difference, 0.75 / std::sqrt(2.0), 1e-15);
    EXPECT_EQ(values[3].final_change, 2.0);
}

TEST_F(Comparison, IsATable)
{
    const auto values = compare_runs(read_compared_runs({folder / "a", folder / "b"}));
    write_comparison(folder / "compare.csv", values, {"Quicksand"});
    const std::string text = fixtures::text_of(folder / "compare.csv");
    EXPECT_NE(text.find("table,quantity,run,peak,peak_time_s,final,peak_change,final_change,rms_difference\n"
                        "history,crest_settlement_m,\"a\",-0.4,1,0.3,,,\n"),
              std::string::npos)
        << text;
}

TEST_F(Comparison, DrawsOnePictureATable)
{
    const auto drawings = comparison_drawings(read_compared_runs({folder / "a", folder / "b"}), "out");
    ASSERT_EQ(drawings.size(), 2U);
    EXPECT_EQ(drawings[0].png, "out/history.png");
    EXPECT_EQ(drawings[1].png, "out/probe_P.png");
    EXPECT_NE(drawings[0].commands.find("title 'b'"), std::string::npos);
}

TEST_F(Comparison, OfOneRunIsItsSummary)
{
    EXPECT_EQ(compare_runs(read_compared_runs({folder / "b"})).size(), 3U);
}

TEST_F(Comparison, NamesFoldersOfOneNameWithTheirParents)
{
    write(folder / "x/a/history.csv", "time_s,max_ru\n0,1\n");
    const auto runs = read_compared_runs({folder / "a", folder / "x/a/"});
    EXPECT_EQ(runs[1].name, "x/a");
}

} // namespace

} // namespace quicksand
