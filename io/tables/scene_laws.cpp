#include "io/tables/scene_laws.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace quicksand {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;

/// The number rounded down to four digits.
double four_digits(double number)
{
    if (number == 0.0) return 0.0;
    const double unit = std::pow(10.0, std::floor(std::log10(number)) - 3.0);
    return std::floor(number / unit) * unit;
}

MohrCoulomb read_mohr_coulomb(const SceneValues& values, const std::string& path)
{
    MohrCoulomb law;
    law.shear_modulus = values.number(path + ".shear_modulus");
    law.poisson_ratio = values.number(path + ".poisson_ratio");
    law.cohesion = values.number(path + ".cohesion");
    law.friction_angle = radians_per_degree * values.number(path + ".friction_angle");
    law.dilation_angle = radians_per_degree * values.number(path + ".dilation_angle");
    law.tension_strength =
        values.find<double>(path + ".tension_strength").value_or(std::numeric_limits<double>::infinity());
    return law;
}

void check_mohr_coulomb(const SceneValues& values, const std::string& path, Diagnostics& findings)
{
    const auto cohesion = values.find<double>(path + ".cohesion"),
               friction = values.find<double>(path + ".friction_angle"),
               dilation = values.find<double>(path + ".dilation_angle"),
               tension = values.find<double>(path + ".tension_strength");
    if (friction && dilation && *dilation > *friction) {
        findings.add(
            error_at(values.place(path + ".dilation_angle"), "range",
                     path + ".dilation_angle = " + quantity_text(*dilation, Dimension::angle) +
                         " is more than friction_angle = " + quantity_text(*friction, Dimension::angle),
                     "at most the angle of friction: otherwise shearing would give off energy",
                     "sand dilates by about friction_angle - 30 deg"));
    }
    if (!cohesion || !friction) return;
    if (*cohesion == 0.0 && *friction == 0.0) {
        findings.add(error_at(values.place(path + ".friction_angle"), "range",
                              path + " has no strength: cohesion and friction_angle are both 0",
                              "one of them more than 0"));
    }
    const double tip = *cohesion / std::tan(radians_per_degree * *friction);
    if (tension && *friction > 0.0 && *tension > tip * (1.0 + 1e-12)) {
        findings.add(error_at(values.place(path + ".tension_strength"), "range",
                              path + ".tension_strength = " + quantity_text(*tension, Dimension::pressure) +
                                  " lies beyond the tip of the surface",
                              "at most cohesion / tan(friction_angle) = " +
                                  quantity_text(four_digits(tip), Dimension::pressure),
                              "remove it: the tip is the default"));
    }
}

/// The settled stress would be gone with the reference that the shaking starts from.
void check_neo_hookean(const SceneValues& values, const std::string& path, Diagnostics& findings)
{
    if (!values.has_table("relaxation")) return;
    findings.add(error_at(
        values.place(path + ".model"), "conflict",
        path + ".model = \"neo_hookean\" cannot settle in [relaxation]: its stress is that of its shape, and "
               "the shaking starts from the settled shape without any",
        "linear_elastic, mohr_coulomb or ubcsand beside [relaxation]",
        "remove [relaxation]: gravity is then switched on at once"));
}

} // namespace

SkeletonLaw read_skeleton_law(const SceneValues& values, const NamedTable& material)
{
    const std::string model = values.text(material.path + ".model");
    const double shear_modulus = values.number(material.path + ".shear_modulus");
    const double poisson_ratio = values.number(material.path + ".poisson_ratio");
    if (model == "mohr_coulomb") return read_mohr_coulomb(values, material.path);
    if (model == "neo_hookean") return NeoHookean{shear_modulus, poisson_ratio};
    return LinearElastic{shear_modulus, poisson_ratio};
}

void check_skeleton_laws(const SceneValues& values, Diagnostics& findings)
{
    const auto materials = values.named.find("materials");
    if (materials == values.named.end()) return;
    for (const NamedTable& material : materials->second) {
        const std::string model = values.text(material.path + ".model");
        if (model == "mohr_coulomb") check_mohr_coulomb(values, material.path, findings);
        if (model == "neo_hookean") check_neo_hookean(values, material.path, findings);
    }
}

} // namespace quicksand
