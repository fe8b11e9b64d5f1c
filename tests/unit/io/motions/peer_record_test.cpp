// Records in PEER's AT2 form: every form of header that databases and their copies hold.
#include "io/motions/peer_record.hpp"
#include "solver/base/conventions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace quicksand {
namespace {

constexpr const char* title = "PEER STRONG MOTION DATABASE RECORD. PROCESSING BY PACIFIC ENGINEERING.\n"
                              "SOMEWHERE 1/2/34, A STATION, 180\n";
constexpr const char* in_g = "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.2 Hz LP=15.0 Hz\n";
constexpr const char* five = "  -.6403182E-02   .5E-03   .7743260E-02   1.0E+00  -0.25\n";

struct RecordForm {
    std::string name;
    std::string text;
    double interval; // [s]
    double unit;     // [m/s2]
};

void PrintTo(const RecordForm& form, std::ostream* stream)
{
    *stream << form.name;
}

class RecordForms : public testing::TestWithParam<RecordForm> {};

TEST_P(RecordForms, HoldTheSameValues)
{
    Diagnostics findings;
    const auto record = parse_peer_record("record.AT2", GetParam().text, findings);
    ASSERT_TRUE(record) << findings.render("");
    EXPECT_TRUE(findings.empty());
    EXPECT_DOUBLE_EQ(record->interval, GetParam().interval);
    ASSERT_EQ(record->accelerations.size(), 5U);
    constexpr std::array expected{-0.6403182e-2, 0.5e-3, 0.774326e-2, 1.0, -0.25};
    for (std::size_t k = 0; k < 5; ++k)
        EXPECT_DOUBLE_EQ(record->accelerations[k], GetParam().unit * expected[k]) << k;
}

std::string with_ends(std::string text, const std::string& end)
{
    for (auto at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + end.size()))
        text.replace(at, 1, end);
    return text;
}

const std::string usual = std::string(title) + in_g + "NPTS=     5, DT= .01000 SEC\n" + five;
const std::string padded = "PACIFIC ENGINEERING AND ANALYSIS STRONG-MOTION DATA\nSOMEWHERE, 360       \n"
                           "ACCELERATION TIME HISTORY IN UNITS OF G          \nNPTS=  5, DT= .02000 SEC\n";
const std::string nga = "PEER NGA STRONG MOTION DATABASE RECORD\nSomewhere, Station, 67\n"
                        "ACCELERATION TIME SERIES IN UNITS OF G\n";

INSTANTIATE_TEST_SUITE_P(
    All, RecordForms,
    testing::Values(
        RecordForm{"Usual", usual, 0.01, standard_gravity},
        RecordForm{"PaddedWithBlanks", padded + five, 0.02, standard_gravity},
        RecordForm{"DoubleCarriageReturn", with_ends(padded + five, "\r\r\n"), 0.02, standard_gravity},
        RecordForm{"CarriageReturnAndNoLastEnd", with_ends(usual.substr(0, usual.size() - 1), "\r\n"), 0.01,
                   standard_gravity},
        RecordForm{"LowerCaseWithoutSeconds", std::string(title) + in_g + "NPTS=   5, dt=  .02000\n" + five,
                   0.02, standard_gravity},
        RecordForm{"NumbersFirst", nga + "5    0.0100    NPTS, DT\n" + five, 0.01, standard_gravity},
        RecordForm{"TrailingComma",
                   nga + "NPTS=   5, DT=   .0050 SEC,                   \n" + five + "    \n", 0.005,
                   standard_gravity},
        RecordForm{
            "OneValueALine",
            "PEER NGA STRONG MOTION DATABASE RECORD \nParkfield, 50 \nACCELERATION TIME SERIES IN UNITS "
            "OF G \nNPTS=  5, DT= .0100\n-6.403182e-03\n5.0e-04\n\n7.743260e-03\n+1.0\n-0.25\n",
            0.01, standard_gravity},
        RecordForm{"UnequalIntervalDigits", nga + "NPTS=  5, DT= .00244 SEC\n" + five, 0.00244,
                   standard_gravity},
        RecordForm{"Centimetres",
                   with_ends(nga, "\n").replace(nga.rfind("G\n"), 1, "CM/S/S") + "NPTS=  5, DT= .01 SEC\n" +
                       five,
                   0.01, 0.01}),
    [](const auto& test) { return test.param.name; });

TEST(PeerRecord, IsToldByItsHeaderOrItsName)
{
    EXPECT_TRUE(is_peer_record("motion.txt", usual));
    EXPECT_TRUE(is_peer_record("motion.at2", "0 1\n"));
    EXPECT_TRUE(is_peer_record("motion.AT2", ""));
    EXPECT_FALSE(is_peer_record("motion.csv", "time_s,acceleration_m_s2\n0,1\n0.01,2\n"));
}

} // namespace
} // namespace quicksand
