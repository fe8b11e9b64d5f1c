#include "io/sweeps/sweep_keys.hpp"

namespace quicksand {

namespace {

using enum ValueType;

const Condition with_mean{"distribution", {"normal", "lognormal"}};
const Condition with_limits{"distribution", {"uniform"}};

// One row, one key: the formatter would make it ten lines.
// clang-format off

std::vector<SceneKey> sweep_keys()
{
    return {
        {.pattern = "sweep_version", .type = integer, .required = true, .allowed = {1.0, 1.0},
         .doc = "Version of the format of sweeps: 1."},
        {.pattern = "title", .type = text, .default_value = "", .doc = "One line, the heading of the pictures."},
        {.pattern = "scene", .type = path, .required = true,
         .doc = "Scene, or a folder that holds scene.toml, relative to the sweep's file."},
        {.pattern = "set", .type = text_list, .default_value = std::vector<std::string>{},
         .doc = "Keys that all runs replace, as after --set: [\"run.end_time=0.02\"]."},
        {.pattern = "samples", .type = integer, .default_note = "nothing is random", .allowed = {1.0, 100'000.0},
         .doc = "How often the keys with a distribution are drawn, all at once."},
        {.pattern = "seed", .type = integer, .default_value = std::int64_t{1}, .allowed = {.lower = 0.0},
         .doc = "Of the random numbers: the same seed gives the same values on every machine."},
        {.pattern = "vary", .type = named_tables, .required = true,
         .doc = "The keys that differ from run to run, each as [vary.\"motion.amplitude\"]; lists give their product."},
        {.pattern = "vary.*", .type = table, .doc = "A key of the scene, in quotes, as after --set."},
        {.pattern = "vary.*.distribution", .type = word, .default_value = "list", .words = {"list", "normal", "lognormal", "uniform"},
         .doc = "Whether the key takes the values of a list or is drawn at random."},
        {.pattern = "vary.*.values", .type = value_list, .required = true, .when = {"distribution", {"list"}},
         .doc = "The values, as after --set: numbers, quantities in quotes, words, file names relative to the scene."},
        {.pattern = "vary.*.mean", .type = quantity, .required = true, .when = with_mean,
         .doc = "Mean of the key itself, of lognormal keys too."},
        {.pattern = "vary.*.deviation", .type = quantity, .required = true, .when = with_mean,
         .doc = "Standard deviation of the key itself, of lognormal keys too; in the unit of the mean."},
        {.pattern = "vary.*.low", .type = quantity, .required = true, .when = with_limits, .doc = "Lower limit."},
        {.pattern = "vary.*.high", .type = quantity, .required = true, .when = with_limits,
         .doc = "Upper limit, in the unit of the lower one."},
        {.pattern = "fragility", .type = table, .default_note = "no curve", .doc = "How often a quantity is above a threshold, over an intensity: a lognormal curve."},
        {.pattern = "fragility.quantity", .type = text, .required = true,
         .doc = "Column of sweep.csv without _peak, as \"crest_settlement_m\" or \"upper.ux_m\"; with _final its last value."},
        {.pattern = "fragility.threshold", .required = true, .allowed = {.lower = 0.0},
         .doc = "In the unit of the column; the quantity counts in amount."},
        {.pattern = "fragility.intensity", .type = text, .default_note = "motion.amplitude or motion.scale",
         .doc = "The varied key of the horizontal axis; its values must be above 0."},
    };
}

// clang-format on

} // namespace

const KeyTable& sweep_key_table()
{
    static const KeyTable table{"sweep", "sweep_version", "Keys of sweeps", sweep_keys(), {}};
    return table;
}

} // namespace quicksand
