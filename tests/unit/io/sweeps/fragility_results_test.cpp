#include "io/sweeps/fragility_results.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace quicksand {

namespace {

Sweep shaken_sweep()
{
    Sweep sweep;
    sweep.file = "sweep.toml";
    sweep.varied = {{"motion.scale", {"1", "2"}, std::nullopt, {}}};
    sweep.fragility = FragilityRequest{"crest_settlement_m", 0.1, "motion.scale"};
    return sweep;
}

SweepOutcome outcome_at(double scale, double settlement, const std::string& state = "finished")
{
    SweepOutcome outcome;
    outcome.checked.values = {{"", "", scale}};
    outcome.state = state;
    outcome.summary = {{"history", "crest_settlement_m", settlement, 0.0, settlement}};
    return outcome;
}

} // namespace

TEST(Fragility, CountsFinishedRunsByIntensityAndAmount)
{
    const std::vector<SweepOutcome> outcomes = {outcome_at(1.0, 0.05), outcome_at(1.0, -0.2),
                                                outcome_at(1.0, 0.1),  outcome_at(2.0, 0.3),
                                                outcome_at(2.0, 0.0),  outcome_at(2.0, 9.0, "failed")};
    const FragilityResults results = assess_fragility(shaken_sweep(), outcomes);
    ASSERT_EQ(results.levels.size(), 2U);
    EXPECT_EQ(results.levels[0].runs, 3);
    EXPECT_EQ(results.levels[0].exceeding, 1);
    EXPECT_EQ(results.levels[1].share(), 0.5);
    EXPECT_EQ(results.left_out, 1);
    ASSERT_TRUE(results.fit.curve);
    EXPECT_NEAR(results.fit.curve->median, 2.0, 1e-9) << "where half of the runs exceed";
    EXPECT_EQ(describe_fragility(results),
              "median 2, beta 1.61; 1 run is left out: not finished, or without a value");

    const fixtures::TemporaryFolder folder;
    write_fragility_csv(folder / "f.csv", shaken_sweep(), results);
    std::ifstream stream(folder / "f.csv");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_NE(text.find("# crest_settlement_m above 0.1, over motion.scale\n"
                        "# lognormal curve of maximum likelihood: median 2, beta 1.60925\n"
                        "motion.scale,runs,exceeding,share,probability\n1,3,1,0.333"),
              std::string::npos)
        << text;
}

TEST(Fragility, NamesTheQuantitiesThereAre)
{
    Sweep sweep = shaken_sweep();
    sweep.fragility->quantity = "crest_setlement_m";
    try {
        assess_fragility(sweep, {outcome_at(1.0, 0.1)});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "sweep.toml: no finished run has fragility.quantity = \"crest_setlement_m\"\n"
                     "expected: crest_settlement_m\nhint: did you mean \"crest_settlement_m\"?");
    }
}

TEST(Fragility, NamesTheQuantitiesThatWillBeBeforeAnyRun)
{
    CheckedRun run = outcome_at(1.0, 0.1).checked;
    run.probes = {"crest.toe", "crest"};
    Sweep sweep = shaken_sweep();
    for (const char* known : {"crest_settlement_m", "crest_settlement_m_final", "max_velocity_m_s",
                              "crest.ux_m", "crest.ru_peak", "crest.toe.ux_m"}) {
        sweep.fragility->quantity = known;
        EXPECT_NO_THROW(require_quantity(sweep, {run})) << known;
    }
    sweep.fragility->quantity = "cres.ux_m";
    try {
        require_quantity(sweep, {run});
        FAIL();
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with(
            "sweep.toml: no run will have fragility.quantity = \"cres.ux_m\"\nexpected: "))
            << message;
        EXPECT_TRUE(message.ends_with("\nhint: did you mean \"crest.ux_m\"?")) << message;
    }
}

TEST(Fragility, NeedsIntensitiesAboveZero)
{
    EXPECT_THROW(require_intensities(shaken_sweep(), {outcome_at(0.0, 0.1).checked}), InputError);
    EXPECT_NO_THROW(require_intensities(shaken_sweep(), {outcome_at(0.1, 0.1).checked}));
}

} // namespace quicksand
