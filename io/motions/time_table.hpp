// Tables of two columns in text files: time and a value.
#pragma once

#include "io/keys/diagnostics.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

struct TimeRow {
    double time = 0.0;  // [s]
    double value = 0.0; // as in the file
    int decimals = 0;   // with which the time is written
};

struct TimeTable {
    std::vector<TimeRow> rows;
    std::vector<int> lines; // of the file, where each row stands
    std::string header;     // the line above them, or names of columns in a comment there; empty: none
};

/// Rows of two numbers separated by a comma, a semicolon or blanks; one header line, empty lines and lines
/// with # are left out, but the header may be such a line. Returns what is wrong with the text, "" when it
/// holds two rows or more.
std::string parse_time_table(std::string_view text, TimeTable& table);

/// What is wrong with the times where they do not increase, "" when they do.
std::string check_order(const TimeTable& table);

/// The same where they do not start at 0 either.
std::string check_times(const TimeTable& table);

} // namespace quicksand
