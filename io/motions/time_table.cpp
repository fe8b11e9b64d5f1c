#include "io/motions/time_table.hpp"

#include "io/keys/scene_units.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace quicksand {

namespace {

struct WrittenNumber {
    double value = 0.0;
    std::string_view text;
};

std::optional<WrittenNumber> take_number(std::string_view& text)
{
    const auto skip = [&](std::string_view skipped) {
        while (!text.empty() && skipped.find(text.front()) != std::string_view::npos) text.remove_prefix(1);
    };
    skip(" \t");
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    const std::string_view written = text.substr(0, static_cast<std::size_t>(end - text.data()));
    text.remove_prefix(written.size());
    skip(" \t");
    return WrittenNumber{value, written};
}

/// 7.8125e-3 has seven.
int decimals_of(std::string_view written)
{
    const std::size_t exponent_at = std::min(written.find_first_of("eE"), written.size());
    const std::string_view mantissa = written.substr(0, exponent_at);
    const std::size_t point = mantissa.find('.');
    int exponent = 0;
    if (exponent_at < written.size()) {
        std::string_view digits = written.substr(exponent_at + 1);
        if (digits.starts_with('+')) digits.remove_prefix(1);
        std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    }
    const std::size_t behind = point == std::string_view::npos ? 0 : mantissa.size() - point - 1;
    return static_cast<int>(behind) - exponent;
}

/// A row of exactly two numbers, separated by a comma, a semicolon or blanks.
std::optional<TimeRow> parse_row(std::string_view line)
{
    const auto time = take_number(line);
    if (!time) return std::nullopt;
    if (!line.empty() && (line.front() == ',' || line.front() == ';')) line.remove_prefix(1);
    const auto value = take_number(line);
    if (!value || !line.empty()) return std::nullopt;
    return TimeRow{time->value, value->value, decimals_of(time->text)};
}

/// How many words there are outside brackets.
int count_words(std::string_view words)
{
    int count = 0, depth = 0;
    bool inside = false;
    for (const char c : words) {
        if (c == '(' || c == '[') ++depth;
        const bool is_letter = depth == 0 && c != ' ' && c != '\t';
        count += is_letter && !inside ? 1 : 0;
        inside = is_letter;
        if ((c == ')' || c == ']') && depth > 0) --depth;
    }
    return count;
}

/// The names of two columns in a comment, as numpy writes them ("# time,acceleration"): the first is time, or
/// t. Empty where the comment says something else.
std::string_view names_in_comment(std::string_view comment)
{
    comment.remove_prefix(std::min(comment.find_first_not_of("# \t"), comment.size()));
    std::string first;
    for (const char c : comment.substr(0, comment.find_first_of(" \t([_,;")))
        first += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (first != "t" && first != "time") return {};
    const auto is_comma = [](char c) { return c == ',' || c == ';'; };
    const std::string_view named = comment.substr(0, comment.find_last_not_of(",; \t") + 1);
    const auto commas = std::count_if(named.begin(), named.end(), is_comma);
    return commas == 1 || (commas == 0 && count_words(named) == 2) ? comment : std::string_view();
}

} // namespace

std::string parse_time_table(std::string_view text, TimeTable& table)
{
    int number = 0;
    bool header_allowed = true;
    while (!text.empty()) {
        const auto end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
        ++number;
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
        if (line.starts_with('#')) {
            const std::string_view names = names_in_comment(line);
            if (header_allowed && table.header.empty()) table.header = std::string(names);
            continue;
        }
        const auto row = parse_row(line);
        if (row) {
            table.rows.push_back(*row);
            table.lines.push_back(number);
        } else if (!header_allowed) {
            return "line " + std::to_string(number) +
                   " is not two numbers: " + std::string(line.substr(0, 60));
        } else {
            table.header = std::string(line);
        }
        header_allowed = false;
    }
    return table.rows.size() < 2 ? "it holds fewer than two rows of two numbers" : "";
}

std::string check_order(const TimeTable& table)
{
    for (std::size_t k = 1; k < table.rows.size(); ++k) {
        if (!(table.rows[k].time > table.rows[k - 1].time))
            return "its time does not increase at line " + std::to_string(table.lines[k]);
    }
    return "";
}

std::string check_times(const TimeTable& table)
{
    // a first time printed with few digits may miss 0 by this part of the interval
    constexpr double tolerance = 0.01;
    const std::vector<TimeRow>& rows = table.rows;
    const double interval = (rows.back().time - rows.front().time) / static_cast<double>(rows.size() - 1);
    if (std::abs(rows.front().time) > tolerance * std::abs(interval))
        return "its time starts at " + number_text(rows.front().time) + " s, not at 0";
    return check_order(table);
}

} // namespace quicksand
