// Records and what is written of motions, read back.
#include "io/motions/motion_csv.hpp"
#include "io/motions/motion_record.hpp"
#include "io/pictures/picture_table.hpp"
#include "solver/problem/motion_processing.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

const SampledMotion written_record{0.005, {0.0, 1.25, -2.0, 1.0 / 3.0}};

} // namespace

TEST(MotionCsv, IsARecordAgain)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "record.csv";
    write_record_csv(file, written_record, {"Quicksand", "a remark"});
    Diagnostics findings;
    const auto read = read_motion_record(file, {file}, {"m/s2", "--unit", "", {}}, findings);
    ASSERT_TRUE(read) << findings.render("");
    EXPECT_EQ(read->motion.interval, written_record.interval);
    EXPECT_EQ(read->motion.accelerations, written_record.accelerations) << "to the last bit";
    const auto in_g = read_motion_record(file, {file}, {"g", "--unit", "", {}}, findings);
    EXPECT_DOUBLE_EQ(in_g->motion.accelerations[1], 1.25 * standard_gravity);
}

TEST(MotionCsv, HasHistoriesAndSpectrumWithTheirUnits)
{
    const TemporaryFolder folder;
    write_histories_csv(folder / "histories.csv", written_record, {"Quicksand"});
    const PictureTable histories = read_picture_table(folder / "histories.csv");
    EXPECT_EQ(histories.columns,
              (std::vector<std::string>{"time_s", "acceleration_m_s2", "velocity_m_s", "displacement_m"}));
    EXPECT_EQ(*histories.find("time_s"), (std::vector{0.0, 0.005, 0.01, 0.015}));
    EXPECT_EQ(*histories.find("velocity_m_s"), histories_of(written_record).velocities);

    const auto spectrum = response_spectrum(written_record, {0.1, 1.0}, 0.05);
    write_spectrum_csv(folder / "spectrum.csv", spectrum, {});
    const PictureTable table = read_picture_table(folder / "spectrum.csv");
    EXPECT_EQ(*table.find("period_s"), (std::vector{0.1, 1.0}));
    EXPECT_EQ((*table.find("pseudo_acceleration_m_s2"))[1], spectrum[1].pseudo_acceleration());
    EXPECT_EQ((*table.find("displacement_m"))[0], spectrum[0].displacement);
}

} // namespace quicksand
