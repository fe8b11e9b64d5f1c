// Records of base motions with mistakes in the file itself, or at odds with the scene.
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

struct RecordMistake {
    std::string name;
    std::string record; // the file record.AT2
    std::string unit;   // what the scene says of it
    std::string message;
};

void PrintTo(const RecordMistake& mistake, std::ostream* stream)
{
    *stream << mistake.name;
}

class SceneRecords : public testing::TestWithParam<RecordMistake> {};

TEST_P(SceneRecords, AreReportedWithPlaceAndCure)
{
    const fixtures::SceneFolder folder;
    folder.write("record.AT2", GetParam().record);
    const std::string text =
        fixtures::replaced(fixtures::column_scene, "kind = \"sine\"\namplitude = \"24 g\"\nfrequency = 180",
                           "kind = \"file\"\nfile = \"record.AT2\"\n" + GetParam().unit);
    EXPECT_EQ(folder.message(text), GetParam().message.substr(1));
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Mistakes, SceneRecords, testing::Values(
RecordMistake{"NoCount",
    "0.0 0.1\n0.01 0.2\n",
    "",
R"_(
record.AT2:1:1: error[record]: the header has no line with the number of values and their interval
    1 | 0.0 0.1
      | ^
expected: `NPTS=  4000, DT= .01000 SEC` or `4096  0.0100  NPTS, DT`
hint: or give the record as two columns: time in s, acceleration
)_"},
RecordMistake{"CountIsNoNumber",
    "UNITS OF G\nNPTS= many, DT= .01 SEC\n.1 .2\n",
    "",
R"_(
record.AT2:2:7: error[record]: the number of values is no whole number of 2 or more
    2 | NPTS= many, DT= .01 SEC
      |       ^~~~
expected: `NPTS=  4000, DT= .01000 SEC` or `4096  0.0100  NPTS, DT`
)_"},
RecordMistake{"NoInterval",
    "UNITS OF G\nNPTS= 2, DT= 0 SEC\n.1 .2\n",
    "",
R"_(
record.AT2:2:14: error[record]: the interval is no number of seconds above 0
    2 | NPTS= 2, DT= 0 SEC
      |              ^
expected: `NPTS=  4000, DT= .01000 SEC` or `4096  0.0100  NPTS, DT`
)_"},
RecordMistake{"NoUnit",
    "SOME RECORD\nNPTS= 2, DT= .01 SEC\n.1 .2\n",
    "",
R"_(
record.AT2:2:1: error[record]: no line above states the unit of the values
    2 | NPTS= 2, DT= .01 SEC
      | ^
expected: a line with UNITS OF G, of CM/S/S or of M/S/S
hint: or give the record as two columns and its unit as motion.unit
)_"},
RecordMistake{"UnknownUnit",
    "ACCELERATION IN UNITS OF FT/S/S\nNPTS= 2, DT= .01 SEC\n.1 .2\n",
    "",
R"_(
record.AT2:1:26: error[record]: the unit 'FT/S/S' is not known
    1 | ACCELERATION IN UNITS OF FT/S/S
      |                          ^~~~~~
expected: UNITS OF G, of CM/S/S or of M/S/S
)_"},
RecordMistake{"RecordOfVelocities",
    "VELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 2, DT= .01 SEC\n.1 .2\n",
    "",
R"_(
record.AT2:1:1: error[record]: this is no record of accelerations
    1 | VELOCITY TIME SERIES IN UNITS OF CM/S
      | ^~~~~~~~
expected: ACCELERATION TIME SERIES IN UNITS OF G
hint: take the file that ends with .AT2
)_"},
RecordMistake{"ValueIsNoNumber",
    "UNITS OF G\nNPTS= 3, DT= .01 SEC\n  .1 .2\n  .3O\n",
    "",
R"_(
record.AT2:4:3: error[record]: '.3O' is no number
    4 |   .3O
      |   ^~~
expected: the values only, separated by blanks
)_"},
RecordMistake{"CommaAmongValues",
    "UNITS OF G\nNPTS= 3, DT= .01 SEC\n.1,.2,.3\n",
    "",
R"_(
record.AT2:3:3: error[record]: a comma among the values
    3 | .1,.2,.3
      |   ^
expected: the values only, separated by blanks
)_"},
RecordMistake{"CutOff",
    "UNITS OF G\nNPTS= 4, DT= .01 SEC\n.1 .2 .3\n",
    "",
R"_(
record.AT2:2:7: error[record]: the header says 4 values, the file holds 3
    2 | NPTS= 4, DT= .01 SEC
      |       ^
hint: is the file complete?
)_"},
RecordMistake{"TooMany",
    "UNITS OF G\n2 .01 NPTS, DT\n.1 .2 .3\n",
    "",
R"_(
record.AT2:2:1: error[record]: the header says 2 values, the file holds 3
    2 | 2 .01 NPTS, DT
      | ^
hint: is more than one record in the file?
)_"},
RecordMistake{"IntervalOfMinutes",
    "UNITS OF G\nNPTS= 2, DT= 500 SEC\n.1 .2\n",
    "",
R"_(
record.AT2:2:14: error[record]: an interval of 500 s is not that of an earthquake's record
    2 | NPTS= 2, DT= 500 SEC
      |              ^~~
expected: at most 10 s
)_"},
RecordMistake{"NoEarthquake",
    "UNITS OF G\nNPTS= 3, DT= .01 SEC\n.1\n.2 -1e90\n",
    "",
R"_(
record.AT2:4:4: error[record]: no earthquake has an acceleration of -1e90 G
    4 | .2 -1e90
      |    ^~~~~
expected: at most 1000 g in amount
)_"},
RecordMistake{"UnitAtOdds",
    "UNITS OF G\nNPTS= 2, DT= .01 SEC\n.1 .2\n",
    "unit = \"m/s2\"",
R"_(
scene.toml:47:8: error[motion]: the header of 'record.AT2' says G
   47 | unit = "m/s2"
      |        ^~~~~~
hint: leave motion.unit out
)_"}), [](const auto& test) { return test.param.name; });
// clang-format on

TEST(SceneRecords, TwoColumnsNeedTheirUnit)
{
    const fixtures::SceneFolder folder;
    folder.write("record.csv", "0 0.1\n0.01 0.2\n");
    const std::string text =
        fixtures::replaced(fixtures::column_scene, "kind = \"sine\"\namplitude = \"24 g\"\nfrequency = 180",
                           "kind = \"file\"\nfile = \"record.csv\"");
    EXPECT_EQ(
        folder.message(text),
        R"_(scene.toml:46:8: error[missing-key]: 'record.csv' does not state the unit of its accelerations
   46 | file = "record.csv"
      |        ^~~~~~~~~~~~
expected: motion.unit = "g" or "m/s2"
)_");
}

TEST(SceneRecords, TwoColumnsOfAnUnknownUnitAreRefusedWhateverTheSceneSays)
{
    const std::string text =
        fixtures::replaced(fixtures::column_scene, "kind = \"sine\"\namplitude = \"24 g\"\nfrequency = 180",
                           "kind = \"file\"\nfile = \"record.csv\"\nunit = \"m/s2\"");
    for (const auto& [column, said] :
         {std::pair("a [ft/s2]", "ft/s2"), std::pair("a [m/s]", "m/s"), std::pair("a [%g]", "%g"),
          std::pair("a [mg]", "mg"), std::pair("velocity_m_s", "velocity_m_s"),
          std::pair("Velocity", "Velocity"), std::pair("ground_velocity", "ground_velocity"),
          std::pair("v_m_s", "v_m_s"), std::pair(" disp_cm", "disp_cm"),
          std::pair("displacement [m]", "displacement [m]")}) {
        const fixtures::SceneFolder folder;
        folder.write("record.csv", "time [s]," + std::string(column) + "\n0,0.1\n0.01,0.2\n");
        EXPECT_EQ(folder.message(text), "scene.toml:46:8: error[motion]: the header of 'record.csv' says " +
                                            std::string(said) +
                                            R"_(, which is no acceleration in a unit that is known
   46 | file = "record.csv"
      |        ^~~~~~~~~~~~
expected: g, m/s2, cm/s2 or Gal
hint: convert the numbers, or name the column as acc [m/s2]
)_");
    }
    for (const std::string sound :
         {"a (E-W)", "acc (N/S)", "acc (17/10/1989)", "acc (5% damped)", "a (m/s**2)", "a (m/sec/sec)",
          "a (m/s^{2})", "a [m/(s^2)]", "acc [m/s2] (N/S)", "a", "acc_disp_corrected", "a,"}) {
        const fixtures::SceneFolder folder;
        folder.write("record.csv", "time (s)," + sound + "\n0,0.1\n0.01,0.2\n");
        EXPECT_EQ(folder.message(text).find("error"), std::string::npos) << folder.message(text);
    }
    const auto message_of = [&](const std::string& header) {
        const fixtures::SceneFolder folder;
        folder.write("record.csv", header + "\n0 0.1\n0.01 0.2\n");
        return folder.message(text);
    };
    EXPECT_NE(message_of("time_s velocity_m_s").find("says velocity_m_s, which"), std::string::npos);
    EXPECT_NE(message_of("t\tdisp").find("says disp, which"), std::string::npos);
    EXPECT_NE(message_of("VELOCITY TIME SERIES IN UNITS OF CM/S").find("says CM/S, which"),
              std::string::npos);
    EXPECT_NE(message_of("time_s, v [m/s], ").find("says m/s, which"), std::string::npos);
    EXPECT_EQ(message_of("Velestino station, 1980 N-S").find("error"), std::string::npos); // a title
}

std::string of_columns()
{
    return fixtures::replaced(fixtures::column_scene,
                              "kind = \"sine\"\namplitude = \"24 g\"\nfrequency = 180",
                              "kind = \"file\"\nfile = \"record.csv\"\nunit = \"g\"");
}

TEST(SceneRecords, OfTwoColumnsAreRefusedWhereTheyAreNoEarthquake)
{
    const fixtures::SceneFolder folder;
    folder.write("record.csv", "time,a\n0,0.1\n0.01,1e90\n");
    EXPECT_EQ(folder.message(of_columns()),
              R"_(record.csv:3:1: error[record]: no earthquake has an acceleration of 1e90 g
    3 | 0.01,1e90
      | ^
expected: at most 1000 g in amount
)_");
    folder.write("record.csv", "0,0.1\n500,0.2\n1000,0.1\n");
    EXPECT_EQ(folder.message(of_columns()),
              R"_(record.csv:2:1: error[record]: an interval of 500 s is not that of an earthquake's record
    2 | 500,0.2
      | ^
expected: at most 10 s
)_");
    folder.write("record.csv", "0,0.1\n0.01,inf\n");
    EXPECT_NE(folder.message(of_columns()).find("line 2 is not two numbers: 0.01,inf"), std::string::npos);
}

TEST(SceneRecords, ThatAreUnusualAreWarnedOf)
{
    const fixtures::SceneFolder folder;
    const auto warning = [&](const std::string& gravity) {
        const SceneReading reading = folder.read(fixtures::replaced(of_columns(), "\"120 g\"", gravity));
        return reading.warnings.render("");
    };
    folder.write("record.csv", "0,0.1\n0.2,-2.5\n0.4,0.1\n");
    const std::string at_1_g = warning("\"1 g\"");
    EXPECT_NE(at_1_g.find("warning[plausibility]: the record's peak of 2.5 g is unusually large\n"
                          "expected: usually at most 2 g\n"),
              std::string::npos)
        << at_1_g;
    EXPECT_NE(at_1_g.find("warning[plausibility]: the record's interval of 0.2 s is unusually long\n"
                          "expected: usually at most 0.1 s\n"),
              std::string::npos)
        << at_1_g;
    folder.write("record.csv", "0,0.1\n5e-4,-25\n1e-3,0.1\n");
    EXPECT_EQ(warning("\"120 g\"").find("the record's"), std::string::npos) << "of a centrifuge model";
}

TEST(SceneRecords, WhoseHeaderCannotBeRightAreWarnedOfWithTheirPeak)
{
    const fixtures::SceneFolder folder;
    folder.write("record.AT2", "UNITS OF G\nNPTS= 3, DT= .01 SEC\n12.5 -187.2 40\n");
    const std::string scene =
        fixtures::replaced(fixtures::column_scene, "kind = \"sine\"\namplitude = \"24 g\"\nfrequency = 180",
                           "kind = \"file\"\nfile = \"record.AT2\"");
    const std::string text =
        folder.read(fixtures::replaced(scene, "\"120 g\"", "\"1 g\"")).warnings.render("");
    EXPECT_NE(text.find("warning[plausibility]: the record's peak of 187.2 g is unusually large\n"
                        "expected: usually at most 2 g\n"
                        "hint: the header says UNITS OF G: are the values in another unit, as cm/s2?\n"),
              std::string::npos)
        << text;
}

TEST(SceneRecords, AreTakenWithTheirUnitScaleAndBaseline)
{
    const fixtures::SceneFolder folder;
    folder.write("record.AT2", "UNITS OF G\nNPTS= 4, DT= .01 SEC\n.1 .2 .3 .4\n");
    const auto read = [&](const std::string& more) {
        const SceneReading reading = folder.read(fixtures::replaced(
            fixtures::column_scene, "kind = \"sine\"\namplitude = \"24 g\"\nfrequency = 180",
            "kind = \"file\"\nfile = \"record.AT2\"\n" + more));
        return std::get<SampledMotion>(reading.scene.base_motion);
    };
    EXPECT_DOUBLE_EQ(read("").interval, 0.01);
    EXPECT_DOUBLE_EQ(read("unit = \"g\"").accelerations[3], 0.4 * standard_gravity);
    EXPECT_DOUBLE_EQ(read("scale = -2.0").accelerations[3], -0.8 * standard_gravity);
    for (const double acceleration : read("baseline = \"linear\"").accelerations)
        EXPECT_NEAR(acceleration, 0.0, 1e-15);
}

} // namespace
} // namespace quicksand
