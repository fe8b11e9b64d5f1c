// The results of an element test in lines of text, for the terminal and the report's page.
#pragma once

#include "io/element/element_outcome.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// Soil, specimen, loading and criterion: the heading of a report.
std::vector<std::string> describe_conditions(const ElementOutcome& outcome);

/// The numbers of the test, at most `most_rows` rows of it.
std::vector<std::string> result_table(const ElementOutcome& outcome, std::size_t most_rows);

} // namespace quicksand
