#include "io/laws/ubcsand_keys.hpp"

#include "solver/base/conventions.hpp"
#include "solver/base/failure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace quicksand {

namespace {

constexpr Interval positive{.lower = 0.0, .lower_open = true};
constexpr Interval not_negative{.lower = 0.0};
/// Mean stress in the plane over one atmosphere at which G and V_s are measured: K0 = 1/2 below 100 kPa.
constexpr double mean_of_measured_stiffness = 75e3 / atmospheric_pressure; // [-]

constexpr Interval exponent{.lower = 0.0, .upper = 1.0};
constexpr Interval friction{.lower = 0.0, .upper = 60.0, .lower_open = true, .upper_open = true};

using Parameter = double UbcSandParameters::*;

/// Those whose standard value is that of the key, or of the generic set.
constexpr std::array<std::pair<const char*, Parameter>, 18> parameters_of_keys = {{
    {"elastic_shear_number", &UbcSandParameters::elastic_shear_number},
    {"elastic_bulk_number", &UbcSandParameters::elastic_bulk_number},
    {"elastic_shear_exponent", &UbcSandParameters::elastic_shear_exponent},
    {"elastic_bulk_exponent", &UbcSandParameters::elastic_bulk_exponent},
    {"plastic_shear_number", &UbcSandParameters::plastic_shear_number},
    {"plastic_shear_exponent", &UbcSandParameters::plastic_shear_exponent},
    {"failure_ratio", &UbcSandParameters::failure_ratio},
    {"constant_volume_friction_deg", &UbcSandParameters::constant_volume_friction_deg},
    {"peak_friction_deg", &UbcSandParameters::peak_friction_deg},
    {"cohesion", &UbcSandParameters::cohesion},
    {"virgin_factor", &UbcSandParameters::virgin_factor},
    {"secondary_start", &UbcSandParameters::secondary_start},
    {"secondary_growth", &UbcSandParameters::secondary_growth},
    {"reversal_tolerance", &UbcSandParameters::reversal_tolerance},
    {"dilation_softening", &UbcSandParameters::dilation_softening},
    {"largest_ratio_step", &UbcSandParameters::largest_ratio_step},
    {"largest_stress_step", &UbcSandParameters::largest_stress_step},
    {"stress_floor", &UbcSandParameters::stress_floor},
}};

/// Those whose standard value hangs on the word of `law`.
constexpr std::array<std::pair<const char*, Parameter>, 12> parameters_of_words = {{
    {"softened_factor", &UbcSandParameters::softened_factor},
    {"secondary_factor", &UbcSandParameters::secondary_factor},
    {"confining_exponent", &UbcSandParameters::confining_exponent},
    {"lateral_exponent", &UbcSandParameters::lateral_exponent},
    {"static_shear_stiffening", &UbcSandParameters::static_shear_stiffening},
    {"least_start_ratio", &UbcSandParameters::least_start_ratio},
    {"dilation_factor", &UbcSandParameters::dilation_factor},
    {"dilation_strain", &UbcSandParameters::dilation_strain},
    {"reference_strain", &UbcSandParameters::reference_strain},
    {"least_modulus_fraction", &UbcSandParameters::least_modulus_fraction},
    {"reconsolidation_slope", &UbcSandParameters::reconsolidation_slope},
    {"liquefied_conductivity", &UbcSandParameters::liquefied_conductivity},
}};

constexpr std::array density_keys = {"n1_60", "relative_density", "preset"};

/// (N1)60 [-] of the one density that is given; what is wrong with it is reported.
std::optional<double> find_blow_count(const NamedTable& material, const SceneValues& values,
                                      Diagnostics& findings)
{
    std::vector<std::string> given;
    for (const char* key : density_keys) {
        if (values.written.contains(material.path + "." + key)) given.emplace_back(key);
    }
    const char* const choice = "one of n1_60, relative_density and preset";
    if (given.empty()) {
        findings.add(
            error_at(material.place, "missing-key", "[" + material.path + "] has no density", choice,
                     "n1_60 = 13.9, relative_density = 0.55 or preset = \"nevada_sand_dr55\" gives all "
                     "other parameters their values"));
        return std::nullopt;
    }
    for (std::size_t k = 1; k < given.size(); ++k) {
        findings.add(error_at(values.place(material.path + "." + given[k]), "conflict",
                              "[" + material.path + "] has a density already, by " + given[0], choice,
                              "remove one of the two"));
    }
    if (given[0] == "n1_60") return values.find<double>(material.path + ".n1_60");
    if (given[0] == "preset") return blow_count(nevada_relative_density);
    return blow_count(values.number(material.path + ".relative_density"));
}

/// Put the words in the place of the note in the list of resolved keys; what is given stays as written, for
/// runs are resumed by it.
void show_words(const std::string& path, const std::string& words, SceneValues& values)
{
    const auto key = std::find_if(values.keys.begin(), values.keys.end(),
                                  [&](const ResolvedKey& resolved) { return resolved.path == path; });
    if (key != values.keys.end() && !key->given) key->value = words;
}

/// The density in all three ways; they say the same.
void show_density(const std::string& material, double n1_60, SceneValues& values)
{
    show(material + ".n1_60", n1_60, values);
    show(material + ".relative_density", std::sqrt(n1_60 / blow_count(1.0)), values);
    if (!values.given(material + ".preset")) show_words(material + ".preset", "none", values);
}

/// K_G^e of the one of its keys that is given, if any; what is wrong with them is reported.
std::optional<double> find_shear_number(const NamedTable& material, const SceneValues& values,
                                        Diagnostics& findings)
{
    std::vector<std::string> given;
    for (const char* key : {"elastic_shear_number", "small_strain_shear_modulus", "shear_wave_velocity"})
        if (values.written.contains(material.path + "." + key)) given.emplace_back(key);
    if (given.empty()) return std::nullopt;
    for (std::size_t k = 1; k < given.size(); ++k) {
        findings.add(
            error_at(values.place(material.path + "." + given[k]), "conflict",
                     "[" + material.path + "] has its elastic shear stiffness already, by " + given[0],
                     "one of elastic_shear_number, small_strain_shear_modulus and shear_wave_velocity",
                     "remove one of the two"));
    }
    const auto number = values.find<double>(material.path + "." + given[0]);
    if (!number || given[0] == "elastic_shear_number") return number;
    double modulus = *number; // [Pa]
    if (given[0] == "shear_wave_velocity") {
        const double n = values.number(material.path + ".porosity");
        constexpr double water_density = 1000.0; // [kg/m3]
        modulus = ((1.0 - n) * values.number(material.path + ".grain_density") + n * water_density) *
                  *number * *number;
    }
    const double ne = values.number(material.path + ".elastic_shear_exponent");
    return modulus / (atmospheric_pressure * std::pow(mean_of_measured_stiffness, ne));
}

// clang-format off

/// The density of the sand, in three ways.
std::vector<SceneKey> density_keys_of_sand()
{
    return {
        {.pattern = "materials.*.n1_60", .default_note = "one of n1_60, relative_density, preset is required",
         .allowed = {.lower = 0.0, .upper = 50.0, .lower_open = true}, .plausible = {3.0, 35.0},
         .doc = "Clean-sand blow count (N1)60; gives the generic set of Beaty and Byrne (2011)."},
        {.pattern = "materials.*.relative_density", .default_note = "one of n1_60, relative_density, preset is required",
         .allowed = {.lower = 0.0, .upper = 1.0, .lower_open = true}, .plausible = {0.25, 0.9},
         .doc = "Relative density Dr; gives (N1)60 = 46 Dr^2 (Idriss and Boulanger 2008)."},
        {.pattern = "materials.*.preset", .type = ValueType::word,
         .default_note = "one of n1_60, relative_density, preset is required",
         .words = {"nevada_sand_dr55"},
         .doc = "A named sand: Nevada sand at Dr = 55 %, (N1)60 = 13.915."},
    };
}

/// Moduli and their dependence on the stress.
std::vector<SceneKey> stiffness_keys()
{
    const UbcSandParameters m;
    return {
        {.pattern = "materials.*.elastic_shear_number", .default_note = "434 (N1)60^(1/3)", .allowed = positive,
         .plausible = {100.0, 5000.0},
         .doc = "K_G^e: G = K_G^e Pa (s/Pa)^ne, s the in-plane mean effective stress [Beaty and Byrne 2011]."},
        {.pattern = "materials.*.small_strain_shear_modulus", .dimension = Dimension::pressure,
         .default_note = "elastic_shear_number gives it", .allowed = positive, .plausible = {1e7, 1e9},
         .doc = "G of the smallest strains at a vertical effective stress of 100 kPa and K0 = 1/2; sets elastic_shear_number."},
        {.pattern = "materials.*.elastic_bulk_number", .default_note = "0.7 elastic_shear_number", .allowed = positive,
         .plausible = {50.0, 5000.0}, .caution = "this is the drained stiffness, not the pore water's",
         .doc = "K_B^e: drained bulk modulus B = K_B^e Pa (s/Pa)^me [Beaty and Byrne 2011]."},
        {.pattern = "materials.*.elastic_shear_exponent", .default_value = m.elastic_shear_exponent, .allowed = exponent,
         .plausible = {0.3, 0.7}, .doc = "ne [Beaty and Byrne 2011]."},
        {.pattern = "materials.*.elastic_bulk_exponent", .default_value = m.elastic_bulk_exponent, .allowed = exponent,
         .plausible = {0.3, 0.7}, .doc = "me [Beaty and Byrne 2011]."},
        {.pattern = "materials.*.plastic_shear_number",
         .default_note = "0.003 elastic_shear_number (N1)60^2 + 100", .allowed = positive,
         .plausible = {50.0, 20000.0},
         .doc = "K_G^p: plastic modulus K_G^p Pa (s/Pa)^np (1 - R_f eta/eta_f)^2 [Beaty and Byrne 2011]."},
        {.pattern = "materials.*.plastic_shear_exponent", .default_value = m.plastic_shear_exponent, .allowed = exponent,
         .plausible = {0.2, 0.7}, .doc = "np [Beaty and Byrne 2011]."},
    };
}

/// The failure limit and the line between contraction and dilation.
std::vector<SceneKey> strength_keys()
{
    const UbcSandParameters m;
    return {
        {.pattern = "materials.*.failure_ratio", .default_note = "1.1 (N1)60^-0.15, at most 0.99",
         .allowed = {.lower = 0.0, .upper = 1.0, .upper_open = true}, .plausible = {0.5, 0.99},
         .doc = "R_f: stress ratio at failure over that of the hyperbola's asymptote [Beaty and Byrne 2011]."},
        {.pattern = "materials.*.constant_volume_friction_deg", .default_value = m.constant_volume_friction_deg,
         .allowed = friction, .plausible = {25.0, 38.0},
         .doc = "phi_cv in degrees: below its sine the sand contracts, above it dilates [Beaty and Byrne 2011]."},
        {.pattern = "materials.*.peak_friction_deg",
         .default_note = "phi_cv + (N1)60/10 + max(0, ((N1)60 - 15)/5)", .allowed = friction,
         .plausible = {28.0, 48.0}, .doc = "phi_f in degrees, the failure limit [Beaty and Byrne 2011]."},
        {.pattern = "materials.*.cohesion", .dimension = Dimension::pressure, .default_value = m.cohesion,
         .allowed = not_negative, .plausible = {0.0, 1e5}, .doc = "c of the failure limit."},
    };
}

/// Parameters of the memory of cycles.
std::vector<SceneKey> memory_keys()
{
    const UbcSandParameters m;
    return {
        {.pattern = "materials.*.virgin_factor", .default_value = m.virgin_factor, .allowed = positive,
         .plausible = {0.2, 5.0}, .doc = "h1, factor on the plastic modulus in all loading."},
        {.pattern = "materials.*.secondary_factor", .default_note = "0.6; calibrated 0.6 (6/(N1)60)^0.33", .allowed = positive,
         .plausible = {0.05, 5.0},
         .doc = "h2 in h1 h2 (s0 + s1 n) below the largest ratio so far; calibrated to the triggering curve."},
        {.pattern = "materials.*.secondary_start", .default_value = m.secondary_start, .allowed = positive,
         .plausible = {1.0, 10.0}, .doc = "s0, the stiffening of the first reloading."},
        {.pattern = "materials.*.secondary_growth", .default_value = m.secondary_growth, .allowed = not_negative,
         .plausible = {0.0, 2.0},
         .doc = "s1, its growth per half cycle n; larger makes the cyclic strength curve flatter."},
        {.pattern = "materials.*.reversal_tolerance", .default_value = m.reversal_tolerance, .allowed = not_negative,
         .plausible = {0.0, 0.1}, .doc = "Smallest change of the stress ratio that counts as a reversal; below it reloading is elastic."},
        {.pattern = "materials.*.dilation_softening", .default_value = m.dilation_softening, .allowed = not_negative,
         .plausible = {0.0, 5000.0},
         .doc = "The plastic modulus falls by exp(-dilation_softening times shear strain in dilation)."},
        {.pattern = "materials.*.softened_factor", .default_note = "0.05; calibrated 0.02 (6/(N1)60)^0.8", .allowed = positive,
         .plausible = {0.002, 1.0},
         .doc = "Least factor after dilation; with 1 there is no softening, and ru never reaches 1."},
    };
}

} // namespace

SceneKey law_choice_key()
{
    return {.pattern = "materials.*.law", .type = ValueType::word, .default_value = "published",
            .words = {"published", "calibrated"},
            .doc = "Standard values of the keys that have two: those of the published law, or those that meet what laboratories "
                   "measure [own]: of UBCSAND K_sigma, K_alpha, K0, strains after liquefaction and small strains, with the stress "
                   "out of the plane bounded by the failure limit; of PM4Sand damping, the loss of strength with "
                   "cycles, and settlement after liquefaction."};
}

namespace {

/// What follows the stress at the start, liquefaction and small strains, by the word of `law`.
std::vector<SceneKey> calibration_keys()
{
    return {
        law_choice_key(),
        {.pattern = "materials.*.confining_exponent", .default_note = "0; calibrated 0.18", .allowed = not_negative,
         .plausible = {0.0, 0.5},
         .doc = "m_v: the plastic modulus goes with max(1, sigma'_v/Pa)^-m_v of the start of shaking, which sets K_sigma [own]."},
        {.pattern = "materials.*.lateral_exponent", .default_note = "0; calibrated 12/(N1)60", .allowed = not_negative,
         .plausible = {0.0, 4.0},
         .doc = "m_h: it goes with ((1 + K0)/1.5)^m_h of the start of shaking [own]."},
        {.pattern = "materials.*.static_shear_stiffening", .default_note = "0; calibrated 9 + (N1)60^2/50", .allowed = not_negative,
         .plausible = {0.0, 40.0},
         .doc = "a: it goes with 1 + a |tau|/sigma'_v of the start of shaking on horizontal planes, which sets K_alpha [own]."},
        {.pattern = "materials.*.least_start_ratio", .default_note = "0; calibrated 1/3",
         .allowed = {.lower = 0.0, .upper = 1.0, .upper_open = true}, .plausible = {0.0, 0.5},
         .doc = "The sand remembers at least this stress ratio from before the shaking; 1/3 is that of K0 = 1/2 [own]."},
        {.pattern = "materials.*.dilation_factor", .default_note = "1; calibrated 5 (6/(N1)60)^(1/2), at most 5", .allowed = {.lower = 1.0},
         .plausible = {1.0, 20.0},
         .doc = "Dilation above the friction of constant volume over that of the generic set: it limits the strain of a cycle after liquefaction [own]."},
        {.pattern = "materials.*.dilation_strain", .default_note = "without end; calibrated 0.12 (6/(N1)60)^1.5", .allowed = positive,
         .plausible = {0.002, 10.0},
         .doc = "Shear strain in dilation after which the softened factor of later half cycles is halved, so that strain grows from cycle to cycle; with it sand softens only against the sense in which it last dilated [own]."},
        {.pattern = "materials.*.reference_strain", .default_note = "without end; calibrated 4.5e-4", .allowed = positive,
         .plausible = {1e-4, 0.01},
         .doc = "gamma_r: G falls by (1 + gamma/(2 gamma_r))^-2 with the shear strain since it turned: small-strain modulus and damping."},
        {.pattern = "materials.*.least_modulus_fraction", .default_note = "1; calibrated 0.35",
         .allowed = {.lower = 0.0, .upper = 1.0, .lower_open = true}, .plausible = {0.1, 1.0},
         .doc = "G falls to this fraction at least; 1 keeps it."},
        {.pattern = "materials.*.reconsolidation_slope", .default_note = "0; calibrated 1.5 exp(-0.369 (N1)60^(1/2))",
         .allowed = not_negative, .plausible = {0.0, 1.5},
         .doc = "Volumetric strain of reconsolidation over the largest shear strain, which counts to 8 % [Yoshimine et al. 2006]."},
        {.pattern = "materials.*.liquefied_conductivity", .default_note = "1; calibrated 5",
         .allowed = {.lower = 1.0}, .plausible = {1.0, 20.0},
         .doc = "Hydraulic conductivity at ru = 1 over that of sand at rest; between them it goes with ru^8.9 [own; Shahir et al. 2012: with ru]."},
    };
}

/// How the stress is integrated.
std::vector<SceneKey> substep_keys()
{
    const UbcSandParameters m;
    return {
        {.pattern = "materials.*.largest_ratio_step", .default_value = m.largest_ratio_step, .allowed = positive,
         .plausible = {0.0005, 0.2}, .doc = "Elastic change of the stress ratio in a substep."},
        {.pattern = "materials.*.largest_stress_step", .default_value = m.largest_stress_step, .allowed = positive,
         .plausible = {0.001, 0.2}, .doc = "Relative elastic change of the mean stress in a substep."},
        {.pattern = "materials.*.stress_floor", .dimension = Dimension::pressure, .default_value = m.stress_floor,
         .allowed = positive, .plausible = {10.0, 5000.0},
         .doc = "Least in-plane mean effective stress, reached by liquefied sand."},
    };
}

/// Parameters of runs beside those of the law.
std::vector<SceneKey> sand_run_keys()
{
    return {
        {.pattern = "materials.*.shear_wave_velocity", .dimension = Dimension::velocity,
         .default_note = "elastic_shear_number gives it", .allowed = positive, .plausible = {80.0, 400.0},
         .doc = "Of saturated sand at a vertical effective stress of 100 kPa and K0 = 1/2, as V_s1; sets elastic_shear_number."},
        {.pattern = "materials.*.static_poisson_ratio",
         .default_value = UbcSandParameters().static_poisson_ratio,
         .allowed = {.lower = 0.0, .upper = 0.5, .upper_open = true}, .plausible = {0.2, 0.45},
         .doc = "Poisson's ratio in the relaxation; level ground settles to K0 = nu / (1 - nu), 1/3 to 0.5."},
        {.pattern = "materials.*.ripple_strain", .default_value = UbcSandRunSettings().ripple_strain,
         .allowed = not_negative, .plausible = {0.0, 3e-4},
         .doc = "Reversals of smaller shear strain are ripples of the run and not counted as half cycles; they do "
                "not change the volume [Dobry et al. 1982]."},
        {.pattern = "materials.*.largest_porosity", .default_note = "e_max = e + 0.376 relative_density",
         .allowed = {.lower = 0.0, .upper = 1.0, .lower_open = true}, .plausible = {0.38, 0.6},
         .doc = "Porosity of the loosest sand, which no longer dilates; at the stress floor such sand has no stiffness "
                "until its grains touch again."},
        {.pattern = "materials.*.smallest_porosity", .default_note = "e_min = e - 0.376 (1 - relative_density)",
         .allowed = {.lower = 0.0, .upper = 1.0, .upper_open = true}, .plausible = {0.2, 0.45},
         .doc = "Porosity of the densest sand, which no longer contracts."},
        {.pattern = "materials.*.resolved_floors", .default_value = UbcSandRunSettings().resolved_floors,
         .allowed = not_negative, .plausible = {0.0, 40.0},
         .doc = "Below this multiple of stress_floor errors of substeps count as at it, which makes liquefied sand faster."},
        {.pattern = "materials.*.substep_tolerance", .default_value = UbcSandRunSettings().substep_tolerance,
         .allowed = positive, .plausible = {1e-5, 0.1},
         .doc = "Error of the stress in a substep, relative, which bounds its length."},
    };
}

// clang-format on

} // namespace

std::vector<SceneKey> ubcsand_keys()
{
    std::vector<SceneKey> keys;
    for (const auto& part : {density_keys_of_sand(), stiffness_keys(), strength_keys(), memory_keys(),
                             calibration_keys(), substep_keys()})
        keys.insert(keys.end(), part.begin(), part.end());
    return keys;
}

std::vector<SceneKey> ubcsand_scene_keys()
{
    std::vector<SceneKey> keys = ubcsand_keys();
    for (SceneKey& key : keys) {
        if (last_part(key.pattern) == "largest_ratio_step") {
            key.default_value = UbcSandRunSettings().largest_ratio_step;
            key.plausible.upper = 20.0;
        }
        if (last_part(key.pattern) == "largest_stress_step") {
            key.default_value = UbcSandRunSettings().largest_stress_step;
            key.plausible.upper = 1.0;
        }
    }
    const std::vector<SceneKey> of_runs = sand_run_keys();
    keys.insert(keys.end(), of_runs.begin(), of_runs.end());
    return keys;
}

void show(const std::string& path, double value, SceneValues& values)
{
    // six digits are read
    const double scale = value == 0.0 ? 1.0 : std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(value))));
    show_words(path, number_text(std::round(value * scale) / scale), values);
}

UbcSandParameters resolve_ubcsand(const NamedTable& material, SceneValues& values, Diagnostics& findings)
{
    const auto n1_60 = find_blow_count(material, values, findings);
    if (!n1_60 || !(*n1_60 > 0.0)) return {};
    const auto given = [&](const char* key) {
        const std::string path = material.path + "." + key;
        return values.given(path) ? values.find<double>(path) : std::nullopt;
    };
    show_density(material.path, *n1_60, values);
    UbcSandParameters set = ubcsand_from_blow_count(*n1_60, find_shear_number(material, values, findings),
                                                    given("constant_volume_friction_deg"));
    if (values.text(material.path + ".law") == "calibrated") set = calibrated(set);
    for (const auto& [key, parameter] : parameters_of_words) {
        if (const auto value = given(key)) set.*parameter = *value;
        if (std::isfinite(set.*parameter)) show(material.path + "." + key, set.*parameter, values);
    }
    for (const auto& [key, parameter] :
         parameters_of_keys) { // those of the generic set have no value of their own
        if (const auto value = values.find<double>(material.path + "." + key)) set.*parameter = *value;
        show(material.path + "." + key, set.*parameter, values);
    }
    if (findings.has_errors()) return set; // keys out of range have been reported
    try {
        check(set);
    } catch (const InputError& error) {
        findings.add(error_at(material.place, "range", error.what()));
    }
    return set;
}

} // namespace quicksand
