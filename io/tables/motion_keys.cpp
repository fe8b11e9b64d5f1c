#include "io/tables/motion_keys.hpp"

namespace quicksand {

std::vector<SceneKey> motion_keys()
{
    using enum ValueType;
    constexpr Interval positive{.lower = 0.0, .lower_open = true};
    constexpr Interval not_negative{.lower = 0.0};
    const Condition sine_only{"kind", {"sine"}};
    const Condition file_only{"kind", {"file"}};
    // One row, one key: the formatter would make it ten lines.
    // clang-format off
    return {
        {.pattern = "motion", .type = table,
         .doc = "Horizontal acceleration of the base; with a viscous base that of the rock's outcrop."},
        {.pattern = "motion.kind", .type = word, .default_value = "none", .words = {"none", "sine", "file"},
         .doc = "No shaking, a sine wave, or a record."},
        {.pattern = "motion.amplitude", .dimension = Dimension::acceleration, .required = true,
         .allowed = positive,
         .plausible = {0.01, 1000.0}, .when = sine_only, .doc = "Peak acceleration of the sine wave."},
        {.pattern = "motion.frequency", .dimension = Dimension::frequency, .required = true,
         .allowed = positive,
         .plausible = {0.05, 500.0}, .when = sine_only, .doc = "Frequency of the sine wave."},
        {.pattern = "motion.cycles", .default_note = "without end", .allowed = positive, .when = sine_only,
         .doc = "Number of cycles."},
        {.pattern = "motion.ramp_cycles", .default_value = 0.0, .allowed = not_negative, .when = sine_only,
         .doc = "Cycles over which the amplitude rises from zero."},
        {.pattern = "motion.ramp_down_cycles", .default_value = 0.0, .allowed = not_negative, .when = sine_only,
         .doc = "Last of the cycles, over which the amplitude falls to zero; without them the base keeps moving at a/omega."},
        {.pattern = "motion.file", .type = path, .required = true, .when = file_only,
         .doc = "A record in PEER's AT2 form, or two columns, time in s and acceleration, at equal intervals. "
                "The motion begins with the first value. "
                "Values beyond 1000 g and intervals beyond 10 s are refused."},
        {.pattern = "motion.unit", .type = word, .default_note = "that of the record; required of two columns whose header states none",
         .words = {"m/s2", "g"}, .when = file_only,
         .doc = "Unit of the record's accelerations; a record that states another one, in a header as `acceleration [g]` or `acc_cm_s2`, is refused."},
        {.pattern = "motion.baseline", .type = word, .default_value = "none", .words = {"none", "linear"},
         .when = file_only,
         .doc = "Take off the straight line that fits the accelerations best, or leave the record as it is."},
        {.pattern = "motion.scale", .default_value = 1.0, .plausible = {-10.0, 10.0}, .when = file_only,
         .doc = "Factor on the record's accelerations."},
    };
    // clang-format on
}

} // namespace quicksand
