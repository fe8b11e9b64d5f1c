// How the liquefied sand of a cell settles as one [own].
//
// Why        Liquefied sand settles by per cents, and 0.1 % too much are 10 kPa once its own line has ended.
//            The particles of a cell differ by more than that: the strain of one across the border of two
//            cells is between theirs. Nodal forces know the sum over the cell alone.
// How        While the cell settles, the stresses of its liquefied particles approach the cell's mean, in
//            proportion to its s_0 + a, a what the cell carries above its mean s_0 by later loads, and their
//            compactions the same part of their lines:
//              sigma' += part ((s_0 + a) sum V sigma' / sum V (s_0 + a) - sigma')
//              part = d/(d + 0.01 s_0/K'), d = -dt V w
//            V the mean rate of volume change, w = V^2/(V^2 + D^2), D that of shear. Sums over the volume
//            stay, and no stress ratio exceeds the largest one there. Under shaking w is about zero, so that
//            it changes nothing of how sand liquefies.
#pragma once

#include "solver/particles/particles.hpp"
#include "solver/reconsolidation/compaction.hpp"

#include <cstdint>
#include <functional>
#include <span>

namespace quicksand {

/// What a law tells of liquefied sand.
struct SettlingSkeleton {
    double slope;                          // of whole_compaction() [-]
    std::function<double(double)> K_prime; // at a mean stress, d s over the volumetric strain [Pa]
};

template <class Law>
SettlingSkeleton settling_skeleton(const Law& law)
{
    return {reconsolidation_slope(law), [&law](double s) { return skeleton_at(law, s).K; }};
}

/// Let the stresses and compactions of the particles `points`, which are in one cell, approach each other
/// after a step of dt.
void even_reconsolidation(const SettlingSkeleton& skeleton, double dt, std::span<const std::int32_t> points,
                          const ShakingHistory& history, Particles& particles);

} // namespace quicksand
