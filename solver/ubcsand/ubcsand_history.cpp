#include "solver/ubcsand/ubcsand_history.hpp"

#include "solver/ubcsand/ubcsand_kernel.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

constexpr double most_shear = 0.08;           // that counts for reconsolidation [-] [YWS06]
constexpr double liquefied_stress = 0.1;      // of s_0, at which sand has liquefied [-]
constexpr double least_distance = 0.02;       // of root s to root s_0, over the latter [-]
constexpr double conductivity_exponent = 8.9; // of ru [-] [Sha12]

double mean_stress_of(const UbcSand& law, const Particles& particles, std::size_t p)
{
    return std::max(law.s_min, -0.5 * (particles.stress.xx[p] + particles.stress.yy[p]));
}

void note_shear(double x, double y, double mean_stress, double floor, std::size_t p,
                const UbcSandHistory& history)
{
    history.shear_x[p] += x;
    history.shear_y[p] += y;
    const double size = std::hypot(history.shear_x[p], history.shear_y[p]);
    history.largest_shear[p] = std::max(history.largest_shear[p], size);
    constexpr double rounding = 1.0 + 1e-9;
    if (mean_stress <= std::max(liquefied_stress * history.start_mean[p], floor * rounding))
        history.liquefied_shear[p] = history.largest_shear[p];
}

} // namespace

void begin_history(const UbcSandState& start, std::size_t p, const UbcSandHistory& history)
{
    history.start_factor[p] = start.start_factor;
    history.start_mean[p] = 0.5 * (start.sigma_x + start.sigma_y);
    history.shear_x[p] = history.shear_y[p] = 0.0;
    history.largest_shear[p] = history.liquefied_shear[p] = history.compaction[p] = 0.0;
}

double whole_compaction(const UbcSand& law, std::size_t p, const UbcSandHistory& history)
{
    return law.reconsolidation * std::min(history.liquefied_shear[p], most_shear);
}

double compaction_of(const UbcSand& law, double strain, double s, std::size_t p,
                     const UbcSandHistory& history)
{
    const double whole = whole_compaction(law, p, history);
    const double pending = whole - history.compaction[p];
    if (!(strain > 0.0 && pending > 0.0)) return 0.0;
    // in y = root s both ways are straight: elastic d eps = (2 y/K') dy, on the line d eps = (... + c) dy
    const double y = std::sqrt(s), y_0 = std::sqrt(history.start_mean[p]);
    const double per_y = 2.0 * y / ubcsand::moduli_at(law, s).K;
    const double from = std::max(y, y_0 * history.compaction[p] / whole);
    const double on_line = std::max(0.0, strain - per_y * (from - y));
    const double c = pending / std::max(y_0 - from, least_distance * y_0);
    return std::min(pending, on_line * c / (per_y + c));
}

void advance_history(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                     const Particles& particles, const UbcSandHistory& history, double* L_xx, double* L_yy)
{
    const Gradients& L = particles.velocity_gradient_solid;
    for (std::size_t p = first; p < last; ++p) {
        const double s = mean_stress_of(law, particles, p);
        note_shear(dt * (L.xx[p] - L.yy[p]), dt * (L.xy[p] + L.yx[p]), s, law.s_min, p, history);
        const double strain = -dt * (L.xx[p] + L.yy[p]);
        const double compaction = compaction_of(law, strain, s, p, history);
        history.compaction[p] += compaction;
        L_xx[p - first] = L.xx[p];
        L_yy[p - first] = L.yy[p];
        if (compaction <= 0.0) continue;
        // elastic strain of K_0 = 1/2: dq_x = -ds/3 needs eps_x - eps_y = -K'/(3G) eps_v
        const ubcsand::Moduli stiffest = ubcsand::moduli_at(law, s);
        const ubcsand::Moduli m = ubcsand::moduli_of(law.least_fraction * stiffest.G, stiffest.B);
        const double excess = std::max(0.0, 1.0 - m.K / (3.0 * m.G));
        const double sideways = 0.5 * excess * (strain - compaction) * compaction / strain;
        L_xx[p - first] -= sideways / dt;
        L_yy[p - first] += (compaction + sideways) / dt;
    }
}

double conductivity_factor(const UbcSand& law, double s, double start_mean)
{
    // counted from the floor, so that sand at the floor floats however little stress it had
    const double lost = start_mean - s, whole = start_mean - law.s_min;
    const double ru = whole > 0.0 ? std::clamp(lost / whole, 0.0, 1.0) : 1.0;
    return 1.0 + (law.liquefied_conductivity - 1.0) * std::pow(ru, conductivity_exponent);
}

} // namespace quicksand
