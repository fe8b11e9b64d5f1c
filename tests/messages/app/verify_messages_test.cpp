// What can be wrong with a call of verify, and with a scene as a problem to verify.
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace testing_program;

void expect_refused_study(const std::string& arguments, const std::string& text)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("verify " + arguments + " -o " + (folder / "out").string());
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    EXPECT_NE(outcome.output.find(text), std::string::npos) << "no '" << text << "' in:\n" << outcome.output;
}

/// Of a scene beside that of the problem, which is its base.
void expect_refusal_of_variant(const std::string& problem, const std::string& keys, const std::string& text)
{
    const WorkFolder folder;
    std::filesystem::copy(example("verification/" + problem), folder / problem);
    std::ofstream(folder / (problem + "/variant.toml"))
        << "scene_version = 1\nbase = \"scene.toml\"\n" + keys;
    expect_refused_study("--short " + (folder / (problem + "/variant.toml")).string(), "variant: " + text);
}

TEST(Verify, AMisspeltProblemIsGuessed)
{
    expect_refused_study("biot_wave", "there is no problem 'biot_wave' to verify\nexpected: anura_column");
    expect_refused_study("biot_wave", "hint: did you mean biot_waves?");
}

TEST(Verify, ASceneWithoutAProblemIsNamed)
{
    expect_refused_study(example("column"),
                         "column/scene.toml holds no table [verification]\nhint: quicksand run runs it");
}

TEST(Verify, TwoProblemsOfOneNameAreRefused)
{
    const WorkFolder folder;
    const std::string copy = (folder / "biot_waves").string();
    std::filesystem::copy(example("verification/biot_waves"), copy);
    expect_refused_study("biot_waves --short " + copy, "two problems are called 'biot_waves'");
}

TEST(Verify, ALimitOfAnUnknownQuantityIsNamedWithThoseMeasured)
{
    expect_refused_study("biot_waves --short --set 'verification.limits.\"slow speed\"=[1, 1, 1]'",
                         "biot_waves measures no \"slow speed\"\nexpected: \"fast wave, speed\"");
}

TEST(Verify, AProblemThatItsStudyDoesNotKnowIsRefused)
{
    expect_refused_study("biot_waves --short --set boundaries.surface.soil=free",
                         "biot_waves: the verification needs a column whose top is fixed and impervious");
    expect_refused_study("permeability --short --set boundaries.surface.soil=fixed",
                         "permeability: the verification needs a column with a free and drained top");
}

TEST(Verify, AProblemWithoutWhatItsStudyNeedsIsRefused)
{
    expect_refused_study("terzaghi --short --set initial.excess_pore_pressure=0",
                         "terzaghi: the verification needs initial.excess_pore_pressure");
    expect_refused_study("terzaghi --short --set boundaries.surface.ramp_time=1",
                         "terzaghi: the verification needs a load that stands from the start");
    expect_refused_study("anura_column --short --set boundaries.surface.pressure=1e3",
                         "needs a load on the top that initial.excess_pore_pressure equals");
    expect_refused_study("periodic_column_3 --short --set boundaries.surface.ramp_time=1",
                         "needs a load on the top with a frequency and no ramp");
    expect_refused_study("transient_column --short --set boundaries.surface.pressure=0",
                         "the verification needs a load on the top of the column");
    expect_refused_study("biot_waves --short --set materials.soil.model=neo_hookean",
                         "needs the model linear_elastic, which the material \"soil\" does not have");
    expect_refused_study("large_strain_consolidation --short --set analysis.strain=small",
                         "large_strain_consolidation: the verification needs large strain");
    expect_refused_study("large_strain_consolidation --short --set materials.clay.permeability_law=constant",
                         "the verification needs permeability_law = \"specific_volume_squared\"");
    expect_refused_study("large_strain_consolidation --short --set initial.excess_pore_pressure=1e3",
                         "needs a load on the top that initial.excess_pore_pressure equals");
}

TEST(Verify, AProblemWithoutTheWaterOrTheWallsOfItsStudyIsRefused)
{
    expect_refusal_of_variant("terzaghi", "without = [\"water\"]\n",
                              "the verification needs a saturated scene, one with [water]");
    expect_refusal_of_variant("transient_column", "without = [\"boundaries.surface.history\"]\n",
                              "the verification needs a load on the top that starts from zero at t = 0: with "
                              "ramp_time, or with a history");
    expect_refusal_of_variant("mandel",
                              "without = [\"boundaries.plate.normal_displacement\", "
                              "\"boundaries.plate.ramp_time\"]\n"
                              "[boundaries.plate]\nnormal_velocity = 0.001\n",
                              "the verification needs a plate on top: soil = \"moving\" with a "
                              "normal_displacement");
    expect_refusal_of_variant("shear_beam",
                              "without = [\"boundaries.left.tied_to\", \"boundaries.right.tied_to\"]\n"
                              "[boundaries.left]\nsoil = \"roller\"\n"
                              "[boundaries.right]\nsoil = \"roller\"\n",
                              "the verification needs a layer between tied sides");
}

TEST(Verify, ABodyThatItsStudyDoesNotKnowIsRefused)
{
    expect_refused_study("vortex --short --set geometry.parameters.width=2",
                         "the vortex needs a body of at least 2.5 m by 2.5 m");
    expect_refused_study(
        "axis_aligned --short --set geometry.parameters.width=2",
        "the axis-aligned motion needs a square of 1 m whose lower left corner is the origin");
    expect_refused_study("vortex --short --set materials.rubber.model=linear_elastic",
                         "needs the model neo_hookean, which the material \"rubber\" does not have");
    expect_refused_study(
        "vortex --short --set water.level=0 --set materials.rubber.hydraulic_conductivity=1e-5"
        " --set materials.rubber.porosity=0.3",
        "the verification needs a dry scene, one without [water]");
    expect_refused_study("bar --short --set gravity.acceleration=0",
                         "the vibration needs gravity and an edge of the body that is held along its length");
}

TEST(Verify, ACollapseOrASlopeThatItsStudyDoesNotKnowIsRefused)
{
    const std::string wet = " --set water.level=0 --set materials.";
    expect_refused_study("collapse --short --set boundaries.wall.soil=free",
                         "the collapse needs a wall on one side of the column");
    expect_refused_study("collapse --short --set geometry.parameters.height=0.2",
                         "no law is published for columns between 1.8 and 2.8 times as high as wide");
    expect_refused_study("collapse --short" + wet + "sand.hydraulic_conductivity=1e-5",
                         "the collapse needs a dry scene whose soil has the model mohr_coulomb");
    expect_refused_study("griffiths_lane --short --set boundaries.face.soil=roller",
                         "the slope has no inclined free face among the named boundaries");
    expect_refused_study("griffiths_lane --short --set boundaries.base.soil=roller",
                         "the slope has no fixed base among the named boundaries");
    expect_refused_study("griffiths_lane --short" + wet + "soil.hydraulic_conductivity=1e-5",
                         "the slope is not one dry soil with model = \"mohr_coulomb\"");
}

} // namespace
} // namespace quicksand
