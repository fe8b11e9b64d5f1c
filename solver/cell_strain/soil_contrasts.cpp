#include "solver/cell_strain/soil_contrasts.hpp"

#include <cmath>
#include <optional>
#include <variant>

namespace quicksand {

namespace {

struct Moduli {
    double constrained, shear; // [Pa]
};

Moduli moduli_of(const SkeletonLaw& law)
{
    return std::visit(
        [](const auto& any) {
            return Moduli{constrained_modulus(any), shear_modulus(any)};
        },
        law);
}

bool are_equal(double a, double b)
{
    constexpr double rounding = 1e-6;
    return std::abs(a - b) <= rounding * (std::abs(a) + std::abs(b));
}

/// By strength alone; sands that have no line of failure fail all the same.
Contrast contrast_of_strength(const SkeletonLaw& first, const SkeletonLaw& second)
{
    const std::optional<FailureLine> a = failure_line_of(first), b = failure_line_of(second);
    if (a && b) {
        if (are_equal(a->slope, b->slope) && are_equal(a->at_zero, b->at_zero)) return Contrast::none;
        if (a->slope >= b->slope && a->at_zero >= b->at_zero) return Contrast::first_bears;
        if (b->slope >= a->slope && b->at_zero >= a->at_zero) return Contrast::second_bears;
        return Contrast::unlike;
    }
    if (first.index() == second.index()) return Contrast::none;
    if (!yields(first)) return Contrast::first_bears;
    if (!yields(second)) return Contrast::second_bears;
    return Contrast::unlike;
}

} // namespace

Contrast contrast_between(const SkeletonLaw& first, const SkeletonLaw& second)
{
    constexpr double clearly = 1.5;
    const Moduli a = moduli_of(first), b = moduli_of(second);
    if (a.shear > clearly * b.shear) return Contrast::first_bears;
    if (b.shear > clearly * a.shear) return Contrast::second_bears;
    const Contrast of_strength = contrast_of_strength(first, second);
    if (of_strength != Contrast::none) return of_strength;
    const bool are_alike = are_equal(a.shear, b.shear) && are_equal(a.constrained, b.constrained);
    return are_alike ? Contrast::none : Contrast::unlike;
}

} // namespace quicksand
