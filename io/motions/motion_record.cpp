#include "io/motions/motion_record.hpp"

#include "io/keys/scene_text.hpp"
#include "io/keys/scene_units.hpp"
#include "io/motions/peer_record.hpp"
#include "io/motions/record_limits.hpp"
#include "io/motions/record_unit.hpp"
#include "io/motions/time_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace quicksand {

namespace {

/// What times may miss of equal intervals [s]: rounding, of which the last ones, which may have the fewest
/// decimals, tell how coarse it is. Rows that are missing are more than a quarter of an interval.
double forgiven_distance(const std::vector<TimeRow>& rows, double interval)
{
    constexpr double least = 0.01, most = 0.25; // of the interval
    constexpr std::size_t last_rows = 10;
    int decimals = 0;
    for (std::size_t k = rows.size() - std::min(rows.size(), last_rows); k < rows.size(); ++k)
        decimals = std::max(decimals, rows[k].decimals);
    return interval * std::clamp(std::pow(10.0, -decimals) / interval, least, most);
}

/// What is wrong with the times, "" when they are equally spaced.
std::string check_spacing(const TimeTable& table)
{
    const std::vector<TimeRow>& rows = table.rows;
    if (std::string what = check_order(table); !what.empty()) return what;
    const double interval = (rows.back().time - rows.front().time) / static_cast<double>(rows.size() - 1);
    const auto step = [&](std::size_t k) { return rows[k].time - rows[k - 1].time; };
    const auto text = [&](std::size_t k) {
        return number_text(std::round(step(k) * 1e9) * 1e-9) + " s (line " + std::to_string(table.lines[k]) +
               ")";
    };
    const double forgiven = forgiven_distance(rows, interval);
    std::size_t shortest = 1, longest = 1;
    bool even = true;
    for (std::size_t k = 1; k < rows.size(); ++k) {
        if (step(k) < step(shortest)) shortest = k;
        if (step(k) > step(longest)) longest = k;
        const double expected = rows.front().time + static_cast<double>(k) * interval;
        even = even && std::abs(rows[k].time - expected) <= forgiven;
    }
    return even ? "" : "its time steps are between " + text(shortest) + " and " + text(longest);
}

double unit_of(const std::string& word)
{
    return word == "g" ? standard_gravity : 1.0;
}

/// A unit that the user states must be the record's own. `name` is that of the record's.
bool agrees(const StatedUnit& unit, double of_record, const std::string& name,
            const std::filesystem::path& file, Diagnostics& findings)
{
    if (unit.word.empty() || unit_of(unit.word) == of_record) return true;
    findings.add(error_at(unit.place, "motion", "the header of '" + file.string() + "' says " + name, "",
                          "leave " + unit.key + " out"));
    return false;
}

/// The motion of a table; what is beyond that of an earthquake is added to `findings`.
std::optional<SampledMotion> motion_of(const TimeTable& table, const RecordUnit& unit,
                                       const std::filesystem::path& file, const std::string& text,
                                       Diagnostics& findings)
{
    SampledMotion motion;
    motion.interval =
        (table.rows.back().time - table.rows.front().time) / static_cast<double>(table.rows.size() - 1);
    for (const TimeRow& row : table.rows) motion.accelerations.push_back(unit.value * row.value);
    const auto refuse = [&](std::size_t row, const std::string& what_is_wrong, const std::string& expected) {
        findings.keep_text(file, text);
        findings.add(error_at(SourcePlace{file, table.lines[row], 1, 1}, "record", what_is_wrong, expected));
        return std::nullopt;
    };
    if (motion.interval > longest_interval)
        return refuse(
            1, "an interval of " + number_text(motion.interval) + " s is not that of an earthquake's record",
            "at most " + number_text(longest_interval) + " s");
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        if (!(std::abs(motion.accelerations[k]) <= largest_acceleration))
            return refuse(k,
                          "no earthquake has an acceleration of " + number_text(table.rows[k].value) + ' ' +
                              unit.name,
                          allowed_accelerations);
    }
    return motion;
}

/// Two columns: time [s], and acceleration in the unit of the header or of the user.
std::optional<MotionRecord> read_columns(const std::filesystem::path& file, const std::string& text,
                                         const SourcePlace& place, const StatedUnit& unit,
                                         Diagnostics& findings)
{
    TimeTable table;
    std::string what = parse_time_table(text, table);
    if (what.empty()) what = check_spacing(table);
    if (!what.empty()) {
        findings.add(
            error_at(place, "motion", "'" + file.string() + "': " + what,
                     "a record in PEER's AT2 form, or rows `time_s, acceleration` at equal intervals "
                     "with at most one header line"));
        return std::nullopt;
    }
    if (const std::string other = foreign_unit_of_time(table.header); !other.empty()) {
        findings.add(error_at(place, "motion",
                              "the header of '" + file.string() + "' says that its times are in " + other,
                              "times in s", "convert them, and name s in the header"));
        return std::nullopt;
    }
    if (const std::string other = unknown_unit_of_column(table.header); !other.empty()) {
        findings.add(error_at(place, "motion",
                              "the header of '" + file.string() + "' says " + other +
                                  ", which is no acceleration in a unit that is known",
                              "g, m/s2, cm/s2 or Gal",
                              "convert the numbers, or name the column as acc [m/s2]"));
        return std::nullopt;
    }
    const auto stated = unit_of_column(table.header);
    if (!stated && unit.word.empty()) {
        findings.add(error_at(place, "missing-key",
                              "'" + file.string() + "' does not state the unit of its accelerations",
                              unit.forms));
        return std::nullopt;
    }
    if (stated && !agrees(unit, stated->value, stated->name, file, findings)) return std::nullopt;
    const RecordUnit of_values = stated ? *stated : RecordUnit{unit.word, unit_of(unit.word)};
    auto motion = motion_of(table, of_values, file, text, findings);
    if (!motion) return std::nullopt;
    return MotionRecord{std::move(*motion), stated ? "the header says " + stated->name
                                                   : unit.key + " says what the numbers stand for"};
}

/// In PEER's form.
std::optional<MotionRecord> read_stated(const std::filesystem::path& file, const std::string& text,
                                        const StatedUnit& unit, Diagnostics& findings)
{
    auto record = parse_peer_record(file, text, findings);
    if (!record || !agrees(unit, record->unit, record->unit_name, file, findings)) return std::nullopt;
    return MotionRecord{{record->interval, std::move(record->accelerations)},
                        "the header says UNITS OF " + record->unit_name +
                            ": are the values in another unit, as cm/s2?"};
}

} // namespace

std::optional<MotionRecord> read_motion_record(const std::filesystem::path& file, const SourcePlace& place,
                                               const StatedUnit& unit, Diagnostics& findings)
{
    const auto text = read_text_file(file, place, findings);
    if (!text) return std::nullopt;
    if (is_peer_record(file, *text)) return read_stated(file, *text, unit, findings);
    return read_columns(file, *text, place, unit, findings);
}

std::vector<RecordDoubt> doubt_record(const SampledMotion& motion, const std::string& unit_hint, double field)
{
    std::vector<RecordDoubt> doubts;
    const auto in_g = [](double acceleration) {
        return fmt::format("{:.4g} g", acceleration / standard_gravity);
    };
    double peak = 0.0; // [m/s2]
    for (const double acceleration : motion.accelerations) peak = std::max(peak, std::abs(acceleration));
    if (peak > field * usual_acceleration)
        doubts.push_back({"the record's peak of " + in_g(peak) + " is unusually large",
                          "usually at most " + in_g(field * usual_acceleration), unit_hint});
    if (motion.interval > usual_interval / field)
        doubts.push_back({"the record's interval of " + number_text(motion.interval) + " s is unusually long",
                          "usually at most " + quantity_text(usual_interval / field, Dimension::none) + " s",
                          "between two values the acceleration goes along a straight line"});
    return doubts;
}

} // namespace quicksand
