// The example of the element laboratory: its curve and the page of its keys; its numbers: tests/regression.
#include "io/pictures/picture_table.hpp"
#include "tests/examples/program.hpp"
#include "tests/fixtures/checkout.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace quicksand {

namespace {

using namespace testing_program;

/// CRR of Idriss and Boulanger (2008) for 15 cycles at one atmosphere, C_0 = 2.8.
double triggering_curve(double N)
{
    return std::exp(N / 14.1 + std::pow(N / 126.0, 2) - std::pow(N / 23.6, 3) + std::pow(N / 25.4, 4) - 2.8);
}

TEST(ElementExample, OverlaysTheTriggeringCurveItself)
{
    const PictureTable points = read_picture_table(example("element_dss") + "/triggering_curve.csv");
    for (std::size_t k = 0; k < points.find("CSR")->size(); ++k) {
        EXPECT_NEAR((*points.find("CSR"))[k], triggering_curve((*points.find("n1_60"))[k]), 1e-4);
        EXPECT_EQ((*points.find("N"))[k], 15.0);
    }
    const PictureTable nevada = read_picture_table(example("element_dss") + "/nevada_triggering.csv");
    EXPECT_NEAR((*nevada.find("CSR"))[0], triggering_curve(13.915), 1e-4);
}

TEST(ElementExample, CalibrationTellsOfPointsThatNoSandHas)
{
    const WorkFolder folder;
    std::ofstream(folder / "points.csv") << "CSR,N\n1.9,40\n";
    const Outcome outcome = run_program("calibrate " + example("element_dss") + "/lateral_spread.toml " +
                                        (folder / "points.csv").string() + " --fit secondary_factor");
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_NE(
        outcome.output.find("Warning: no values of these keys give such points; look at the data, or fit "
                            "other keys\n\nFor the scene:"),
        std::string::npos)
        << outcome.output;
}

TEST(ElementExample, TheReferencePageIsUpToDate)
{
    const Outcome outcome = run_program("keys --element --markdown");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(outcome.output == read_file(in_checkout("io/ELEMENT.md")))
        << "make it anew: quicksand keys --element --markdown > io/ELEMENT.md";
}

} // namespace

} // namespace quicksand
