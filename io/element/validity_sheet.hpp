// What a law for sand meets of what laboratories know, and what it does not: a table in Markdown.
#pragma once

#include "solver/element/sand_survey.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// A survey of the sand of a blow count.
struct SurveyedSand {
    double n1_60; // [-]
    SandSurvey survey;
};

/// A row for each quantity, a column for each blow count; what is outside its band stands in bold, and the
/// last column counts what is met. `met` and `judged` grow by what is in the table.
std::string validity_table(const std::vector<SurveyedSand>& sands, int& met, int& judged);

/// Where the bands come from, below the tables.
std::string validity_sources();

} // namespace quicksand
