// Records and what is written of motions, read back.
#include "io/motions/motion_csv.hpp"
#include "io/motions/motion_record.hpp"
#include "io/motions/record_unit.hpp"
#include "io/pictures/picture_table.hpp"
#include "solver/problem/motion_processing.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

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
    const auto unstated = read_motion_record(file, {file}, {"", "--unit", "", {}}, findings);
    ASSERT_TRUE(unstated) << findings.render("");
    EXPECT_EQ(unstated->motion.accelerations, written_record.accelerations);
}

namespace {

/// What a record of two columns says with a unit that the user states, in m/s2; what is wrong, otherwise.
struct Reading {
    std::vector<double> accelerations;
    std::string findings;
};

Reading read_columns_of(const std::string& text, const std::string& unit)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "record.csv") << text;
    Diagnostics findings;
    const auto record =
        read_motion_record(folder / "record.csv", {"scene"}, {unit, "motion.unit", "", {"scene"}}, findings);
    return {record ? record->motion.accelerations : std::vector<double>(), findings.render("")};
}

} // namespace

TEST(MotionRecord, TakesTheUnitOfTheHeader)
{
    const std::string rows = "\n0,0\n0.01,2\n";
    for (const std::string header : {"time (s),acceleration (m/s2)", "t;a [m/s^2]",
                                     "time_s,acceleration_m_s2", "t, a [m/s\u00b2]", "Time M/S/S"})
        EXPECT_EQ(read_columns_of(header + rows, "").accelerations, (std::vector{0.0, 2.0})) << header;
    for (const std::string header : {"t,acc_cm_s2", "t,a (gal)", "t,acc_gal", "t,a (cm/s2)"})
        EXPECT_EQ(read_columns_of(header + rows, "").accelerations, (std::vector{0.0, 0.02})) << header;
    EXPECT_EQ(read_columns_of("Time [s];Acceleration [g]" + rows, "g").accelerations,
              (std::vector{0.0, 2.0 * standard_gravity}));
    for (const std::string header : {"t,a_g", "t,a", "time_s,acceleration"}) {
        EXPECT_EQ(read_columns_of(header + rows, "m/s2").accelerations, (std::vector{0.0, 2.0})) << header;
        EXPECT_NE(read_columns_of(header + rows, "").findings.find("does not state the unit"),
                  std::string::npos)
            << header;
    }
}

TEST(MotionRecord, TakesTheUnitOfNamesInAComment)
{
    const std::string rows = "\n# of the year 1989\n0,0\n0.01,2\n";
    for (const std::string header : {"# time (s), a (gal)", "#t;acc_cm_s2", "# Time[s] a[gal]"})
        EXPECT_EQ(read_columns_of(header + rows, "").accelerations, (std::vector{0.0, 0.02})) << header;
    EXPECT_NE(read_columns_of("# time,velocity" + rows, "m/s2").findings.find("says velocity"),
              std::string::npos);
    EXPECT_NE(read_columns_of("# t_ms,a_g" + rows, "g").findings.find("its times are in ms"),
              std::string::npos);
    for (const std::string comment :
         {"# Kobe, 1995, velocity", "# from the velocity", "#", "# time",
          "# Northridge 1994, velocity removed", "# Kobe, 1995 (M)", "# time series of velocity",
          "# Baseline corrected; velocity ends at zero"})
        EXPECT_EQ(read_columns_of(comment + rows, "m/s2").accelerations, (std::vector{0.0, 2.0})) << comment;
    for (const std::string names :
         {"# time,velocity\n# filtered 0.1 Hz, 25 Hz", "# time,velocity,", "# time velocity",
          "# time,velocity integrated from acceleration", "time,displacement from accelerogram",
          "time,velocity (according to the station)"})
        EXPECT_NE(read_columns_of(names + rows, "m/s2").findings.find("says "), std::string::npos) << names;
    EXPECT_EQ(read_columns_of("# time [s],acc [cm/s2]\n# filtered 0.1 Hz, 25 Hz" + rows, "").accelerations,
              (std::vector{0.0, 0.02}));
    EXPECT_EQ(read_columns_of("# t, velocity\nt, a" + rows, "m/s2").accelerations, (std::vector{0.0, 2.0}));
}

TEST(MotionRecord, RefusesAUnitThatTheHeaderContradicts)
{
    const Reading reading = read_columns_of("Time [s];Acceleration [g]\n0;0\n0.01;1\n", "m/s2");
    EXPECT_TRUE(reading.accelerations.empty());
    EXPECT_NE(reading.findings.find("record.csv' says g"), std::string::npos) << reading.findings;
    EXPECT_NE(reading.findings.find("hint: leave motion.unit out"), std::string::npos) << reading.findings;
}

TEST(MotionRecord, RefusesTimesThatAreNotInSeconds)
{
    const std::string rows = "\n0,0\n0.01,1\n";
    for (const auto& [header, unit] : std::vector<std::pair<std::string, std::string>>{
             {"time [ms],a (g)", "ms"}, {"Time (min);a [m/s2]", "min"}, {"t_ms,acc_m_s2", "ms"}})
        EXPECT_NE(read_columns_of(header + rows, "").findings.find("says that its times are in " + unit),
                  std::string::npos)
            << header;
    for (const std::string header :
         {"time [s],a [m/s2]", "time_s,a_m_s2", "Time (sec), a (m/s2)", "t,a [m/s2]"})
        EXPECT_EQ(read_columns_of(header + rows, "").accelerations.size(), 2u) << header;
}

TEST(ColumnUnits, AreThoseOfTheColumnAlone)
{
    for (const std::string header : {"t,f", "time [s],u [-]", "t, m", "t h", "t d", "time_s,load_factor",
                                     "time_s,factor of 10 kPa", ""}) {
        EXPECT_EQ(foreign_unit_of_time(header), "") << header;
        EXPECT_EQ(unit_of_values(header), "") << header;
    }
    EXPECT_EQ(foreign_unit_of_time("time (ms) a (g)"), "ms");
    EXPECT_EQ(foreign_unit_of_time("time_ms a_m_s2"), "ms");
    EXPECT_EQ(foreign_unit_of_time("Time [hours],f"), "hours");
    EXPECT_EQ(unit_of_values("t_s,v_m_s"), "m_s");
    EXPECT_EQ(unit_of_values("t_s;p [kN/m2]"), "kN/m2");
    EXPECT_EQ(unit_of_values("t,head (m)"), "m");
}

TEST(MotionRecord, BeginsWithItsFirstValueWhateverTheTime)
{
    for (const std::string rows :
         {"5,0\n5.01,1\n5.02,2\n", "0.01,0\n0.02,1\n0.03,2\n", "-2,0\n-1.99,1\n-1.98,2\n"})
        EXPECT_EQ(read_columns_of(rows, "m/s2").accelerations, (std::vector{0.0, 1.0, 2.0})) << rows;
}

namespace {

/// Rows at an interval, with times in a format; that of the number `left_out` is missing.
Reading read_written_times(const std::string& format, double interval, int rows = 200, int left_out = -1)
{
    std::string text;
    for (int k = 0; k < rows; ++k)
        if (k != left_out) text += fmt::format(fmt::runtime(format), k * interval) + ",1\n";
    return read_columns_of(text, "m/s2");
}

} // namespace

TEST(MotionRecord, ForgivesTheRoundingOfItsTimes)
{
    for (const std::string format : {"{:.3f}", "{:.6g}", "{:.5e}", "{}"})
        for (const double interval : {1.0 / 128.0, 1.0 / 150.0, 0.005})
            EXPECT_EQ(read_written_times(format, interval).accelerations.size(), 200u)
                << format << ' ' << interval;
    for (const std::string format : {"{:.4f}", "{:.6g}", "{:.5e}"}) // 150 s: fewer decimals from 100 s on
        EXPECT_EQ(read_written_times(format, 1.0 / 128.0, 19200).accelerations.size(), 19200u) << format;
}

TEST(MotionRecord, RefusesTimesWithAGap)
{
    for (const std::string format : {"{:.2f}", "{:.3f}", "{:.6g}"})
        for (const int row : {1, 2, 60, 100, 198})
            EXPECT_NE(read_written_times(format, 0.01, 200, row).findings.find("its time steps are between"),
                      std::string::npos)
                << format << ' ' << row;
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
