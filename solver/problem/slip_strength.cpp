#include "solver/problem/slip_strength.hpp"

#include "solver/base/failure.hpp"
#include "solver/base/overload.hpp"
#include "solver/pm4sand/pm4sand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace quicksand {

namespace {

// Every law is named, so that a new one is not forgotten.

/// sin(phi) of the layer whose plane slides at tan(delta), not above that of the soil.
double layer_sine(const SlipStrength& strength, double sine_of_soil)
{
    return std::min(strength.friction, sine_of_soil);
}

/// c of the layer, not above that of the soil [Pa].
double layer_cohesion(const SlipStrength& strength, double sine, double cohesion_of_soil)
{
    return std::min(strength.cohesion / std::sqrt(1.0 - sine * sine), cohesion_of_soil);
}

SlipStrength of_angle(double sine, double cohesion)
{
    return {std::tan(std::asin(sine)), cohesion};
}

/// Along a plane, with c and the sines of friction and dilation.
SlipStrength along_plane(double friction, double dilation, double cohesion)
{
    const double cos_dilation = std::sqrt(1.0 - dilation * dilation), share = 1.0 - friction * dilation;
    return {friction * cos_dilation / share,
            cohesion * std::sqrt(1.0 - friction * friction) * cos_dilation / share};
}

double cohesion_of(const UbcSand& law) // [Pa]
{
    return law.a * std::tan(std::asin(law.eta_f));
}

/// sin(phi) of the bounding surface at one atmosphere [-].
double peak_sine(const Pm4Sand& law)
{
    return 0.5 * largest_ratio(law, atmospheric_pressure, initial_void_ratio(law));
}

MohrCoulomb slipping_soil(const MohrCoulomb& law, const SlipStrength& strength)
{
    MohrCoulomb layer = law;
    const double sine = layer_sine(strength, std::sin(law.friction_angle));
    layer.friction_angle = std::asin(sine);
    layer.cohesion = layer_cohesion(strength, sine, law.cohesion);
    layer.dilation_angle = 0.0;
    return layer;
}

UbcSand slipping_sand(const UbcSand& law, const SlipStrength& strength)
{
    UbcSand layer = law;
    const double sine = layer_sine(strength, law.eta_f), cohesion = cohesion_of(law);
    layer.eta_f = sine;
    layer.R = law.R * law.eta_f / sine; // R_f stays
    layer.sin_cv = std::min(law.sin_cv, sine);
    layer.a = layer_cohesion(strength, sine, cohesion) / std::tan(std::asin(sine));
    return layer;
}

/// All surfaces are that of the critical state: the layer slides there, and its density has no part in it.
Pm4Sand slipping_sand(const Pm4Sand& law, const SlipStrength& strength)
{
    Pm4Sand layer = law;
    const double sine = layer_sine(strength, 0.5 * law.critical_ratio);
    layer.constant_volume_friction_deg = std::asin(sine) * 180.0 / std::numbers::pi;
    layer.critical_ratio = 2.0 * sine;
    layer.bounding_exponent = layer.dilatancy_exponent = 0.0;
    constexpr double usual_dilatancy = 1.24; // A_d0 where M^b is M
    if (std::isnan(layer.dilatancy_factor)) layer.dilatancy_factor = usual_dilatancy;
    return layer;
}

} // namespace

std::optional<SlipStrength> coulomb_strength(const SkeletonLaw& law)
{
    using Strength = std::optional<SlipStrength>;
    return std::visit(
        Overload{[](const LinearElastic&) { return Strength(); },
                 [](const NeoHookean&) { return Strength(); }, [](const SettlingSand&) { return Strength(); },
                 [](const MohrCoulomb& soil) {
                     return Strength({std::tan(soil.friction_angle), soil.cohesion});
                 },
                 [](const UbcSand& sand) { return Strength(of_angle(sand.eta_f, cohesion_of(sand))); },
                 [](const Pm4Sand& sand) { return Strength(of_angle(peak_sine(sand), 0.0)); }},
        law);
}

std::optional<SlipStrength> slip_strength(const SkeletonLaw& law)
{
    using Strength = std::optional<SlipStrength>;
    return std::visit(
        Overload{[](const LinearElastic&) { return Strength(); },
                 [](const NeoHookean&) { return Strength(); }, [](const SettlingSand&) { return Strength(); },
                 [](const MohrCoulomb& soil) {
                     return Strength(along_plane(std::sin(soil.friction_angle), std::sin(soil.dilation_angle),
                                                 soil.cohesion));
                 },
                 [](const UbcSand& sand) {
                     const double dilation = sand.dilation * std::max(0.0, sand.eta_f - sand.sin_cv);
                     return Strength(
                         along_plane(sand.eta_f, std::min(dilation, sand.eta_f), cohesion_of(sand)));
                 },
                 [](const Pm4Sand& sand) {
                     return Strength({0.5 * sand.critical_ratio, 0.0});
                 }},
        law);
}

SkeletonLaw slipping(const SkeletonLaw& law, const SlipStrength& strength)
{
    const auto none = []() -> SkeletonLaw { throw InternalError("a law without strength slips nowhere"); };
    return std::visit(
        Overload{[&](const LinearElastic&) { return none(); }, [&](const NeoHookean&) { return none(); },
                 [&](const SettlingSand&) { return none(); },
                 [&](const MohrCoulomb& soil) -> SkeletonLaw { return slipping_soil(soil, strength); },
                 [&](const UbcSand& sand) -> SkeletonLaw { return slipping_sand(sand, strength); },
                 [&](const Pm4Sand& sand) -> SkeletonLaw { return slipping_sand(sand, strength); }},
        law);
}

} // namespace quicksand
