#include "io/laws/ubcsand_soil.hpp"

#include "io/keys/scene_units.hpp"
#include "solver/element/cyclic_laboratory.hpp"
#include "solver/ubcsand/ubcsand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace quicksand {

namespace {

/// K0 outside ((1 - sin phi_f)/(1 + sin phi_f), its inverse) is a stress that sand without cohesion cannot
/// bear.
void check_k0(const SceneValues& values, const NamedTable& table, const UbcSandParameters& parameters,
              Diagnostics& findings)
{
    const double k0 = values.number("initial.k0");
    const double sine = std::sin(parameters.peak_friction_deg * std::numbers::pi / 180.0);
    const double least = (1.0 - sine) / (1.0 + sine);
    if (parameters.cohesion > 0.0 || (k0 >= least && k0 <= 1.0 / least)) return;
    const auto text = [](double value) { return number_text(std::round(1e3 * value) / 1e3); };
    findings.add(error_at(values.given("initial.k0") ? values.place("initial.k0") : table.place, "range",
                          "initial.k0 = " + number_text(k0) + " is beyond the failure limit of " + table.path,
                          text(least) + " to " + text(1.0 / least) +
                              " for its peak_friction_deg = " + text(parameters.peak_friction_deg),
                          "0.5 is usual for sand that was not loaded before"));
}

/// Void ratios of Nevada sand at its loosest and densest, 0.887 and 0.511 [Arulmoli et al. 1992]: their
/// difference stands for that of other sands.
constexpr double void_ratio_range = 0.376; // e_max - e_min [-]

/// An end of the range of porosities: how far its void ratio is from that of the sand, and its names.
struct PorosityEnd {
    const char* key;
    double way; // in void ratio [-]
    const char *beyond, *meaning;
};

/// Porosity of the sand at its loosest or densest, given or by its density.
double porosity_at(const PorosityEnd& end, const NamedTable& table, SceneValues& values,
                   Diagnostics& findings)
{
    const std::string key = table.path + "." + end.key;
    const double porosity = values.number(table.path + ".porosity");
    if (const auto given = values.find<double>(key)) {
        if ((*given - porosity) * end.way < 0.0)
            findings.add(error_at(values.place(key), "range",
                                  key + " = " + number_text(*given) + " is " + end.beyond +
                                      " porosity = " + number_text(porosity),
                                  end.meaning));
        return *given;
    }
    const double void_ratio = std::max(0.0, porosity / (1.0 - porosity) + end.way);
    const double result = void_ratio / (1.0 + void_ratio);
    show(key, result, values);
    return result;
}

/// Bound the volume that the grains take by the porosities of the sand at its loosest and densest.
void bound_volumes(const NamedTable& table, double grain_density, SceneValues& values,
                   UbcSandParameters& parameters, Diagnostics& findings)
{
    const double to_loosest = void_ratio_range * parameters.relative_density;
    const PorosityEnd loosest = {"largest_porosity", to_loosest, "below",
                                 "the porosity of the sand at its loosest"};
    const PorosityEnd densest = {"smallest_porosity", to_loosest - void_ratio_range, "above",
                                 "the porosity of the sand at its densest"};
    const auto volume = [&](const PorosityEnd& end) { // per mass of grains
        return 1.0 / (grain_density * (1.0 - porosity_at(end, table, values, findings)));
    };
    parameters.largest_specific_volume = volume(loosest);
    parameters.smallest_specific_volume = volume(densest);
}

/// A scene may have a K0 that its soil bears by cohesion at lower stresses, and not at the test's. The
/// specimen has no porosity of its own, and its volume stays: the bounds of the scene's volumes are not for
/// it.
std::string describe_strength(UbcSand law, double k0)
{
    law.largest_specific_volume = std::numeric_limits<double>::infinity();
    law.smallest_specific_volume = 0.0;
    const Consolidation start{atmospheric_pressure, k0, 0.0};
    if (!can_consolidate(law, start))
        return "its cyclic strength is not told: it fails as it is consolidated";
    const auto csr = csr_to_ru_95(law, start, 15.0);
    return csr ? "liquefies (ru = 0.95) in 15 cycles of simple shear at a stress ratio of " +
                     three_digits(*csr)
               : "liquefies (ru = 0.95) at no stress ratio from 0.01 to 2 in 15 cycles of simple shear";
}

} // namespace

SkeletonLaw read_ubcsand(const LawSource& source)
{
    SceneValues& values = source.values;
    const NamedTable& table = source.table;
    UbcSandParameters parameters = resolve_ubcsand(table, values, source.findings);
    parameters.static_poisson_ratio = values.number(table.path + ".static_poisson_ratio");
    parameters.integration = UbcSandRunSettings().integration;
    parameters.ripple_strain = values.number(table.path + ".ripple_strain");
    parameters.resolved_floors = values.number(table.path + ".resolved_floors");
    parameters.substep_tolerance = values.number(table.path + ".substep_tolerance");
    bound_volumes(table, source.material.grain_density, values, parameters, source.findings);
    check_k0(values, table, parameters, source.findings);
    return source.findings.has_errors() ? UbcSand() : make_ubcsand(parameters);
}

DescribedLaw read_ubcsand_for_element(const LawSource& source)
{
    const NamedTable& table = source.table;
    const UbcSandParameters m = resolve_ubcsand(table, source.values, source.findings);
    const auto number = [&](const char* key) { return source.values.find<double>(table.path + "." + key); };
    DescribedLaw described{.title = "UBCSAND"};
    if (const auto n1_60 = number("n1_60")) {
        described.density = "(N1)60 = " + number_text(*n1_60), described.density_key = "n1_60";
    } else if (const auto density = number("relative_density")) {
        described.density = "Dr = " + number_text(*density), described.density_key = "relative_density";
    } else {
        described.density = source.values.text(table.path + ".preset"), described.density_key = "preset";
    }
    described.numbers = fmt::format(
        "K_G {:.0f}, K_B {:.0f}, K_Gp {:.0f}, R_f {:.3f}, φcv {:.3g}°, φf {:.4g}°, h1 {:.3g}, h2 {:.3g}",
        m.elastic_shear_number, m.elastic_bulk_number, m.plastic_shear_number, m.failure_ratio,
        m.constant_volume_friction_deg, m.peak_friction_deg, m.virgin_factor, m.secondary_factor);
    described.law = source.findings.has_errors() ? UbcSand() : make_ubcsand(m);
    return described;
}

SkeletonLaw example_of_ubcsand()
{
    return make_ubcsand(with(UbcSandRunSettings(), nevada_sand_55()));
}

std::string describe_ubcsand(const Material& material, double k0)
{
    const auto& law = std::get<UbcSand>(material.law);
    const double sine = law.eta_f, least_k0 = (1.0 - sine) / (1.0 + sine);
    std::string text =
        fmt::format("  {:<16}shear modulus {} MPa, drained bulk modulus {} MPa at 100 kPa\n", material.name,
                    three_digits(1e-6 * shear_modulus(law)), three_digits(1e-6 * law.B_atm));
    text += fmt::format("  {:<16}K0 possible from {} to {}; settles to K0 = {} below level ground\n", "",
                        three_digits(least_k0), three_digits(1.0 / least_k0),
                        three_digits(law.static_poisson / (1.0 - law.static_poisson)));
    return text + fmt::format("  {:<16}{}, at 100 kPa and K0 = {}\n", "", describe_strength(law, k0),
                              three_digits(k0));
}

} // namespace quicksand
