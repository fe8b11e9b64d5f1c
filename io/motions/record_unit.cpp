#include "io/motions/record_unit.hpp"

#include "solver/base/conventions.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

namespace quicksand {

namespace {

constexpr std::array<std::pair<std::string_view, double>, 10> unit_words = {{{"G", standard_gravity},
                                                                             {"CM/S/S", 0.01},
                                                                             {"CM/S2", 0.01},
                                                                             {"CM/SEC/SEC", 0.01},
                                                                             {"CM/SEC2", 0.01},
                                                                             {"GAL", 0.01},
                                                                             {"M/S/S", 1.0},
                                                                             {"M/S2", 1.0},
                                                                             {"M/SEC/SEC", 1.0},
                                                                             {"M/SEC2", 1.0}}};

/// In upper case, without signs of powers, braces and blanks; "m_s2" and "m/s**2" as "M/S2".
std::string plain(std::string_view words)
{
    std::string result;
    for (std::size_t k = 0; k < words.size(); ++k) {
        const char c = words[k];
        if (std::string_view("^* \t(){}").find(c) != std::string_view::npos) continue;
        if (words.substr(k).starts_with("\u00b2")) {
            result += '2';
            ++k; // of two bytes
        } else {
            result += c == '_' ? '/' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        }
    }
    return result;
}

std::string_view without_brackets(std::string_view words)
{
    return words.starts_with('[') && words.ends_with(']') ? words.substr(1, words.size() - 2) : words;
}

/// What stands in the brackets after a column's name, the last first.
std::vector<std::string_view> in_brackets(std::string_view name)
{
    std::vector<std::string_view> found;
    for (std::size_t end = name.find_last_of(")]"); end != std::string_view::npos;
         end = name.find_last_of(")]")) {
        const std::size_t begin = name.find_last_of(name[end] == ')' ? '(' : '[', end);
        if (begin == std::string_view::npos) break;
        found.push_back(name.substr(begin + 1, end - begin - 1));
        name = name.substr(0, begin);
    }
    return found;
}

std::string_view last_column(std::string_view header)
{
    return header.substr(header.find_last_of(",;") + 1);
}

std::string_view first_column(std::string_view header)
{
    return header.substr(0, header.find_first_of(",;"));
}

/// What a column's name ends with where is_unit(words) is true of it: "[ms]", "(ms)", "time_ms" or "time ms".
template <class IsUnit>
std::string ending(std::string_view name, IsUnit&& is_unit)
{
    for (const std::string_view words : in_brackets(name))
        if (is_unit(words)) return std::string(words);
    const std::size_t last = name.find_last_not_of(" \t");
    name = name.substr(0, last == std::string_view::npos ? 0 : last + 1);
    const std::size_t gap = name.find_last_of("_ ");
    if (gap == std::string_view::npos || !is_unit(name.substr(gap + 1))) return "";
    return std::string(name.substr(gap + 1));
}

} // namespace

std::optional<RecordUnit> record_unit(std::string_view words)
{
    const std::string name = plain(without_brackets(words));
    for (const auto& [known, value] : unit_words)
        if (name == known) return RecordUnit{std::string(words), value};
    return std::nullopt;
}

std::optional<RecordUnit> unit_of_column(std::string_view header)
{
    const std::string_view name = last_column(header);
    for (const std::string_view words : in_brackets(name))
        if (const auto unit = record_unit(words)) return unit;
    // "acc_cm_s2": what follows an underscore or a blank, the longest first; a_g is the ground's acceleration
    for (std::size_t k = 0; k < name.size(); ++k) {
        if (name[k] != '_' && name[k] != ' ') continue;
        const auto unit = record_unit(name.substr(k + 1));
        if (unit && plain(unit->name) != "G") return unit;
    }
    return std::nullopt;
}

std::string unknown_unit_of_column(std::string_view header)
{
    constexpr std::array<std::string_view, 5> lengths = {"M", "CM", "MM", "FT", "IN"};
    if (unit_of_column(header)) return "";
    for (const std::string_view words : in_brackets(last_column(header))) {
        const std::string unit = plain(words);
        const std::string length = unit.substr(0, unit.find('/')), time = unit.substr(length.size());
        const bool of_motion = std::find(lengths.begin(), lengths.end(), length) != lengths.end() &&
                               (time.empty() || time.starts_with("/S"));
        if (of_motion || unit == "%G" || unit == "MG") return std::string(words);
    }
    return "";
}

std::string foreign_unit_of_time(std::string_view header)
{
    constexpr std::array<std::string_view, 15> times = {"US",     "MS",      "MSEC", "MIN", "MINS",
                                                        "MINUTE", "MINUTES", "H",    "HR",  "HRS",
                                                        "HOUR",   "HOURS",   "D",    "DAY", "DAYS"};
    return ending(first_column(header), [&](std::string_view words) {
        return std::find(times.begin(), times.end(), plain(words)) != times.end();
    });
}

std::string unit_of_values(std::string_view header)
{
    constexpr std::array<std::string_view, 14> units = {"PA",    "KPA", "MPA", "GPA", "BAR", "PSI", "KN/M2",
                                                        "MN/M2", "M",   "CM",  "MM",  "FT",  "M/S", "MM/S"};
    return ending(last_column(header), [&](std::string_view words) {
        return std::find(units.begin(), units.end(), plain(words)) != units.end();
    });
}

} // namespace quicksand
