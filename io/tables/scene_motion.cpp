#include "io/tables/scene_motion.hpp"

#include "io/motions/motion_record.hpp"
#include "solver/problem/motion_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace quicksand {

namespace {

void check_shaking(const SceneValues& values, const BaseMotion& motion, Diagnostics& findings)
{
    if (findings.has_errors()) return; // the end of the run may be what is wrong
    const bool is_given = values.has("run.end_time");
    const double end_time = values.number("run.end_time"), shaking = duration(motion);
    if (end_time > 0.0 && std::isfinite(shaking) && shaking > end_time * (1.0 + 1e-9)) {
        findings.add(warning_at(
            is_given ? values.place("run.end_time") : values.tables.at("motion"), "run.end_time", "motion",
            "the run ends at " + number_text(end_time) + " s, the shaking at " + time_text(shaking)));
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

/// Warn of what is no record of an earthquake in all likelihood, though it can be run.
void check_plausibility(const SceneValues& values, const SampledMotion& motion, const std::string& unit_hint,
                        Diagnostics& findings)
{
    const double field = std::max(1.0, values.number("gravity.acceleration") / standard_gravity); // [g]
    for (const RecordDoubt& doubt : doubt_record(motion, unit_hint, field))
        findings.add(warning_at(values.place("motion.file"), "motion.file", "plausibility", doubt.what,
                                doubt.expected, doubt.hint));
}

std::optional<SampledMotion> read_record(const SceneValues& values, const std::filesystem::path& file,
                                         Diagnostics& findings)
{
    const StatedUnit unit{values.text("motion.unit"), "motion.unit", "motion.unit = \"g\" or \"m/s2\"",
                          values.place("motion.unit")};
    if (unit.word.empty() && values.written.contains("motion.unit")) return std::nullopt; // told already
    auto record = read_motion_record(file, values.place("motion.file"), unit, findings);
    if (!record) return std::nullopt;
    SampledMotion& motion = record->motion;
    const double scale = values.find<double>("motion.scale").value_or(1.0);
    for (double& acceleration : motion.accelerations) acceleration *= scale;
    if (values.text("motion.baseline") == "linear") motion = without_linear_baseline(std::move(motion));
    check_plausibility(values, motion, record->unit_hint, findings);
    return std::move(motion);
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
