#include "io/laws/soil_laws.hpp"

#include "io/laws/mohr_coulomb_soil.hpp"
#include "io/laws/pm4sand_soil.hpp"
#include "io/laws/ubcsand_soil.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <utility>

namespace quicksand {

namespace {

/// "linear_elastic, mohr_coulomb or ubcsand"
std::string laws_that_settle()
{
    std::vector<std::string_view> words;
    for (const SoilLaw& law : soil_laws())
        if (bears_stress_as_drawn(law.form)) words.push_back(law.word);
    const std::string_view last = words.back();
    words.pop_back();
    return fmt::format("{} or {}", fmt::join(words, ", "), last);
}

/// The settled stress would be gone with the reference that the shaking starts from.
void refuse_settling(const LawSource& source)
{
    const std::string& path = source.table.path;
    source.findings.add(
        error_at(source.values.place(path + ".model"), "conflict",
                 path + ".model = \"" + source.values.text(path + ".model") +
                     "\" cannot settle in [relaxation]: its stress follows from its deformation, and "
                     "the shaking takes the settled shape as undeformed",
                 laws_that_settle() + " beside [relaxation]",
                 "remove [relaxation]: gravity is then switched on at once"));
}

/// The dimension of a law's unit, which is an SI unit or the degree.
Dimension dimension_of(std::string_view unit)
{
    using enum Dimension;
    for (const Dimension dimension :
         {length, time, frequency, acceleration, velocity, density, pressure, angle})
        if (si_symbol(dimension) == unit) return dimension;
    ENSURE(unit == "-");
    return none;
}

std::vector<SceneKey> rows_of(const SkeletonLaw& law)
{
    static std::deque<std::string> patterns; // that the rows look at
    std::vector<SceneKey> rows;
    for (const LawKeyText& key : keys_of(law)) {
        SceneKey row;
        row.pattern = patterns.emplace_back("materials.*." + std::string(key.name));
        row.dimension = dimension_of(key.unit);
        row.required = !key.standard && key.absent.empty();
        if (key.standard) row.default_value = *key.standard;
        row.default_note = key.absent;
        row.allowed = key.allowed;
        row.plausible = key.usual;
        row.doc = key.meaning;
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<SceneKey> pm4sand_scene_keys()
{
    std::vector<SceneKey> rows = rows_of(Pm4Sand());
    rows.push_back(law_choice_key());
    return rows;
}

/// The laws that do not leave all to their keys.
std::vector<SoilLaw> particular_laws()
{
    return {
        {.form = MohrCoulomb(), .check = check_mohr_coulomb},
        {.form = make_ubcsand(calibrated(nevada_sand_55())), // which remembers all that the law can
         .keys = ubcsand_scene_keys(),
         .read = read_ubcsand,
         .describe = describe_ubcsand,
         .element_keys = ubcsand_keys(),
         .read_for_element = read_ubcsand_for_element,
         .example = example_of_ubcsand},
        {.form = Pm4Sand(),
         .keys = pm4sand_scene_keys(),
         .read = read_pm4sand,
         .describe = describe_pm4sand,
         .read_for_element = read_pm4sand_for_element,
         .example = example_of_pm4sand},
    };
}

std::vector<SoilLaw> list_laws()
{
    std::vector<SoilLaw> laws;
    for (const SkeletonLaw& form : laws_of_scenes()) {
        SoilLaw law{.form = form};
        for (const SoilLaw& particular : particular_laws())
            if (particular.form.index() == form.index()) law = particular;
        law.word = name_of(form);
        if (law.keys.empty()) law.keys = rows_of(form);
        if (law.element_keys.empty()) law.element_keys = law.keys;
        laws.push_back(std::move(law));
    }
    return laws;
}

/// The law whose members are filled by its keys.
SkeletonLaw read_keys(const SoilLaw& law, const LawSource& source)
{
    SkeletonLaw result = law.form;
    for (std::size_t k = 0; k < law.keys.size(); ++k) {
        const std::string path = source.table.path + "." + std::string(last_part(law.keys[k].pattern));
        if (const auto value = source.values.find<double>(path)) set_value(result, k, *value);
    }
    return result;
}

/// The rows of all laws, of which `rows` is a member.
std::vector<SceneKey> keys_of_laws(std::vector<SceneKey> SoilLaw::*rows)
{
    std::vector<SceneKey> keys;
    for (const SoilLaw& law : soil_laws()) {
        for (SceneKey key : law.*rows) {
            const auto known = std::find_if(keys.begin(), keys.end(), [&](const SceneKey& other) {
                return other.pattern == key.pattern;
            });
            if (known == keys.end()) {
                key.when = {"model", {law.word}};
                keys.push_back(std::move(key));
                continue;
            }
            ENSURE(known->type == key.type && known->dimension == key.dimension &&
                   known->required == key.required);
            known->when.words.push_back(law.word);
        }
    }
    return keys;
}

/// The number that a scene gave, of which a change of unit has moved the last digits.
double without_rounding(double value)
{
    return std::isfinite(value) ? std::stod(fmt::format("{:.12g}", value)) : value;
}

/// "shear_modulus = 10 MPa, poisson_ratio = 0.3", without what has no value or no effect in element tests.
std::string numbers_of(const SkeletonLaw& law)
{
    const std::vector<LawKeyText> keys = keys_of(law);
    std::vector<std::string> numbers;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const double value = without_rounding(value_of(law, k));
        if (std::isfinite(value) && !keys[k].hangs_on_time)
            numbers.push_back(
                fmt::format("{} = {}", keys[k].name, quantity_text(value, dimension_of(keys[k].unit))));
    }
    return fmt::format("{}", fmt::join(numbers, ", "));
}

} // namespace

std::string laws_with_strength()
{
    std::string words;
    for (const SoilLaw& law : soil_laws())
        if (has_strength(law.form)) words += fmt::format("{}\"{}\"", words.empty() ? "" : " or ", law.word);
    return words;
}

bool lacks_reconsolidation(const SkeletonLaw& law)
{
    const auto* ubcsand = std::get_if<UbcSand>(&law);
    const auto* pm4sand = std::get_if<Pm4Sand>(&law);
    return (ubcsand != nullptr && reconsolidation_slope(*ubcsand) == 0.0) ||
           (pm4sand != nullptr && reconsolidation_slope(*pm4sand) == 0.0 && pm4sand->reconsolidation == 0.0);
}

bool has_post_shaking_option(const SkeletonLaw& law)
{
    const auto* pm4sand = std::get_if<Pm4Sand>(&law);
    return pm4sand != nullptr && pm4sand->reconsolidation > 0.0;
}

std::span<const SoilLaw> soil_laws()
{
    static const std::vector<SoilLaw> laws = list_laws();
    return laws;
}

std::vector<SceneKey> soil_law_keys()
{
    return keys_of_laws(&SoilLaw::keys);
}

std::vector<SceneKey> element_law_keys()
{
    return keys_of_laws(&SoilLaw::element_keys);
}

const SoilLaw& soil_law(std::string_view word)
{
    const auto laws = soil_laws();
    const auto found =
        std::find_if(laws.begin(), laws.end(), [&](const SoilLaw& law) { return law.word == word; });
    return found == laws.end() ? laws.front() : *found;
}

const SoilLaw& soil_law(const SkeletonLaw& form)
{
    const auto laws = soil_laws();
    const auto found = std::find_if(laws.begin(), laws.end(),
                                    [&](const SoilLaw& law) { return law.form.index() == form.index(); });
    ENSURE(found != laws.end());
    return *found;
}

SkeletonLaw read_soil_law(const LawSource& source)
{
    const SoilLaw& law = soil_law(source.values.text(source.table.path + ".model"));
    if (!bears_stress_as_drawn(law.form) && source.values.has_table("relaxation")) refuse_settling(source);
    if (law.check != nullptr) law.check(source);
    return law.read != nullptr ? law.read(source) : read_keys(law, source);
}

DescribedLaw read_element_law(const LawSource& source)
{
    const SoilLaw& law = soil_law(source.values.text(source.table.path + ".model"));
    if (law.check != nullptr) law.check(source);
    if (law.read_for_element != nullptr) return law.read_for_element(source);
    const SkeletonLaw read = read_keys(law, source);
    return {read, std::string(law.word), "", "", numbers_of(read)};
}

SkeletonLaw example_of(const SoilLaw& law)
{
    if (law.example != nullptr) return law.example();
    SkeletonLaw example = law.form;
    const std::vector<LawKeyText> keys = keys_of(law.form);
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const Interval& usual = keys[k].usual;
        const bool required = !keys[k].standard && keys[k].absent.empty();
        const double middle =
            usual.lower > 0.0 ? std::sqrt(usual.lower * usual.upper) : 0.5 * (usual.lower + usual.upper);
        if (required) set_value(example, k, middle);
        if (keys[k].standard) set_value(example, k, *keys[k].standard);
    }
    return example;
}

} // namespace quicksand
