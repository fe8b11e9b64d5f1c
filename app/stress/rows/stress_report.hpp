// The laboratory's report: lines on the terminal, a CSV file and a page.
#pragma once

#include "app/stress/rows/stress_summary.hpp"

#include <filesystem>

namespace quicksand {

/// The names of the columns of describe_row().
std::string row_heading();
/// One row as a line of the terminal.
std::string describe_row(const RowOutcome& outcome);

/// Counts, and the first rows of everything that is not as it should be, at most `most` of each kind.
std::string describe_summary(const StressSummary& summary, std::size_t most);

/// Replace the file: one line a row. Throws FileError.
void write_stress_csv(const std::filesystem::path& file, const std::vector<RowOutcome>& outcomes);

/// Replace the page stress.md: summary, figures beside it, and a table for each group. Throws FileError.
void write_stress_page(const std::filesystem::path& file, const std::vector<RowOutcome>& outcomes,
                       const std::vector<std::filesystem::path>& figures);

} // namespace quicksand
