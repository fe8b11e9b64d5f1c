// A stress of the specimen that the apparatus holds, by the strain that it needs.
#pragma once

#include "solver/base/failure.hpp"
#include "solver/element/specimen.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace quicksand {

/// Apply the strain for which `stress` of the new state has its value: the secant method within the closest
/// strains that are known to give too little and too much. `apply(unknown, specimen)` strains. A law
/// may divide a strain into a whole number of substeps, so that the stress jumps where that number changes,
/// by some 1e-5 with fixed substeps and by their tolerance, 1e-3 with PM4Sand, where their errors choose
/// them, of a tenth of the initial stress at least where little is left (`resolved_floors`): a value within a
/// jump is held as near as can be.
template <class Apply, class Stress>
void hold(double value, double stiffness, Apply&& apply, Stress&& stress, Specimen& specimen)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Specimen before = specimen;
    const double tolerance = 1e-9 * before.initial_vertical_stress,
                 jump = 1e-3 * std::max(std::abs(value), 0.1 * before.initial_vertical_stress);
    double too_small = -infinity, too_large = infinity;
    double unknown = 0.0, slope = stiffness, last_unknown = 0.0, last_error = 0.0, error = 0.0;
    for (int iteration = 0; iteration < 200; ++iteration) {
        specimen = before;
        apply(unknown, specimen);
        error = stress(specimen) - value;
        if (std::abs(error) < tolerance) return;
        (error < 0.0 ? too_small : too_large) = unknown;
        const double middle = 0.5 * (too_small + too_large);
        if (std::isfinite(middle) && (middle == too_small || middle == too_large)) break;
        if (iteration > 0 && unknown != last_unknown) {
            // a slope of the wrong sign or out of all reason belongs to another branch of the law
            slope = std::clamp((error - last_error) / (unknown - last_unknown), 0.02 * stiffness,
                               2.0 * stiffness);
        }
        last_unknown = unknown;
        last_error = error;
        unknown -= error / slope;
        const bool slow = iteration > 30; // the secant goes to and fro over a jump
        if (!(unknown > too_small && unknown < too_large) || (slow && std::isfinite(middle)))
            unknown = middle;
    }
    if (std::abs(error) < jump) return;
    std::ostringstream what;
    what << "the held stress is " << stress(specimen) << " Pa instead of " << value << " Pa";
    throw NumericalError({"element test", what.str(), "the specimen has lost its stiffness"});
}

} // namespace quicksand
