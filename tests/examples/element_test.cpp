// The example of the element laboratory: its files, its numbers, the page of its keys.
#include "io/pictures/picture_table.hpp"
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {

namespace {

using namespace testing_program;

/// CRR of Idriss and Boulanger (2008) for 15 cycles at one atmosphere, C_0 = 2.8.
double triggering_curve(double N)
{
    return std::exp(N / 14.1 + std::pow(N / 126.0, 2) - std::pow(N / 23.6, 3) + std::pow(N / 25.4, 4) - 2.8);
}

TEST(ElementExample, HasTheStrengthOfTheTriggeringCurve)
{
    const WorkFolder folder;
    const Outcome outcome =
        run_program("element " + example("element_dss") + " -o " + (folder / "out").string());
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    for (const char* name :
         {"report.txt", "test.toml", "nevada/report.png", "nevada/loops.png", "nevada/stress_path.png",
          "nevada/ru.png", "nevada/strain.png", "nevada/csr_n.png", "nevada/csr_n.csv",
          "nevada/path_CSR_0.15.csv", "density/report.png", "density/path_n1_60_20_CSR_0.3.csv"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / ("out/" + std::string(name)))) << name;
    }
    const PictureTable density = read_picture_table(folder / "out/density/strength.csv");
    ASSERT_EQ(density.find("n1_60")->size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        const double n1_60 = (*density.find("n1_60"))[k], csr_15 = (*density.find("csr_15"))[k];
        EXPECT_NEAR(csr_15 / triggering_curve(n1_60), 1.0, 0.08) << n1_60;
        EXPECT_GT((*density.find("slope_b"))[k], 0.25) << n1_60;
        EXPECT_LT((*density.find("slope_b"))[k], 0.36) << n1_60;
    }
    const PictureTable nevada = read_picture_table(folder / "out/nevada/strength.csv");
    EXPECT_NEAR((*nevada.find("csr_15"))[0], 0.146, 0.002);
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

TEST(ElementExample, TheOtherTestsRun)
{
    const WorkFolder folder;
    const Outcome outcome =
        run_program("element " + example("element_dss") + "/others.toml -o " + (folder / "out").string());
    ASSERT_EQ(outcome.code, 0) << outcome.output;
    for (const char* test : {"strain_controlled", "static_shear", "undrained_shear", "drained_shear",
                             "biaxial", "oedometer", "isotropic"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / ("out/" + std::string(test) + "/report.png"))) << test;
    }
}

TEST(ElementExample, TheReferencePageIsUpToDate)
{
    const Outcome outcome = run_program("keys --element --markdown");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(outcome.output == read_file(QUICKSAND_SOURCE_DIR "/io/ELEMENT.md"))
        << "make it anew: quicksand keys --element --markdown > io/ELEMENT.md";
}

} // namespace

} // namespace quicksand
