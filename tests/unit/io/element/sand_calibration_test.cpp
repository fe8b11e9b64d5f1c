// Fits of a sand's keys to points of cyclic strength: a key that made the points is found again.
#include "io/element/sand_calibration.hpp"
#include "tests/fixtures/element_example.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

using fixtures::ElementFolder;
using fixtures::sound_tests;

std::string refusal_of(const ElementFolder& folder, const std::string& points)
{
    folder.write("points.csv", points);
    try {
        read_observations(folder.folder().path() / "points.csv");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(SandCalibration, ReadsPointsByTheNamesOfTheirColumns)
{
    const ElementFolder folder;
    folder.write("points.csv",
                 "# a comment\nN, CSR, alpha, criterion\n12,0.15,0.1,strain_3_percent\n 8 , 0.2,,\n");
    const auto points = read_observations(folder.folder().path() / "points.csv");
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].cycles, 12.0);
    EXPECT_EQ(points[0].csr, 0.15);
    EXPECT_EQ(points[0].static_shear_ratio, 0.1);
    EXPECT_EQ(points[0].criterion, LiquefactionCriterion::strain_3_percent);
    EXPECT_EQ(points[0].vertical_stress, 100e3);
    EXPECT_EQ(points[1].static_shear_ratio, 0.0);
    EXPECT_EQ(points[1].criterion, LiquefactionCriterion::ru_95);
}

TEST(SandCalibration, TakesWhatThePointsDoNotTellFromTheFirstTest)
{
    const ElementFolder folder;
    folder.write("points.csv", "CSR,N,k0\n0.15,12,\n0.2,8,0.7\n");
    folder.read(sound_tests); // writes the file of the tests
    const std::vector<std::string> changes = {"tests.strength.vertical_stress=83e3", "tests.strength.k0=0.6",
                                              "tests.strength.criterion=strain_3_percent"};
    const auto points =
        read_observations(folder.folder().path() / "points.csv",
                          conditions_of_first_test(folder.folder().path() / "test.toml", changes));
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].vertical_stress, 83e3);
    EXPECT_EQ(points[0].k0, 0.6);
    EXPECT_EQ(points[1].k0, 0.7);
    EXPECT_EQ(points[1].criterion, LiquefactionCriterion::strain_3_percent);
}

TEST(SandCalibration, PointsThatAreNoneAreRefused)
{
    const ElementFolder folder;
    EXPECT_NE(refusal_of(folder, "CSR,N\n").find("it holds no points\nallowed: one line of column names"),
              std::string::npos);
    EXPECT_NE(refusal_of(folder, "CSR,N\n0.2,ten\n").find("'ten' is no number"), std::string::npos);
    EXPECT_NE(refusal_of(folder, "CSR,n\n0.2,10\n").find("it has no column N"), std::string::npos);
    EXPECT_NE(refusal_of(folder, "CSR,N\n0.2,0\n").find("CSR, N, k0 and sigma_v must be positive"),
              std::string::npos);
    EXPECT_NE(refusal_of(folder, "CSR,N,criterion\n0.2,10,ru\n").find("criterion ru is none of ru_95"),
              std::string::npos);
    EXPECT_NE(refusal_of(folder, "CSR,N\n15,10\n").find("a CSR of 15 is no ratio of stresses, as 0.15"),
              std::string::npos);
    EXPECT_THROW(read_observations(folder.folder().path() / "none.csv"), InputError);
}

TEST(SandCalibration, FindsTheKeyThatMadeThePoints)
{
    const ElementFolder folder;
    const double made_with = 0.4;
    const SkeletonLaw law =
        folder.read(sound_tests, {"materials.sand.secondary_factor=0.4"}).programme.tests.front().soil.law;
    std::vector<StrengthObservation> points(2);
    points[0].csr = 0.2, points[1].csr = 0.25;
    for (StrengthObservation& point : points) {
        point.cycles = 20.0; // how long the test may last
        point.cycles = cycles_of(law, point);
        ASSERT_LT(point.cycles, 20.0);
    }
    folder.read(sound_tests);
    const SandCalibration fit =
        calibrate_sand(folder.folder().path() / "test.toml", {}, {"secondary_factor"}, points);
    EXPECT_NEAR(fit.keys.front().value / made_with, 1.0, 0.03);
    EXPECT_LT(fit.error_after, 0.05);
    EXPECT_GT(fit.error_before, 0.2);
    EXPECT_EQ(fit.keys.front().path, "materials.sand.secondary_factor");
    EXPECT_EQ(fit.keys.front().start, 0.6);
}

TEST(SandCalibration, ATestThatDoesNotReachTheCriterionLastsTheLongerTheFartherItIsFromIt)
{
    const ElementFolder folder;
    const SkeletonLaw law = folder.read(sound_tests).programme.tests.front().soil.law;
    StrengthObservation near, far;
    near.cycles = far.cycles = 3.0;
    near.csr = 0.12, far.csr = 0.06;
    EXPECT_GT(cycles_of(law, near), longest_test(near));
    EXPECT_GT(cycles_of(law, far), cycles_of(law, near));
}

TEST(SandCalibration, AKeyWithoutANumberIsRefused)
{
    const ElementFolder folder;
    folder.read(sound_tests);
    const auto fit = [&](const std::string& key) {
        return calibrate_sand(folder.folder().path() / "test.toml", {}, {key},
                              {{.csr = 0.2, .cycles = 10.0}});
    };
    EXPECT_THROW(fit("law"), InputError);
    EXPECT_THROW(fit("confining_exponent"), InputError) << "it is zero in the published law";
    try {
        fit("secondary_grwth");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "calibrate: materials.sand.secondary_grwth is no key of a sand\n"
                                   "hint: did you mean secondary_growth?");
    }
}

} // namespace
} // namespace quicksand
