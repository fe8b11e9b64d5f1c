#include "solver/measure/body_quantities.hpp"
#include "solver/measure/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

const Criterion& criterion(std::string_view name)
{
    const auto all = verdict_criteria();
    return *std::find_if(all.begin(), all.end(),
                         [&](const Criterion& each) { return each.quantity == name; });
}

const std::vector<double> times = {0.0, 1.0, 2.0, 3.0};

TEST(Verdict, LooksAtQuantitiesThatTheHistoryHas)
{
    for (const Criterion& each : verdict_criteria()) {
        const auto columns = all_body_quantities();
        EXPECT_TRUE(std::any_of(columns.begin(), columns.end(), [&](const BodyQuantity& quantity) {
            return column_name(quantity) == each.quantity;
        })) << each.quantity;
        EXPECT_LT(each.good, each.usable);
    }
}

TEST(Verdict, FollowsTheLargestAmountOfEitherSign)
{
    const Finding finding = judge(criterion("energy_error"), times, std::vector{0.0, -0.05, 0.02, 0.0});
    EXPECT_EQ(finding.worst, 0.05);
    EXPECT_EQ(finding.time, 1.0);
    EXPECT_EQ(finding.grade, Grade::usable);
    EXPECT_EQ(judge(criterion("energy_error"), times, std::vector{0.0, 1e-4, 0.0, 0.0}).grade, Grade::good);
    EXPECT_EQ(judge(criterion("energy_error"), times, std::vector{0.0, 0.86, 0.0, 0.0}).grade, Grade::bad);
    EXPECT_EQ(judge(criterion("water_error"), times, std::vector{0.0, 0.0, 0.0, 0.02}).grade, Grade::bad);
}

TEST(Verdict, CountsErrorsOfLittleEnergyForLittle)
{
    const std::vector<double> errors = {0.0, 0.5, 0.002, 0.001}, energy = {0.0, 1.0, 50.0, 100.0};
    const Finding finding = judge(criterion("energy_error"), times, errors, energy);
    EXPECT_EQ(finding.worst, 0.005);
    EXPECT_EQ(finding.grade, Grade::good);
    const std::vector<double> nothing(4, 0.0);
    EXPECT_EQ(judge(criterion("energy_error"), times, nothing, nothing).grade, Grade::good);
}

TEST(Verdict, IsBadWithoutNumbers)
{
    const Finding finding = judge(criterion("water_error"), times, std::vector{0.0, std::nan(""), 0.0, 0.0});
    EXPECT_EQ(finding.grade, Grade::bad);
    EXPECT_EQ(finding.time, 1.0);
}

TEST(Verdict, OfARunIsTheWorst)
{
    EXPECT_EQ(worst_grade({}), Grade::good);
    Finding usable, bad;
    usable.grade = Grade::usable;
    EXPECT_EQ(worst_grade({Finding{}, usable}), Grade::usable);
    bad.grade = Grade::bad;
    EXPECT_EQ(worst_grade({bad, usable}), Grade::bad);
    EXPECT_EQ(name_of(Grade::usable), "usable");
}

} // namespace
} // namespace quicksand
