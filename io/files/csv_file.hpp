// A CSV file that grows row by row: a block of # comments, one header line, rows of numbers, time_s first.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

using CsvRow = std::vector<std::string>;

/// Shortest text that reads back to the same double; "" for NaN.
std::string csv_number(double value);

/// Text in quotes, so that it may hold commas.
std::string csv_text(const std::string& text);

/// The comments, each behind a #, and the line of column names.
std::string csv_header(const std::vector<std::string>& comments, const std::vector<std::string>& columns);

/// The cells of a line, split at its commas; an empty line is one empty cell.
CsvRow csv_cells(const std::string& line);

/// The number in a cell, NaN when it is empty or none.
double csv_value(const std::string& cell);

class CsvFile {
public:
    /// Begin a file, replacing an older one. `comments` come without their #. Throws FileError.
    static CsvFile begin(const std::filesystem::path& path, const std::vector<std::string>& comments,
                         const std::vector<std::string>& columns);

    /// Go on with a file: rows after `time` and a torn last row are dropped. Begins it when it is missing.
    static CsvFile resume(const std::filesystem::path& path, const std::vector<std::string>& comments,
                          const std::vector<std::string>& columns, double time);

    /// Keep a row until the next flush().
    void add_row(const CsvRow& row);
    /// The same with the texts of csv_number().
    void add_numbers(const std::vector<double>& numbers);

    /// Hand the rows to the system; afterwards a kill does not lose them. Throws FileError.
    void flush();

    /// Of a resumed file: its first row, and all rows that share its last time. Empty otherwise.
    const std::optional<CsvRow>& first_row() const { return first_row_; }
    const std::vector<CsvRow>& last_rows() const { return last_rows_; }
    /// Time of the last kept row [s].
    std::optional<double> last_time() const;
    /// Number in the named column of one of these rows.
    double value(const CsvRow& row, const std::string& column) const;

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    CsvFile(std::filesystem::path path, std::vector<std::string> columns);
    void remember(const std::string& line);

    std::filesystem::path path_;
    std::vector<std::string> columns_;
    std::unique_ptr<std::FILE, Close> file_;
    std::string pending_;
    std::optional<CsvRow> first_row_;
    std::vector<CsvRow> last_rows_;
};

} // namespace quicksand
