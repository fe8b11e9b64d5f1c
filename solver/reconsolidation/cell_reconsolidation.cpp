#include "solver/reconsolidation/cell_reconsolidation.hpp"

#include <algorithm>

namespace quicksand {

namespace {

constexpr double elastic_fraction = 0.01; // of s_0/K', the strain over which differences fade [-]

/// Sums over the liquefied particles of a cell.
struct LiquefiedCell {
    double volume = 0.0;                           // V [m3/m]
    double growth = 0.0;                           // V tr L [m3/s per metre]
    double shear_x = 0.0, shear_y = 0.0;           // V (L_xx - L_yy) and V (L_xy + L_yx) [m3/s per metre]
    double start = 0.0;                            // V s_0 [N]
    double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0; // V sigma' [N]
    double whole = 0.0, compaction = 0.0; // V times the strain of the line and of what is done [m3/m]
};

template <class Visit>
void for_each_liquefied(std::span<const std::int32_t> points, const ShakingHistory& history, Visit&& visit)
{
    for (const std::int32_t point : points) {
        const auto p = static_cast<std::size_t>(point);
        if (history.liquefied_shear[p] > 0.0) visit(p);
    }
}

LiquefiedCell sum_liquefied(double slope, std::span<const std::int32_t> points, const ShakingHistory& history,
                            const Particles& particles)
{
    const Gradients& L = particles.velocity_gradient_solid;
    const SymmetricTensors& stress = particles.stress;
    LiquefiedCell cell;
    for_each_liquefied(points, history, [&](std::size_t p) {
        const double V = particles.volume[p];
        cell.volume += V;
        cell.growth += V * (L.xx[p] + L.yy[p]);
        cell.shear_x += V * (L.xx[p] - L.yy[p]);
        cell.shear_y += V * (L.xy[p] + L.yx[p]);
        cell.start += V * history.start_mean[p];
        cell.xx += V * stress.xx[p];
        cell.yy += V * stress.yy[p];
        cell.zz += V * stress.zz[p];
        cell.xy += V * stress.xy[p];
        cell.whole += V * whole_compaction(slope, p, history);
        cell.compaction += V * history.compaction[p];
    });
    return cell;
}

/// The part of the differences in a cell that fades in a step of dt [-].
double fading_part(const SettlingSkeleton& skeleton, double dt, const LiquefiedCell& cell)
{
    if (!(cell.growth < 0.0)) return 0.0;
    const double squared = cell.growth * cell.growth;
    const double sheared = cell.shear_x * cell.shear_x + cell.shear_y * cell.shear_y;
    const double strain = -dt * cell.growth / cell.volume * squared / (squared + sheared);
    const double s_0 = cell.start / cell.volume;
    return strain / (strain + elastic_fraction * s_0 / skeleton.K_prime(s_0));
}

} // namespace

void even_reconsolidation(const SettlingSkeleton& skeleton, double dt, std::span<const std::int32_t> points,
                          const ShakingHistory& history, Particles& particles)
{
    const LiquefiedCell cell = sum_liquefied(skeleton.slope, points, history, particles);
    const double part = fading_part(skeleton, dt, cell);
    if (part <= 0.0) return;
    SymmetricTensors& stress = particles.stress;
    const double done = cell.compaction / cell.whole;
    const double added = std::max(0.0, -0.5 * (cell.xx + cell.yy) - cell.start) / cell.volume;
    for_each_liquefied(points, history, [&](std::size_t p) {
        const double share = (history.start_mean[p] + added) / (cell.start + cell.volume * added);
        stress.xx[p] += part * (share * cell.xx - stress.xx[p]);
        stress.yy[p] += part * (share * cell.yy - stress.yy[p]);
        stress.zz[p] += part * (share * cell.zz - stress.zz[p]);
        stress.xy[p] += part * (share * cell.xy - stress.xy[p]);
        history.compaction[p] +=
            part * (done * whole_compaction(skeleton.slope, p, history) - history.compaction[p]);
    });
}

} // namespace quicksand
