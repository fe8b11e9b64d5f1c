#include "io/scene_motion.hpp"

#include "io/scene_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace quicksand {

namespace {

// Times printed with few digits are not exactly equidistant: this part of the interval is forgiven.
constexpr double spacing_tolerance = 0.01;

struct Row {
    double time = 0.0;         // [s]
    double acceleration = 0.0; // as in the file
};

std::optional<double> take_number(std::string_view& text)
{
    const auto skip = [&](std::string_view skipped) {
        while (!text.empty() && skipped.find(text.front()) != std::string_view::npos) text.remove_prefix(1);
    };
    skip(" \t");
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    skip(" \t");
    return value;
}

/// A row of exactly two numbers, separated by a comma, a semicolon or blanks.
std::optional<Row> parse_row(std::string_view line)
{
    const auto time = take_number(line);
    if (!time) return std::nullopt;
    if (!line.empty() && (line.front() == ',' || line.front() == ';')) line.remove_prefix(1);
    const auto acceleration = take_number(line);
    if (!acceleration || !line.empty()) return std::nullopt;
    return Row{*time, *acceleration};
}

/// The rows, with the line number of each; an empty result and a message where a row is none.
std::string parse_rows(std::string_view text, std::vector<Row>& rows, std::vector<int>& lines)
{
    int number = 0;
    bool header_allowed = true;
    while (!text.empty()) {
        const auto end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
        ++number;
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.find_first_not_of(" \t") == std::string_view::npos || line.starts_with('#')) continue;
        const auto row = parse_row(line);
        if (row) {
            rows.push_back(*row);
            lines.push_back(number);
        } else if (!header_allowed) {
            return "line " + std::to_string(number) +
                   " is not two numbers: " + std::string(line.substr(0, 60));
        }
        header_allowed = false;
    }
    return rows.size() < 2 ? "it holds fewer than two rows of two numbers" : "";
}

/// What is wrong with the times, "" when they are equally spaced.
std::string check_spacing(const std::vector<Row>& rows, const std::vector<int>& lines)
{
    const double interval = (rows.back().time - rows.front().time) / static_cast<double>(rows.size() - 1);
    if (std::abs(rows.front().time) > spacing_tolerance * std::abs(interval)) {
        return "its time starts at " + number_text(rows.front().time) + " s, not at 0";
    }
    const auto step = [&](std::size_t k) { return rows[k].time - rows[k - 1].time; };
    const auto text = [&](std::size_t k) {
        return number_text(std::round(step(k) * 1e9) * 1e-9) + " s (line " + std::to_string(lines[k]) + ")";
    };
    std::size_t shortest = 1, longest = 1;
    bool even = true;
    for (std::size_t k = 1; k < rows.size(); ++k) {
        if (!(step(k) > 0.0)) return "its time does not increase at line " + std::to_string(lines[k]);
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
    return sine;
}

} // namespace

std::optional<SampledMotion> read_motion_record(const std::filesystem::path& file, double factor,
                                                const SourcePlace& place, Diagnostics& findings)
{
    const auto text = read_text_file(file, place, findings);
    if (!text) return std::nullopt;
    std::vector<Row> rows;
    std::vector<int> lines;
    std::string what = parse_rows(*text, rows, lines);
    if (what.empty()) what = check_spacing(rows, lines);
    if (!what.empty()) {
        findings.add(
            error_at(place, "motion", "'" + file.string() + "': " + what,
                     "rows `time_s, acceleration` at equal intervals from time 0, at most one header line"));
        return std::nullopt;
    }
    SampledMotion motion;
    motion.interval = (rows.back().time - rows.front().time) / static_cast<double>(rows.size() - 1);
    for (const Row& row : rows) motion.accelerations.push_back(factor * row.acceleration);
    return motion;
}

BaseMotion read_motion(const SceneValues& values, const std::filesystem::path& folder, Diagnostics& findings)
{
    const std::string kind = values.text("motion.kind");
    BaseMotion motion;
    if (kind == "sine") motion = read_sine(values, findings);
    if (kind == "file" && values.has("motion.file")) {
        const double unit = values.text("motion.unit") == "g" ? standard_gravity : 1.0;
        const double factor = unit * values.find<double>("motion.scale").value_or(1.0);
        const auto record = read_motion_record(folder / values.text("motion.file"), factor,
                                               values.place("motion.file"), findings);
        if (record) motion = *record;
    }
    check_shaking(values, motion, findings);
    return motion;
}

} // namespace quicksand
