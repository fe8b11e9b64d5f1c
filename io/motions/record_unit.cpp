#include "io/motions/record_unit.hpp"

#include "solver/base/conventions.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
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

/// The last that has a name.
std::string_view last_column(std::string_view header)
{
    header = header.substr(0, header.find_last_not_of(",; \t") + 1);
    return header.substr(header.find_last_of(",;") + 1);
}

/// Up to a comma or semicolon; in a header without them its first word, with the brackets behind it.
std::string_view first_column(std::string_view header)
{
    const std::size_t end = header.find_first_of(",;");
    if (end != std::string_view::npos) return header.substr(0, end);
    const std::size_t gap = header.find_first_of(" \t");
    const std::size_t next = header.find_first_not_of(" \t", gap);
    if (next == std::string_view::npos || (header[next] != '(' && header[next] != '['))
        return header.substr(0, gap);
    return header.substr(0, header.find_first_of(")]", next) + 1);
}

/// What follows the gaps of a column's name, the longest first: "acc_cm_s2" has "cm_s2" and "s2".
std::vector<std::string_view> tails_of(std::string_view name, std::string_view gaps)
{
    std::vector<std::string_view> tails;
    for (std::size_t k = 0; k < name.size(); ++k)
        if (gaps.find(name[k]) != std::string_view::npos) tails.push_back(name.substr(k + 1));
    return tails;
}

/// The unit in a column's name, one of `units`: "[ms]", "(ms)" or "time_ms"; empty where there is none.
std::string unit_in(std::string_view name, std::span<const std::string_view> units)
{
    std::vector<std::string_view> candidates = in_brackets(name);
    for (const std::string_view tail : tails_of(name, "_")) candidates.push_back(tail);
    for (const std::string_view words : candidates)
        if (std::find(units.begin(), units.end(), plain(words)) != units.end()) return std::string(words);
    return "";
}

/// The last column without quotation marks; in a header without commas and semicolons its last word, for that
/// may be a title.
std::string_view last_name(std::string_view header)
{
    constexpr std::string_view gaps = " \t\"'";
    const std::string_view column = last_column(header);
    const std::size_t begin = column.find_first_not_of(gaps), end = column.find_last_not_of(gaps);
    if (begin == std::string_view::npos) return {};
    const std::string_view name = column.substr(begin, end + 1 - begin);
    return column.size() < header.size() ? name : name.substr(name.find_last_of(gaps) + 1);
}

/// Whether the first word for a motion in a column's name is that of a velocity or displacement
/// ("acc_disp_corrected" is an acceleration), or the name is or ends with the unit of a velocity.
bool is_other_motion(std::string_view name)
{
    constexpr std::array<std::string_view, 7> motions = {"VEL",   "VELOCITY",     "VELOCITIES",   "DISP",
                                                         "DISPL", "DISPLACEMENT", "DISPLACEMENTS"};
    constexpr std::array<std::string_view, 3> units = {"M/S", "CM/S", "MM/S"};
    const auto is_one_of = [](const auto& words, const std::string& word) {
        return std::find(words.begin(), words.end(), word) != words.end();
    };
    std::string word;
    bool is_named = false, is_told = false;
    for (const char c : std::string(name) + ' ') {
        if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
            word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
            continue;
        }
        is_named = is_named || (!is_told && is_one_of(motions, word));
        is_told = is_told || is_named || word.starts_with("ACC");
        word.clear();
    }
    auto tails = tails_of(name, "_");
    tails.push_back(name);
    return is_named || std::any_of(tails.begin(), tails.end(),
                                   [&](std::string_view tail) { return is_one_of(units, plain(tail)); });
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
    // a_g is the ground's acceleration
    for (const std::string_view tail : tails_of(name, "_ ")) {
        const auto unit = record_unit(tail);
        if (unit && plain(unit->name) != "G") return unit;
    }
    return std::nullopt;
}

std::string unknown_unit_of_column(std::string_view header)
{
    constexpr std::array<std::string_view, 5> lengths = {"M", "CM", "MM", "FT", "IN"};
    if (unit_of_column(header)) return "";
    const std::string_view column = last_column(header), name = last_name(header);
    if (is_other_motion(name)) return std::string(name);
    for (const std::string_view words : in_brackets(column)) {
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
    constexpr std::string_view units[] = {"US",     "MS",      "MSEC", "MILLISECONDS", "MIN", "MINS",
                                          "MINUTE", "MINUTES", "H",    "HR",           "HRS", "HOUR",
                                          "HOURS",  "D",       "DAY",  "DAYS"};
    return unit_in(first_column(header), units);
}

std::string unit_of_values(std::string_view header)
{
    constexpr std::string_view units[] = {"PA",    "KPA", "MPA", "GPA", "BAR", "PSI", "N/M2", "KN/M2",
                                          "MN/M2", "M",   "CM",  "MM",  "FT",  "M/S", "CM/S", "MM/S"};
    return unit_in(last_column(header), units);
}

} // namespace quicksand
