#include "io/laws/pm4sand_soil.hpp"

#include "io/keys/scene_units.hpp"
#include "io/laws/ubcsand_keys.hpp"
#include "solver/element/cyclic_laboratory.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <variant>

namespace quicksand {

namespace {

bool check_density(const LawSource& source)
{
    const std::string& path = source.table.path;
    const bool by_density = source.values.find<double>(path + ".relative_density").has_value();
    const bool by_blows = source.values.find<double>(path + ".n1_60").has_value();
    const char* const choice = "one of n1_60 and relative_density";
    if (!by_density && !by_blows)
        source.findings.add(
            error_at(source.table.place, "missing-key", "[" + path + "] has no density", choice,
                     "n1_60 = 13.9 or relative_density = 0.55 gives all other parameters their "
                     "values"));
    if (by_density && by_blows)
        source.findings.add(error_at(source.values.place(path + ".relative_density"), "conflict",
                                     "[" + path + "] has a density already, by n1_60", choice,
                                     "remove one of the two"));
    return by_density != by_blows;
}

void check_void_ratios(const Pm4Sand& law, const LawSource& source)
{
    if (law.largest_void_ratio > law.smallest_void_ratio) return;
    const std::string path = source.table.path + ".largest_void_ratio";
    const std::string least = number_text(law.smallest_void_ratio);
    source.findings.add(
        error_at(source.values.given(path) ? source.values.place(path) : source.table.place, "range",
                 path + " = " + number_text(law.largest_void_ratio) + " is not above the smallest",
                 "above smallest_void_ratio = " + least));
}

/// By its keys; those that are not given get their values, which are shown.
Pm4Sand resolve(const LawSource& source)
{
    if (!check_density(source)) return complete(Pm4Sand{.relative_density = 0.5});
    const bool is_calibrated = source.values.text(source.table.path + ".law") == "calibrated";
    Pm4Sand law = is_calibrated ? calibrated_pm4sand() : Pm4Sand();
    const auto path_of = [&](const LawKey<Pm4Sand>& key) {
        return source.table.path + "." + std::string(key.text.name);
    };
    for (const LawKey<Pm4Sand>& key : keys_of(law))
        if (const auto value = source.values.find<double>(path_of(key)))
            law.*key.member = key.factor * *value;
    check_void_ratios(law, source);
    law = is_calibrated ? complete_calibrated(law) : complete(law);
    for (const LawKey<Pm4Sand>& key : keys_of(law))
        if (std::isfinite(law.*key.member)) show(path_of(key), law.*key.member / key.factor, source.values);
    return law;
}

double degrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

/// phi of M^b at one atmosphere.
double peak_friction(const Pm4Sand& law)
{
    return degrees(std::asin(0.5 * largest_ratio(law, atmospheric_pressure, initial_void_ratio(law))));
}

} // namespace

SkeletonLaw read_pm4sand(const LawSource& source)
{
    return resolve(source);
}

DescribedLaw read_pm4sand_for_element(const LawSource& source)
{
    const Pm4Sand law = resolve(source);
    const auto n1_60 = source.values.given(source.table.path + ".n1_60");
    return {law, "PM4Sand",
            n1_60 ? "(N1)60 = " + number_text(law.n1_60) : "Dr = " + number_text(law.relative_density),
            n1_60 ? "n1_60" : "relative_density",
            fmt::format("G0 {:.0f}, hpo {:.3g}, h0 {:.3g}, φcv {:.3g}°, peak {:.3g}° at 100 kPa",
                        law.shear_coefficient, law.contraction_rate, law.modulus_ratio,
                        law.constant_volume_friction_deg, peak_friction(law))};
}

SkeletonLaw example_of_pm4sand()
{
    return complete(Pm4Sand{.relative_density = 0.55});
}

std::string describe_pm4sand(const Material& material, double k0)
{
    const auto& law = std::get<Pm4Sand>(material.law);
    const double nu = law.static_poisson_ratio;
    std::string text =
        fmt::format("  {:<16}shear modulus {} MPa, friction {}° at 100 kPa, {}° in the critical state\n",
                    material.name, three_digits(1e-6 * shear_modulus(law)), three_digits(peak_friction(law)),
                    three_digits(law.constant_volume_friction_deg));
    text += fmt::format("  {:<16}settles to K0 = {} below level ground\n", "", three_digits(nu / (1.0 - nu)));
    const Consolidation start{atmospheric_pressure, k0, 0.0};
    if (!can_consolidate(law, start))
        return text +
               fmt::format("  {:<16}its cyclic strength is not told: it fails as it is consolidated\n", "");
    const auto csr = csr_to_ru_95(law, start, 15.0);
    return text +
           fmt::format("  {:<16}{}, at 100 kPa and K0 = {}\n", "",
                       csr ? "liquefies (ru = 0.95) in 15 cycles of simple shear at a stress ratio of " +
                                 three_digits(*csr)
                           : "liquefies (ru = 0.95) at no stress ratio from 0.01 to 2 in 15 cycles",
                       three_digits(k0));
}

} // namespace quicksand
