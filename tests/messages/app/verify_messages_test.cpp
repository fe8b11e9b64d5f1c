// What can be wrong with a call of verify, and with a scene as a problem to verify.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace testing_program;

void expect_refusal(const std::string& arguments, const std::string& text)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("verify " + arguments + " -o " + (folder / "out").string());
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    EXPECT_NE(outcome.output.find(text), std::string::npos) << "no '" << text << "' in:\n" << outcome.output;
}

TEST(Verify, AMisspeltProblemIsGuessed)
{
    expect_refusal("biot_wave", "there is no problem 'biot_wave' to verify\nexpected: anura_column");
    expect_refusal("biot_wave", "hint: did you mean biot_waves?");
}

TEST(Verify, ASceneWithoutAProblemIsNamed)
{
    expect_refusal(example("column"), "column/scene.toml holds no table [verification]");
}

TEST(Verify, TwoProblemsOfOneNameAreRefused)
{
    const WorkFolder folder;
    const std::string copy = (folder / "biot_waves").string();
    std::filesystem::copy(example("verification/biot_waves"), copy);
    expect_refusal("biot_waves --short " + copy, "two problems are called 'biot_waves'");
}

TEST(Verify, ALimitOfAnUnknownQuantityIsNamedWithThoseMeasured)
{
    expect_refusal("biot_waves --short --set 'verification.limits.\"slow speed\"=[1, 1, 1]'",
                   "biot_waves measures no \"slow speed\"\nexpected: \"fast wave, speed\"");
}

TEST(Verify, AProblemThatItsStudyDoesNotKnowIsRefused)
{
    expect_refusal("biot_waves --short --set boundaries.surface.soil=free",
                   "biot_waves: the verification needs a column whose top is fixed and impervious");
    expect_refusal("permeability --short --set boundaries.surface.soil=fixed",
                   "permeability: the verification needs a column with a free and drained top");
}

TEST(Verify, AProblemWithoutWhatItsStudyNeedsIsRefused)
{
    expect_refusal("terzaghi --short --set initial.excess_pore_pressure=0",
                   "terzaghi: the verification needs initial.excess_pore_pressure");
    expect_refusal("anura_column --short --set boundaries.surface.pressure=1e3",
                   "needs a load on the top that initial.excess_pore_pressure equals");
    expect_refusal("periodic_column_3 --short --set boundaries.surface.ramp_time=1",
                   "needs a load on the top with a frequency and no ramp");
    expect_refusal("transient_column --short --set boundaries.surface.pressure=0",
                   "the verification needs a load on the top of the column");
    expect_refusal("biot_waves --short --set materials.soil.model=neo_hookean",
                   "needs the model linear_elastic, which the material \"soil\" does not have");
}

} // namespace
} // namespace quicksand
