// How the volume of liquefied sand falls as it carries its stress again, beside the strain of its own law.
//
// The compaction belongs to a line, root(s/s_0) of whole_compaction() at a mean stress s, s_0 that of the
// start: the stiffness on it is that of the elastic law over a constant. Below the line the sand is elastic,
// so that ripples do not compact it. A point above the line, which dilation has carried there, catches up on
// the way to s_0. The compaction is vertical, and what remains of the strain leads to K_0 = 1/2 [own].
//
// A law has
//   reconsolidation_slope(law)   volumetric strain per largest shear strain [-]
//   least_mean_stress(law)       its floor [Pa]
//   skeleton_at(law, s)          its elasticity in the plane at a mean stress s
#pragma once

#include "solver/reconsolidation/shaking_history.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quicksand {

struct PlaneSkeleton {
    double K;         // d s over the volumetric strain, without flow [Pa]
    double K_over_3G; // with the shear modulus that loading meets [-]
};

/// The compaction [-] that a volumetric strain [-] brings at a mean stress s [Pa], all positive in
/// compression.
template <class Law>
double compaction_of(const Law& law, double strain, double s, std::size_t p, const ShakingHistory& history)
{
    constexpr double least_distance = 0.02; // of root s to root s_0, over the latter [-]
    const double whole = whole_compaction(reconsolidation_slope(law), p, history);
    const double pending = whole - history.compaction[p];
    if (!(strain > 0.0 && pending > 0.0)) return 0.0;
    // in y = root s both ways are straight: elastic d eps = (2 y/K') dy, on the line d eps = (... + c) dy
    const double y = std::sqrt(s), y_0 = std::sqrt(history.start_mean[p]);
    const double per_y = 2.0 * y / skeleton_at(law, s).K;
    const double from = std::max(y, y_0 * history.compaction[p] / whole);
    const double on_line = std::max(0.0, strain - per_y * (from - y));
    const double c = pending / std::max(y_0 - from, least_distance * y_0);
    return std::min(pending, on_line * c / (per_y + c));
}

/// Strains of a run of particles, as the velocity gradient's parts [1/s].
struct NormalRates {
    static constexpr std::size_t most = 512; // particles, as many as the processor keeps at hand
    std::array<double, most> xx, yy;
};

/// Advance the history of at most NormalRates::most points [first, last) by the velocity gradient of the
/// grains over dt, and write the rates without compaction, which begin with the first point.
template <class Law>
void advance_history(const Law& law, double dt, std::size_t first, std::size_t last,
                     const Particles& particles, const ShakingHistory& history, NormalRates& rates)
{
    const Gradients& L = particles.velocity_gradient_solid;
    const double floor = least_mean_stress(law);
    for (std::size_t p = first; p < last; ++p) {
        const double s = std::max(floor, -0.5 * (particles.stress.xx[p] + particles.stress.yy[p]));
        note_shear(dt * (L.xx[p] - L.yy[p]), dt * (L.xy[p] + L.yx[p]), s, floor, p, history);
        const double strain = -dt * (L.xx[p] + L.yy[p]);
        const double compaction = compaction_of(law, strain, s, p, history);
        history.compaction[p] += compaction;
        rates.xx[p - first] = L.xx[p];
        rates.yy[p - first] = L.yy[p];
        if (compaction <= 0.0) continue;
        // elastic strain of K_0 = 1/2: dq_x = -ds/3 needs eps_x - eps_y = -K'/(3G) eps_v
        const double excess = std::max(0.0, 1.0 - skeleton_at(law, s).K_over_3G);
        const double sideways = 0.5 * excess * (strain - compaction) * compaction / strain;
        rates.xx[p - first] -= sideways / dt;
        rates.yy[p - first] += (compaction + sideways) / dt;
    }
}

} // namespace quicksand
