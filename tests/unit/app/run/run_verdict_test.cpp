// The verdict on histories as files.
#include "app/run/run_verdict.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace quicksand {
namespace {

using fixtures::TemporaryFolder;

std::vector<Finding> verdict_on(const std::string& history)
{
    const TemporaryFolder folder;
    const ResultsFolder results{folder.path()};
    std::ofstream(results.history()) << history;
    return judge_history(results);
}

// A run that blows up makes energy in the soil and loses it between particles and grid: its balance closes.
TEST(RunVerdict, IsBadWhereMuchMoreIsLostThanWasPutIn)
{
    const std::string head = "time_s,kinetic_energy_J,numerical_loss_J,base_work_J,energy_error\n";
    const std::vector<Finding> findings = verdict_on(head + "0,0,0,0,0\n1,1,2,10,0\n2,1,360,4,0\n");
    EXPECT_EQ(worst_grade(findings), Grade::bad);
    EXPECT_NE(explain_bad_verdict(findings).find(
                  "numerical loss 36 at t = 2 s: more is lost between particles and grid than was put in"),
              std::string::npos)
        << explain_bad_verdict(findings);
    EXPECT_EQ(worst_grade(verdict_on(head + "0,0,0,0,0\n1,1,2,10,0\n2,1,8,4,0\n")), Grade::good);
}

// 5 J are lost of 20 J that are left of 100 J.
TEST(RunVerdict, TakesTheEnergyErrorAtTheEndAsItIs)
{
    const std::string head = "time_s,kinetic_energy_J,energy_error\n", before = "0,0,0\n1,100,1e-3\n";
    EXPECT_EQ(worst_grade(verdict_on(head + before + "2,20,0.25\n3,90,0.06\n")), Grade::usable);
    EXPECT_EQ(worst_grade(verdict_on(head + before + "2,20,0.25\n")), Grade::bad);
    EXPECT_EQ(worst_grade(verdict_on(head + before + "2,2,0.25\n")), Grade::good);
}

TEST(RunVerdict, CountsTheEnergyAtTheStart)
{
    const std::string head = "time_s,kinetic_energy_J,numerical_loss_J,storage_energy_water_J\n";
    EXPECT_EQ(worst_grade(verdict_on(head + "0,1,0,9,0\n1,0,10,0,0\n")), Grade::good);
}

// A body at rest whose rounding works on nothing: 1e5 kg and 49 m2, m g H / 2 1e-12 = 3.4e-6 J.
TEST(RunVerdict, IsNotBadWhereABodyAtRestLosesWhatIsRounding)
{
    const std::string head = "time_s,numerical_loss_J,gravity_work_J,mass_solid_kg,volume_m3\n";
    EXPECT_EQ(worst_grade(verdict_on(head + "0,0,0,1e5,49\n1,5e-7,-3e-8,1e5,49\n")), Grade::good);
    EXPECT_EQ(worst_grade(verdict_on(head + "0,0,0,1e5,49\n1,5e-5,-3e-8,1e5,49\n")), Grade::bad);
}

TEST(RunVerdict, SaysWhereSmallStrainIsLarge)
{
    EXPECT_EQ(worst_grade(verdict_on("time_s,max_strain\n0,0\n1,0.05\n")), Grade::good);
    const std::vector<Finding> findings = verdict_on("time_s,max_strain\n0,0\n1,2.5\n");
    EXPECT_EQ(worst_grade(findings), Grade::usable);
    EXPECT_NE(describe_verdict(findings, 0)
                  .find("max strain 2.5 at t = 1 s: strains are beyond what "
                        "analysis.strain = \"small\" can tell"),
              std::string::npos)
        << describe_verdict(findings, 0);
}

TEST(RunVerdict, TellsHowOftenTheStepWasHalved)
{
    const std::vector<Finding> findings = verdict_on("time_s,energy_error\n0,0\n1,1e-4\n");
    EXPECT_EQ(describe_verdict(findings, 0), "Verdict: good; largest energy error 0.0001");
    EXPECT_EQ(describe_verdict(findings, 1),
              "Verdict: good; largest energy error 0.0001\n  the step that was chosen "
              "was too long: the watchdog has halved it once");
    EXPECT_NE(describe_verdict(findings, 3).find("has halved it 3 times"), std::string::npos);
}

} // namespace
} // namespace quicksand
