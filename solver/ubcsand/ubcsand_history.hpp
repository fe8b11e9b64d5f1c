// What a point of UBCSAND remembers of the whole shaking, and what follows from it when it has liquefied: its
// volume falls as the water leaves, and its conductivity is larger as long as the grains float.
//
// Reconsolidation  By [YWS06] liquefied sand settles by slope min(gamma_max, 8 %) until it carries its stress
//            again. The compaction belongs to a line, root(s/s_0) of the whole at a mean stress s, s_0 that
//            of the start: the stiffness on it is that of the elastic law over a constant. Below the line the
//            sand is elastic, so that ripples do not compact it. A point above the line, which dilation has
//            carried there, catches up on the way to s_0. The compaction is vertical, and what remains of the
//            strain leads to K_0 = 1/2 [own].
// Conductivity  k grows by 1 + (factor - 1) ru^8.9, as [Sha12] let it fall; ru is the part of s_0 above the
//            floor that is lost. They let it grow by ru^1.0: then sand of ru = 0.4 drains 2.6 times faster at
//            unchanged voids, and slopes shaken a little less do not liquefy at all [own].
#pragma once

#include "solver/particles/particles.hpp"
#include "solver/ubcsand/ubcsand_point.hpp"

#include <cstddef>

namespace quicksand {

/// The columns of the particles, one number each.
struct UbcSandHistory {
    double* start_factor;      // of the plastic modulus [-]
    double* start_mean;        // s_0 [Pa]
    double *shear_x, *shear_y; // strain since the start, eps_x - eps_y and gamma_xy, tension positive [-]
    double* largest_shear;     // its largest size [-]
    double* liquefied_shear;   // the same when the sand last had liquefied; 0: it has not [-]
    double* compaction;        // volumetric strain of reconsolidation so far [-]
};

/// Begin with the state of the start of shaking.
void begin_history(const UbcSandState& start, std::size_t p, const UbcSandHistory& history);

/// The compaction [-] of the whole reconsolidation line of a point.
double whole_compaction(const UbcSand& law, std::size_t p, const UbcSandHistory& history);

/// The compaction [-] that a volumetric strain [-] brings at a mean stress s [Pa], all positive in
/// compression.
double compaction_of(const UbcSand& law, double strain, double s, std::size_t p,
                     const UbcSandHistory& history);

/// Advance the history of the points [first, last) by the velocity gradient of the grains over dt, and write
/// the velocity gradient without compaction to L_xx and L_yy, which begin with the first point [1/s].
void advance_history(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                     const Particles& particles, const UbcSandHistory& history, double* L_xx, double* L_yy);

/// k over that of sand at rest, at a mean stress s and one of s_0 at the start [Pa] [-].
double conductivity_factor(const UbcSand& law, double s, double start_mean);

} // namespace quicksand
