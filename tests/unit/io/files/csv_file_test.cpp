#include "io/files/csv_file.hpp"
#include "io/files/file_error.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {

using fixtures::TemporaryFolder;
using fixtures::text_of;

TEST(CsvFile, NumbersReadBackToTheSameBits)
{
    for (const double value : {0.1, 1.0 / 3.0, -6.02214076e23, 5e-324, 0.0})
        EXPECT_EQ(csv_value(csv_number(value)), value);
    EXPECT_EQ(csv_number(std::nan("")), "");
    EXPECT_TRUE(std::isnan(csv_value("")));
}

TEST(CsvFile, HasCommentsHeaderAndRows)
{
    const TemporaryFolder folder;
    CsvFile file = CsvFile::begin(folder / "probes/a.csv", {"Quicksand", "ru: ratio"}, {"time_s", "ru"});
    file.add_row({"0", ""});
    file.add_row({"0.5", "0.25"});
    file.flush();
    EXPECT_EQ(text_of(folder / "probes/a.csv"), "# Quicksand\n# ru: ratio\ntime_s,ru\n0,\n0.5,0.25\n");
}

TEST(CsvFile, RowsOfNumbersHaveTheirShortestTexts)
{
    const TemporaryFolder folder;
    CsvFile file = CsvFile::begin(folder / "a.csv", {}, {"time_s", "ru", "x_m"});
    const std::vector<double> numbers{0.1, std::nan(""), -6.02214076e23};
    file.add_numbers(numbers);
    file.flush();
    EXPECT_EQ(text_of(folder / "a.csv"), "time_s,ru,x_m\n0.1,," + csv_number(numbers.back()) + "\n");
}

TEST(CsvFile, ResumeDropsLaterAndTornRows)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "a.csv") << "# old\ntime_s,x_m\n0,1\n0.1,2\n0.1,3\n0.2,4\n0.0";
    CsvFile file = CsvFile::resume(folder / "a.csv", {"new"}, {"time_s", "x_m"}, 0.15);
    EXPECT_EQ(text_of(folder / "a.csv"), "# old\ntime_s,x_m\n0,1\n0.1,2\n0.1,3\n");
    EXPECT_EQ(file.last_time(), 0.1);
    ASSERT_EQ(file.last_rows().size(), 2u);
    EXPECT_EQ(file.value(file.last_rows()[1], "x_m"), 3.0);
    EXPECT_EQ(file.value(*file.first_row(), "x_m"), 1.0);
    file.add_row({"0.2", "5"});
    file.flush();
    EXPECT_EQ(text_of(folder / "a.csv"), "# old\ntime_s,x_m\n0,1\n0.1,2\n0.1,3\n0.2,5\n");
}

TEST(CsvFile, ResumeBeginsAMissingFile)
{
    const TemporaryFolder folder;
    const CsvFile file = CsvFile::resume(folder / "a.csv", {}, {"time_s"}, 1.0);
    EXPECT_EQ(text_of(folder / "a.csv"), "time_s\n");
    EXPECT_FALSE(file.last_time());
}

TEST(CsvFile, ResumeRefusesOtherColumns)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "a.csv") << "time_s,x_m\n0,1\n";
    try {
        CsvFile::resume(folder / "a.csv", {}, {"time_s", "y_m"}, 1.0);
        FAIL() << "no error";
    } catch (const FileError& error) {
        EXPECT_EQ(std::string(error.what()), (folder / "a.csv").string() +
                                                 ": cannot go on with the file: its columns are not those of "
                                                 "this run; use --overwrite to begin anew");
    }
}

TEST(CsvFile, AFullDiskIsAFileErrorThatNamesTheFile)
{
    const TemporaryFolder folder;
    CsvFile file = CsvFile::begin(folder / "a.csv", {}, {"time_s"});
    const fixtures::FullDisk full(64);
    for (int k = 0; k < 100; ++k) file.add_row({"0.123456789"});
    try {
        file.flush();
        FAIL() << "no error";
    } catch (const FileError& error) {
        EXPECT_EQ(error.path, folder / "a.csv");
        EXPECT_NE(std::string(error.what()).find("File too large; the rows before are complete"),
                  std::string::npos)
            << error.what();
    }
}

TEST(CsvFile, ADeviceThatTakesNothingIsAFileError)
{
    const TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/full", folder / "a.csv.tmp");
    EXPECT_THROW(CsvFile::begin(folder / "a.csv", {}, {"time_s"}), FileError);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
}

TEST(CsvFile, AFolderThatCannotBeMadeIsNamed)
{
    try {
        CsvFile::begin("/proc/quicksand/a.csv", {}, {"time_s"});
        FAIL() << "no error";
    } catch (const FileError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "/proc/quicksand: cannot create the folder: No such file or directory");
    }
}

} // namespace quicksand
