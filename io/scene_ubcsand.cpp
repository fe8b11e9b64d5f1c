#include "io/scene_ubcsand.hpp"

#include "io/ubcsand_keys.hpp"
#include "solver/ubcsand.hpp"

#include <cmath>
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

/// Porosity of the sand at its loosest, given or by its density.
double largest_porosity(const NamedTable& table, double relative_density, SceneValues& values,
                        Diagnostics& findings)
{
    const std::string key = table.path + ".largest_porosity";
    const double porosity = values.number(table.path + ".porosity");
    if (const auto given = values.find<double>(key)) {
        if (*given < porosity)
            findings.add(
                error_at(values.place(key), "range",
                         key + " = " + number_text(*given) + " is below porosity = " + number_text(porosity),
                         "the porosity of the sand at its loosest"));
        return *given;
    }
    const double void_ratio = porosity / (1.0 - porosity) + void_ratio_range * relative_density;
    const double largest = void_ratio / (1.0 + void_ratio);
    show(key, largest, values);
    return largest;
}

} // namespace

void read_ubcsand_materials(SceneValues& values, Scene& scene, Diagnostics& findings)
{
    for (SceneMaterial& material : scene.materials) {
        const NamedTable table = {material.material.name, join_path({"materials", material.material.name}),
                                  material.place};
        if (values.text(table.path + ".model") != "ubcsand") continue;
        UbcSandParameters parameters = resolve_ubcsand(table, values, findings);
        parameters.static_poisson_ratio = values.number(table.path + ".static_poisson_ratio");
        parameters.integration = UbcSandRunSettings().integration;
        parameters.ripple_strain = values.number(table.path + ".ripple_strain");
        parameters.resolved_floors = values.number(table.path + ".resolved_floors");
        const double loosest = largest_porosity(table, parameters.relative_density, values, findings);
        parameters.largest_specific_volume = 1.0 / (material.material.grain_density * (1.0 - loosest));
        check_k0(values, table, parameters, findings);
        material.ubcsand = parameters;
        if (!findings.has_errors()) material.material.law = make_ubcsand(parameters);
    }
}

} // namespace quicksand
