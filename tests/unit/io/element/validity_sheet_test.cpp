// The table of what a law meets: its bands, its count, and what is bold.
#include "io/element/validity_sheet.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

/// A survey of which all values but one lie in their bands.
SandSurvey survey_of_loose_sand()
{
    SandSurvey survey{};
    survey.strength = CyclicStrength{};
    survey.strength->csr_15 = 0.093; // the triggering curve at (N1)60 = 6
    survey.strength->slope = 0.3;
    survey.k_sigma = 0.84;
    survey.k_0 = 1.2;
    survey.strain_of_cycles = {0.02, 0.025, 0.03, 0.035, 0.04, 0.045};
    survey.most_out_of_plane = 1.0;
    survey.reconsolidation = 0.001; // far too small
    survey.curve = {{{0.98, 0.008}, {0.82, 0.025}, {0.6, 0.06}, {0.32, 0.13}}};
    return survey;
}

TEST(ValiditySheet, CountsWhatIsMetAndMarksWhatIsNot)
{
    int met = 0, judged = 0;
    const std::string table = validity_table({{6.0, survey_of_loose_sand()}}, met, judged);
    EXPECT_EQ(judged, 14) << table; // neither K_alpha nor the first strain is judged at (N1)60 = 6
    EXPECT_EQ(met, 13) << table;
    EXPECT_NE(table.find("| reconsolidation strain after 8 % of shear strain [%] | **0.10** |"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("| K_sigma at 800 kPa | 0.84 |"), std::string::npos) << table;
    EXPECT_NE(table.find("| K_alpha at alpha = 0.1 | none |"), std::string::npos) << table;
}

TEST(ValiditySheet, ASandThatDoesNotLiquefyMeetsNothingOfStrength)
{
    SandSurvey survey = survey_of_loose_sand();
    survey.strength.reset();
    survey.strain_of_cycles.clear();
    survey.curve[0].damping_ratio = -1e-9;
    int met = 0, judged = 0;
    const std::string table = validity_table({{6.0, survey}}, met, judged);
    EXPECT_NE(table.find("| CSR(15) over the triggering curve | **none** |"), std::string::npos) << table;
    EXPECT_NE(table.find("| damping at 0.001 % [%] | **0.00** |"), std::string::npos) << table;
}

} // namespace
} // namespace quicksand
