// The lengths of the substeps of PM4Sand: the whole strain first; what errs too much is tried again, shorter.
#pragma once

#include "solver/pm4sand/pm4sand_substep.hpp"

namespace quicksand::pm4sand {

inline constexpr double most_substeps = 2000.0; // attempts of a strain, the last of which takes the rest [-]
inline constexpr double least_fraction = 1e-4;  // of the strain, which is taken whatever its error [-]

/// No contact between grains: at the stress floor, looser than the loosest sand.
inline bool apart(const Pm4Sand& m, const Pm4SandState& state)
{
    const double floor = floor_factor * state.least_stress;
    return (0.5 * (state.sigma_x + state.sigma_y) <= floor * (1.0 + 1e-9)) &
           (state.void_ratio > m.largest_void_ratio);
}

/// How far a strain is done.
struct Progress {
    double done = 0.0;             // of it [-]
    double size = 1.0;             // of the next substep, over the whole [-]
    double budget = most_substeps; // attempts left [-]
};

/// The part of a strain that is tried next [-].
inline double next_fraction(const Pm4Sand& m, const Progress& progress, const Pm4SandState& state)
{
    const double rest = 1.0 - progress.done, size = smaller(progress.size, rest);
    return select(progress.budget <= 1.0, rest, select(apart(m, state), rest, size));
}

/// The state after a try with that error, if it stands. A strain that is done changes nothing.
inline Pm4SandState accept(const Pm4Sand& m, double volumetric, double fraction, double error,
                           const Pm4SandState& next, Progress& progress, const Pm4SandState& before)
{
    const bool loose = apart(m, before);
    const double excess = select(loose, 0.0, select(progress.budget <= 1.0, 0.0, error));
    const double judged = select(fraction <= least_fraction, 0.0, excess);
    const bool stands = judged + select(progress.done < 1.0, 0.0, 1e9) <= m.stress_tolerance;
    const double opened = before.void_ratio - (1.0 + before.void_ratio) * fraction * volumetric;
    const double growth =
        smaller(4.0, larger(0.1, 0.8 * std::sqrt(m.stress_tolerance / larger(excess, 1e-30))));
    const double done = select(fraction >= 1.0 - progress.done, 1.0, progress.done + fraction);
    progress.done = select(stands, done, progress.done);
    progress.size = larger(least_fraction, fraction * growth);
    progress.budget -= 1.0;
    Pm4SandState after = select(stands, select(loose, before, next), before);
    after.void_ratio = select(stands, select(loose, opened, next.void_ratio), before.void_ratio);
    return after;
}

inline void advance_in_substeps(const Pm4Sand& m, const Strain& strain, Pm4SandState& state)
{
    for (Progress progress; progress.done < 1.0;) {
        const double fraction = next_fraction(m, progress, state);
        const Strain part = part_of(strain, fraction);
        const Contact contact = reach_surface(m, state, part);
        Pm4SandState memory = state;
        remember_reversal(contact.at, direction_of(contact.at), memory);
        const Strain rest = part_of(part, 1.0 - contact.elastic);
        const Point first = plastic_change(m, memory, contact.at, contact.at, rest);
        const End end = finish(m, memory, contact, first, part);
        const Pm4SandState next = state_at(end, contact.elastic < 1.0, memory, state);
        state = accept(m, strain.volumetric, fraction, end.error, next, progress, state);
    }
}

} // namespace quicksand::pm4sand
