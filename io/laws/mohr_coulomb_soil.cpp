#include "io/laws/mohr_coulomb_soil.hpp"

#include <fmt/format.h>

#include <cmath>
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

/// Angles that were meant in radians.
void check_degrees(double friction, const SceneValues& values, const std::string& key, Diagnostics& findings)
{
    constexpr double least = 3.0; // [deg], of any soil with friction
    if (friction <= 0.0 || friction >= least) return;
    findings.add(warning_at(values.place(key), key, "plausibility",
                            key + " = " + quantity_text(friction, Dimension::angle) +
                                " is unusually small: angles are in degrees",
                            "usually 15 to 45 deg, or 0",
                            fmt::format("{:g} rad is {:.2g} deg", friction, friction / radians_per_degree)));
}

} // namespace

void check_mohr_coulomb(const LawSource& source)
{
    const SceneValues& values = source.values;
    Diagnostics& findings = source.findings;
    const std::string& path = source.table.path;
    const auto cohesion = values.find<double>(path + ".cohesion"),
               friction = values.find<double>(path + ".friction_angle"),
               dilation = values.find<double>(path + ".dilation_angle"),
               tension = values.find<double>(path + ".tension_strength");
    if (friction) check_degrees(*friction, values, path + ".friction_angle", findings);
    if (friction && dilation && *dilation > *friction) {
        findings.add(
            error_at(values.place(path + ".dilation_angle"), "range",
                     path + ".dilation_angle = " + quantity_text(*dilation, Dimension::angle) +
                         " is more than friction_angle = " + quantity_text(*friction, Dimension::angle),
                     "at most the angle of friction: otherwise shearing would produce energy",
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

} // namespace quicksand
