#include "io/element/element_keys.hpp"

#include "io/laws/soil_laws.hpp"

namespace quicksand {

namespace {

using enum ValueType;

constexpr Interval positive{.lower = 0.0, .lower_open = true};

constexpr std::string_view stress_cycles = "cyclic_shear_stress_controlled";
constexpr std::string_view strain_cycles = "cyclic_shear_strain_controlled";
constexpr std::string_view reconsolidation = "reconsolidation";
constexpr std::string_view monotonic_shear = "monotonic_shear";
constexpr std::string_view biaxial_compression = "biaxial_compression";
constexpr std::string_view oedometer_compression = "oedometer";
constexpr std::string_view isotropic_compression = "isotropic_compression";

const Condition stress_controlled{"kind", {stress_cycles}};
const Condition strain_controlled{"kind", {strain_cycles, reconsolidation}};
const Condition with_cycles{"kind", {stress_cycles, strain_cycles, reconsolidation}};
const Condition compressed{"kind", {oedometer_compression, isotropic_compression}};

std::vector<std::string_view> law_words()
{
    std::vector<std::string_view> words;
    for (const SoilLaw& law : soil_laws()) words.push_back(law.word);
    return words;
}

// One row, one key: the formatter would make it ten lines.
// clang-format off

std::vector<SceneKey> head_keys()
{
    return {
        {.pattern = "test_version", .type = integer, .required = true, .allowed = {1.0, 1.0},
         .doc = "Version of the format of element tests: 1."},
        {.pattern = "title", .type = text, .default_value = "", .doc = "One line, the heading of the reports."},
        {.pattern = "accept", .type = text_list, .default_value = std::vector<std::string>{},
         .doc = "Keys whose warnings you have read and accept, as [\"tests.strength.k0\"]."},
        {.pattern = "materials", .type = named_tables, .required = true, .doc = "The soils, with the keys of a scene."},
        {.pattern = "materials.*", .type = table, .doc = "One soil, under a name of your choice."},
        {.pattern = "materials.*.model", .type = word, .required = true, .words = law_words(),
         .doc = "Stress-strain law of the grain skeleton."},
    };
}

std::vector<SceneKey> specimen_keys()
{
    return {
        {.pattern = "tests", .type = named_tables, .required = true, .doc = "The tests, each with a folder of results."},
        {.pattern = "tests.*", .type = table, .doc = "One test, or a series of them, under a name of your choice."},
        {.pattern = "tests.*.kind", .type = word, .required = true,
         .words = {stress_cycles, strain_cycles, reconsolidation, monotonic_shear, biaxial_compression, oedometer_compression, isotropic_compression},
         .doc = "Simple shear (cyclic or monotonic), drainage after cyclic shear, plane-strain compression, or compression without shear."},
        {.pattern = "tests.*.material", .type = text, .default_note = "the only material",
         .doc = "Name of a material."},
        {.pattern = "tests.*.vertical_stress", .dimension = Dimension::pressure, .default_value = 100e3,
         .allowed = positive, .plausible = {5e3, 3e6}, .doc = "sigma'_v0, to which the specimen is consolidated."},
        {.pattern = "tests.*.k0", .default_value = 0.5, .allowed = positive, .plausible = {0.3, 2.0},
         .when = {"kind", {stress_cycles, strain_cycles, reconsolidation, monotonic_shear, biaxial_compression, oedometer_compression}},
         .doc = "Horizontal over vertical effective stress after consolidation."},
        {.pattern = "tests.*.static_shear_ratio", .default_value = 0.0, .allowed = {-1.0, 1.0}, .plausible = {-0.4, 0.4},
         .when = {"kind", {stress_cycles, monotonic_shear}},
         .doc = "Static shear stress over sigma'_v0 before the loading, as below a slope."},
    };
}

std::vector<SceneKey> loading_keys()
{
    return {
        {.pattern = "tests.*.csr", .type = number_list, .required = true, .allowed = positive, .plausible = {0.02, 1.0},
         .when = stress_controlled,
         .doc = "Cyclic stress ratios: amplitude of the shear stress over sigma'_v0, one test each."},
        {.pattern = "tests.*.shear_strains", .type = number_list, .required = true, .allowed = positive,
         .plausible = {1e-6, 0.1}, .caution = "0.01 is 1 %",
         .when = strain_controlled, .doc = "Amplitudes of the shear strain, one test each."},
        {.pattern = "tests.*.cycles", .default_value = 100.0, .allowed = {0.5, 10'000.0}, .plausible = {1.0, 1000.0},
         .when = with_cycles, .doc = "Cycles after which a test ends."},
        {.pattern = "tests.*.cycles_after_liquefaction", .default_value = 5.0, .allowed = {.lower = 0.0},
         .when = stress_controlled, .doc = "Cycles for which a test goes on after ru = 0.95."},
        {.pattern = "tests.*.drainage", .type = word, .default_value = "undrained", .words = {"undrained", "drained"},
         .when = {"kind", {strain_cycles, monotonic_shear, biaxial_compression}},
         .doc = "At constant volume; or at constant vertical stress (shear) or cell pressure (compression)."},
        {.pattern = "tests.*.largest_shear_strain", .default_value = 0.1, .allowed = {.lower = 0.0, .upper = 10.0, .lower_open = true},
         .plausible = {0.001, 1.0}, .when = {"kind", {stress_cycles, monotonic_shear}}, .doc = "Shear strain at which a test ends."},
        {.pattern = "tests.*.largest_vertical_strain", .default_value = 0.1, .allowed = {.lower = 0.0, .upper = 1.0, .lower_open = true},
         .plausible = {0.001, 0.5}, .when = {"kind", {biaxial_compression}}, .doc = "Vertical strain at which a test ends."},
        {.pattern = "tests.*.stresses", .type = number_list, .dimension = Dimension::pressure, .required = true,
         .allowed = positive, .plausible = {1e3, 1e7}, .when = compressed,
         .doc = "Vertical (oedometer) or mean (isotropic) effective stresses to go to in turn, up or down."},
    };
}

std::vector<SceneKey> comparison_keys()
{
    return {
        {.pattern = "tests.*.vary", .type = text, .default_note = "nothing is varied",
         .doc = "A number of the material or of the test, as \"n1_60\" or \"k0\", which takes the values one by one."},
        {.pattern = "tests.*.values", .type = quantity_list, .default_note = "none",
         .doc = "Values of the key that is varied; the curves are labelled by them."},
        {.pattern = "tests.*.criterion", .type = word, .default_value = "ru_95",
         .words = {"ru_95", "strain_3_percent", "strain_3.75_percent", "double_7.5_percent"}, .when = stress_controlled,
         .doc = "Criterion of liquefaction in the picture of CSR over cycles: ru, single-amplitude shear strain, or that from one reversal to the next."},
        {.pattern = "tests.*.data", .type = path, .default_note = "no points are drawn", .when = stress_controlled,
         .doc = "CSV file with your own points: columns CSR and N, and if you like the key that is varied."},
        {.pattern = "tests.*.data_label", .type = text, .default_note = "the name of the file", .when = stress_controlled,
         .doc = "Name of the points in the picture."},
    };
}

// clang-format on

} // namespace

const KeyTable& element_key_table()
{
    static const KeyTable table = [] {
        KeyTable keys = {"test file", "test_version", "Keys of element tests", {}, {}};
        for (const auto& part :
             {head_keys(), element_law_keys(), specimen_keys(), loading_keys(), comparison_keys()}) {
            keys.keys.insert(keys.keys.end(), part.begin(), part.end());
        }
        return keys;
    }();
    return table;
}

} // namespace quicksand
