// Histories read back from a run's CSV files, for plots.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// A CSV file with `#` comments and one header line; empty cells are NaN.
struct PictureTable {
    std::vector<std::string> comments;       // without their #
    std::vector<std::string> columns;        // names with units, "time_s" first
    std::vector<std::vector<double>> values; // values[c] is column c from top to bottom, in SI

    /// The column of that name, null where there is none.
    const std::vector<double>* find(std::string_view column) const;
    /// What follows `key` in the comment that begins with it, "" where there is none.
    std::string comment(std::string_view key) const;
};

/// Rows with fewer cells than the header, as a run that is still going on may leave one, are left out.
/// Throws FileError.
PictureTable read_picture_table(const std::filesystem::path& file);

} // namespace quicksand
