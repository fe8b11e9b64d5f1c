#include "io/tables/scene_motion.hpp"

#include "io/keys/scene_text.hpp"
#include "io/motions/peer_record.hpp"
#include "io/motions/record_limits.hpp"
#include "io/motions/time_table.hpp"
#include "solver/problem/motion_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace quicksand {

namespace {

// Times printed with few digits are not exactly equidistant: this part of the interval is forgiven.
constexpr double spacing_tolerance = 0.01;

/// What is wrong with the times, "" when they are equally spaced.
std::string check_spacing(const TimeTable& table)
{
    const std::vector<TimeRow>& rows = table.rows;
    if (std::string what = check_times(table); !what.empty()) return what;
    const double interval = (rows.back().time - rows.front().time) / static_cast<double>(rows.size() - 1);
    const auto step = [&](std::size_t k) { return rows[k].time - rows[k - 1].time; };
    const auto text = [&](std::size_t k) {
        return number_text(std::round(step(k) * 1e9) * 1e-9) + " s (line " + std::to_string(table.lines[k]) +
               ")";
    };
    std::size_t shortest = 1, longest = 1;
    bool even = true;
    for (std::size_t k = 1; k < rows.size(); ++k) {
        if (step(k) < step(shortest)) shortest = k;
        if (step(k) > step(longest)) longest = k;
        const double expected = rows.front().time + static_cast<double>(k) * interval;
        even = even && std::abs(rows[k].time - expected) <= spacing_tolerance * interval;
    }
    return even ? "" : "its time steps are between " + text(shortest) + " and " + text(longest);
}

void check_shaking(const SceneValues& values, const BaseMotion& motion, Diagnostics& findings)
{
    const double end_time = values.number("run.end_time"), shaking = duration(motion);
    if (end_time > 0.0 && std::isfinite(shaking) && shaking > end_time * (1.0 + 1e-9)) {
        findings.add(warning_at(values.place("run.end_time"), "run.end_time", "motion",
                                "the run ends at " + number_text(end_time) + " s, the shaking at " +
                                    number_text(shaking) + " s"));
    }
}

/// A sine wave whose amplitude falls linearly over its last cycles, as a record that resolves it.
SampledMotion falling(const SineMotion& sine, double ramp_down_cycles)
{
    constexpr double samples_per_cycle = 200.0; // as resolving_step() asks for
    SampledMotion record;
    record.interval = 1.0 / (samples_per_cycle * sine.frequency);
    const auto samples = static_cast<std::size_t>(std::ceil(samples_per_cycle * sine.cycles - 1e-9));
    for (std::size_t k = 0; k <= samples; ++k) {
        const double time = static_cast<double>(k) * record.interval;
        const double left = (sine.cycles - time * sine.frequency) / ramp_down_cycles;
        record.accelerations.push_back(std::clamp(left, 0.0, 1.0) * base_acceleration(sine, time));
    }
    return record;
}

/// With its last cycles falling, where the scene asks for it.
BaseMotion with_fall(const SineMotion& sine, const SceneValues& values, Diagnostics& findings)
{
    const double fall = values.number("motion.ramp_down_cycles");
    if (!(fall > 0.0)) return sine;
    const SourcePlace place = values.place("motion.ramp_down_cycles");
    if (!std::isfinite(sine.cycles)) {
        findings.add(error_at(place, "conflict", "motion.ramp_down_cycles needs an end of the sine wave",
                              "motion.cycles beside it", "cycles = 20, for example"));
        return sine;
    }
    if (sine.ramp_cycles + fall > sine.cycles) {
        findings.add(error_at(place, "range",
                              "the amplitude rises over " + number_text(sine.ramp_cycles) +
                                  " and falls over " + number_text(fall) + " of only " +
                                  number_text(sine.cycles) + " cycles",
                              "ramp_cycles + ramp_down_cycles at most cycles"));
        return sine;
    }
    return falling(sine, fall);
}

BaseMotion read_sine(const SceneValues& values, Diagnostics& findings)
{
    SineMotion sine;
    sine.amplitude = values.number("motion.amplitude");
    sine.frequency = values.number("motion.frequency");
    sine.cycles = values.find<double>("motion.cycles").value_or(std::numeric_limits<double>::infinity());
    sine.ramp_cycles = values.number("motion.ramp_cycles");
    if (sine.ramp_cycles > sine.cycles) {
        findings.add(warning_at(values.place("motion.ramp_cycles"), "motion.ramp_cycles", "motion",
                                "the amplitude rises over " + number_text(sine.ramp_cycles) +
                                    " cycles but there are only " + number_text(sine.cycles)));
    }
    return with_fall(sine, values, findings);
}

/// The factor on the values of two columns; none, and a finding, where the scene does not state it.
std::optional<double> stated_unit(const SceneValues& values, const std::filesystem::path& file,
                                  Diagnostics& findings)
{
    const std::string unit = values.text("motion.unit");
    if (!unit.empty()) return unit == "g" ? standard_gravity : 1.0;
    if (!values.written.contains("motion.unit")) {
        findings.add(error_at(values.place("motion.file"), "missing-key",
                              "'" + file.string() + "' does not state the unit of its accelerations",
                              "motion.unit = \"g\" or \"m/s2\""));
    }
    return std::nullopt;
}

/// Two columns: time [s], and acceleration in `unit` [m/s2].
std::optional<SampledMotion> parse_columns(const std::filesystem::path& file, const std::string& text,
                                           double unit, const SourcePlace& place, Diagnostics& findings)
{
    TimeTable table;
    std::string what = parse_time_table(text, table);
    if (what.empty()) what = check_spacing(table);
    if (!what.empty()) {
        findings.add(
            error_at(place, "motion", "'" + file.string() + "': " + what,
                     "a record in PEER's AT2 form, or rows `time_s, acceleration` at equal intervals "
                     "from time 0 with at most one header line"));
        return std::nullopt;
    }
    SampledMotion motion;
    motion.interval =
        (table.rows.back().time - table.rows.front().time) / static_cast<double>(table.rows.size() - 1);
    for (const TimeRow& row : table.rows) motion.accelerations.push_back(unit * row.value);
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
                          "no earthquake has an acceleration of " + number_text(table.rows[k].value) +
                              (unit == 1.0 ? " m/s2" : " g"),
                          allowed_accelerations);
    }
    return motion;
}

/// A record in PEER's form; a unit that the scene states must be the record's own.
std::optional<SampledMotion> parse_stated(const SceneValues& values, const std::filesystem::path& file,
                                          const std::string& text, Diagnostics& findings)
{
    auto record = parse_peer_record(file, text, findings);
    if (!record) return std::nullopt;
    const std::string unit = values.text("motion.unit");
    if (!unit.empty() && (unit == "g" ? standard_gravity : 1.0) != record->unit) {
        findings.add(error_at(values.place("motion.unit"), "motion",
                              "the header of '" + file.string() + "' says " + record->unit_name, "",
                              "leave motion.unit out"));
        return std::nullopt;
    }
    return SampledMotion{record->interval, std::move(record->accelerations)};
}

/// Warn of what is no record of an earthquake in all likelihood, though it can be run.
void check_plausibility(const SceneValues& values, const SampledMotion& record, Diagnostics& findings)
{
    const double field = std::max(1.0, values.number("gravity.acceleration") / standard_gravity); // [g]
    const auto warn = [&](const std::string& what, const std::string& expected, const std::string& hint) {
        findings.add(
            warning_at(values.place("motion.file"), "motion.file", "plausibility", what, expected, hint));
    };
    const auto in_g = [](double acceleration) {
        return quantity_text(acceleration / standard_gravity, Dimension::none) + " g";
    };
    double peak = 0.0; // [m/s2]
    for (const double acceleration : record.accelerations) peak = std::max(peak, std::abs(acceleration));
    if (peak > field * usual_acceleration)
        warn("the record's peak of " + in_g(peak) + " is unusually large",
             "usually at most " + in_g(field * usual_acceleration),
             "motion.unit and motion.scale say what the numbers stand for");
    if (record.interval > usual_interval / field)
        warn("the record's interval of " + number_text(record.interval) + " s is unusually long",
             "usually at most " + quantity_text(usual_interval / field, Dimension::none) + " s",
             "between two values the acceleration goes along a straight line");
}

std::optional<SampledMotion> read_record(const SceneValues& values, const std::filesystem::path& file,
                                         Diagnostics& findings)
{
    const SourcePlace place = values.place("motion.file");
    const auto text = read_text_file(file, place, findings);
    if (!text) return std::nullopt;
    std::optional<SampledMotion> motion;
    if (is_peer_record(file, *text)) {
        motion = parse_stated(values, file, *text, findings);
    } else if (const auto unit = stated_unit(values, file, findings)) {
        motion = parse_columns(file, *text, *unit, place, findings);
    }
    if (!motion) return std::nullopt;
    const double scale = values.find<double>("motion.scale").value_or(1.0);
    for (double& acceleration : motion->accelerations) acceleration *= scale;
    if (values.text("motion.baseline") == "linear") *motion = without_linear_baseline(std::move(*motion));
    check_plausibility(values, *motion, findings);
    return motion;
}

} // namespace

BaseMotion read_motion(const SceneValues& values, const std::filesystem::path& folder, Diagnostics& findings)
{
    const std::string kind = values.text("motion.kind");
    BaseMotion motion;
    if (kind == "sine") motion = read_sine(values, findings);
    if (kind == "file" && values.has("motion.file")) {
        auto record = read_record(values, folder / values.text("motion.file"), findings);
        if (record) motion = std::move(*record);
    }
    check_shaking(values, motion, findings);
    return motion;
}

} // namespace quicksand
