// UBCSAND for arrays of points: blocks of lanes that take a substep together, so that the compiler makes
// vectors of the kernel's arithmetic. A block without plastic lanes skips the return. Points that need more
// than one substep wait for a second round, where a lane that is done goes on with the next of them.
#if defined(__GNUC__) && !defined(__clang__)
// lets both sides of a choice be computed and keeps them from becoming branches again, and a block's few
// lanes from being copied by string instructions; changes no value
#pragma GCC optimize("no-trapping-math", "no-thread-jumps", "no-tree-loop-distribute-patterns")
#endif

#include "solver/base/lanes.hpp"
#include "solver/ubcsand/ubcsand.hpp"
#include "solver/ubcsand/ubcsand_flow.hpp"

namespace quicksand {

namespace {

using namespace ubcsand;

constexpr std::size_t width = 8;     // lanes of a block [-]
constexpr std::size_t segment = 512; // most points that wait for their second substep [-]

/// The points of a block, one array per quantity. Lanes beyond the last point are closed.
struct Block {
    double sigma_x[width], sigma_y[width], sigma_z[width], tau_xy[width];
    double eta_max[width], branch[width], peak_x[width], peak_y[width], origin_x[width], origin_y[width];
    double leg_x[width], leg_y[width], back_x[width], back_y[width], last_leg[width], waiting[width];
    double half_cycles[width], dilation[width], active_dilation[width];
    double least_contraction[width], most_contraction[width];
    double strain_x[width], strain_y[width], strain_xy[width]; // what remains
    double budget[width];                                      // substeps left
    double open[width];                                        // 1 until the last substep is done

    UbcSandState state(std::size_t k) const
    {
        return {sigma_x[k],         sigma_y[k],     sigma_z[k],  tau_xy[k],          eta_max[k],
                branch[k],          peak_x[k],      peak_y[k],   origin_x[k],        origin_y[k],
                leg_x[k],           leg_y[k],       back_x[k],   back_y[k],          last_leg[k],
                waiting[k],         half_cycles[k], dilation[k], active_dilation[k], least_contraction[k],
                most_contraction[k]};
    }

    void set(std::size_t k, bool condition, const UbcSandState& state)
    {
        sigma_x[k] = select(condition, state.sigma_x, sigma_x[k]);
        sigma_y[k] = select(condition, state.sigma_y, sigma_y[k]);
        sigma_z[k] = select(condition, state.sigma_z, sigma_z[k]);
        tau_xy[k] = select(condition, state.tau_xy, tau_xy[k]);
        eta_max[k] = select(condition, state.eta_max, eta_max[k]);
        branch[k] = select(condition, state.branch, branch[k]);
        peak_x[k] = select(condition, state.peak_x, peak_x[k]);
        peak_y[k] = select(condition, state.peak_y, peak_y[k]);
        origin_x[k] = select(condition, state.origin_x, origin_x[k]);
        origin_y[k] = select(condition, state.origin_y, origin_y[k]);
        leg_x[k] = select(condition, state.leg_x, leg_x[k]);
        leg_y[k] = select(condition, state.leg_y, leg_y[k]);
        back_x[k] = select(condition, state.back_x, back_x[k]);
        back_y[k] = select(condition, state.back_y, back_y[k]);
        last_leg[k] = select(condition, state.last_leg, last_leg[k]);
        waiting[k] = select(condition, state.waiting, waiting[k]);
        half_cycles[k] = select(condition, state.half_cycles, half_cycles[k]);
        dilation[k] = select(condition, state.dilation, dilation[k]);
        active_dilation[k] = select(condition, state.active_dilation, active_dilation[k]);
    }
};

/// The trials of a block between their making and the return.
struct TrialBlock {
    double G[width], B[width], s_old[width], s_start[width], per_s[width];
    double start_x[width], start_y[width];
    double s[width], q_x[width], q_y[width], t[width], sigma_z[width];
    double volumetric[width], shear_x[width], shear_y[width], eta_y[width], branch[width], least_D[width],
        most_D[width], plastic[width];

    void set(std::size_t k, const Trial& trial, double is_plastic)
    {
        G[k] = trial.start.moduli.G, B[k] = trial.start.moduli.B;
        s_old[k] = trial.start.s_old, s_start[k] = trial.start.s;
        per_s[k] = trial.start.per_s;
        start_x[k] = trial.start.q_x, start_y[k] = trial.start.q_y;
        s[k] = trial.s, q_x[k] = trial.q_x, q_y[k] = trial.q_y, t[k] = trial.t, sigma_z[k] = trial.sigma_z;
        volumetric[k] = trial.volumetric, shear_x[k] = trial.shear_x, shear_y[k] = trial.shear_y;
        eta_y[k] = trial.eta_y, branch[k] = trial.branch;
        least_D[k] = trial.least_D, most_D[k] = trial.most_D;
        plastic[k] = is_plastic;
    }

    Trial trial(const UbcSand& law, std::size_t k) const
    {
        Trial trial{};
        trial.start = {moduli_of(G[k], B[k]),
                       s_old[k],
                       s_start[k],
                       s_start[k] + law.a,
                       per_s[k],
                       0.0, // only reversals, which are noticed elastically, ask for 1/sb
                       start_x[k],
                       start_y[k],
                       start_x[k] * start_x[k] + start_y[k] * start_y[k]};
        trial.s = s[k], trial.q_x = q_x[k], trial.q_y = q_y[k], trial.t = t[k], trial.sigma_z = sigma_z[k];
        trial.volumetric = volumetric[k], trial.shear_x = shear_x[k], trial.shear_y = shear_y[k];
        trial.eta_y = eta_y[k], trial.branch = branch[k];
        trial.least_D = least_D[k], trial.most_D = most_D[k];
        return trial;
    }
};

inline double sum(const double (&values)[width])
{
    double total = 0.0;
    for (const double value : values) total += value;
    return total;
}

/// [2] to [7] of one substep; elastic lanes are finished. Returns the number of plastic lanes.
template <bool square_roots, Integration order>
inline double step_elastically(const UbcSand& law, Block& block, TrialBlock& trials)
{
    for (std::size_t k = 0; k < width; ++k) {
        UbcSandState state = block.state(k);
        Strain remaining = {block.strain_x[k], block.strain_y[k], block.strain_xy[k]};
        const Substep substep = next_substep<square_roots, order>(law, state, block.budget[k], remaining);
        const Trial trial = elastic_trial<order>(law, state, substep.start, substep.strain);
        const double plastic = select(trial.plastic, block.open[k], 0.0);
        finish_elastic(law, trial, state);
        block.set(k, block.open[k] > plastic, state);
        trials.set(k, trial, plastic);
        block.strain_x[k] = remaining.x, block.strain_y[k] = remaining.y, block.strain_xy[k] = remaining.xy;
        block.budget[k] -= 1.0;
        block.open[k] = select(substep.last, 0.0, block.open[k]);
    }
    return sum(trials.plastic);
}

/// [8] to [10] of the plastic lanes.
template <Integration order>
inline void flow_plastically(const UbcSand& law, Block& block, const TrialBlock& trials)
{
    for (std::size_t k = 0; k < width; ++k) {
        UbcSandState state = block.state(k);
        finish_plastic<order>(law, trials.trial(law, k), state);
        block.set(k, trials.plastic[k] > 0.0, state);
    }
}

template <bool square_roots, Integration order>
inline void take_substep(const UbcSand& law, Block& block)
{
    TrialBlock trials;
    if (step_elastically<square_roots, order>(law, block, trials) > 0.0) {
        flow_plastically<order>(law, block, trials);
    }
}

/// D may be negative but in the loosest sand, and positive but in the densest.
inline void bound_contraction(const UbcSand& law, const UbcSandArrays& points, std::size_t p, std::size_t k,
                              Block& block)
{
    const double volume = points.volume[p], mass = points.mass_solid[p];
    block.least_contraction[k] = select(volume > law.largest_specific_volume * mass, 0.0, -1.0);
    block.most_contraction[k] = select(volume < law.smallest_specific_volume * mass, 0.0, 1.0);
}

/// Put point p into lane k: compression-positive strain and its state.
inline void load(const UbcSand& law, const UbcSandArrays& points, std::size_t p, double dt, std::size_t k,
                 Block& block)
{
    UbcSandState state = points.state(p);
    bound_contraction(law, points, p, k, block);
    state.least_contraction = block.least_contraction[k];
    block.set(k, true, state);
    const Strain strain = borne(
        law, state, {-dt * points.L_xx[p], -dt * points.L_yy[p], -dt * (points.L_xy[p] + points.L_yx[p])});
    block.strain_x[k] = strain.x, block.strain_y[k] = strain.y, block.strain_xy[k] = strain.xy;
    block.budget[k] = most_substeps;
    block.open[k] = 1.0;
}

/// Put `count` points from p on into the lanes.
inline void load(const UbcSand& law, const UbcSandArrays& points, std::size_t p, std::size_t count, double dt,
                 Block& block)
{
    if (count == width) { // a known count makes vectors
        for (std::size_t k = 0; k < width; ++k) load(law, points, p + k, dt, k, block);
        return;
    }
    for (std::size_t k = 0; k < count; ++k) load(law, points, p + k, dt, k, block);
    for (std::size_t k = count; k < width; ++k) block.open[k] = 0.0;
}

inline void store(const Block& block, std::size_t p, std::size_t count, const UbcSandArrays& points)
{
    if (count == width) {
#pragma GCC ivdep // the arrays do not overlap
        for (std::size_t k = 0; k < width; ++k) points.set(p + k, block.state(k));
        return;
    }
    for (std::size_t k = 0; k < count; ++k) points.set(p + k, block.state(k));
}

/// Points with strain left after their first substep.
struct Unfinished {
    std::size_t point[segment];
    Strain strain[segment]; // what remains
    std::size_t count = 0;
};

inline void note_unfinished(const Block& block, std::size_t p, std::size_t count, Unfinished& unfinished)
{
    if (sum(block.open) == 0.0) return;
    for (std::size_t k = 0; k < count; ++k) {
        if (block.open[k] == 0.0) continue;
        unfinished.point[unfinished.count] = p + k;
        unfinished.strain[unfinished.count] = {block.strain_x[k], block.strain_y[k], block.strain_xy[k]};
        ++unfinished.count;
    }
}

/// Put an unfinished point into a lane.
inline void load(const UbcSand& law, const UbcSandArrays& points, const Unfinished& unfinished, std::size_t i,
                 std::size_t k, Block& block)
{
    block.set(k, true, points.state(unfinished.point[i]));
    bound_contraction(law, points, unfinished.point[i], k, block);
    const Strain& strain = unfinished.strain[i];
    block.strain_x[k] = strain.x, block.strain_y[k] = strain.y, block.strain_xy[k] = strain.xy;
    block.budget[k] = most_substeps - 1.0;
    block.open[k] = 1.0;
}

/// The substeps after the first, in lanes that are filled anew as soon as their point is done.
template <bool square_roots, Integration order>
inline void finish(const UbcSand& law, const Unfinished& unfinished, const UbcSandArrays& points)
{
    Block block{};
    std::size_t in_lane[width];
    const std::size_t lanes = unfinished.count < width ? unfinished.count : width;
    for (std::size_t k = 0; k < lanes; ++k) load(law, points, unfinished, in_lane[k] = k, k, block);
    std::size_t next = lanes;
    for (std::size_t left = unfinished.count; left > 0;) {
        take_substep<square_roots, order>(law, block);
        for (std::size_t k = 0; k < lanes; ++k) {
            if (block.open[k] > 0.0 || in_lane[k] == unfinished.count) continue;
            points.set(unfinished.point[in_lane[k]], block.state(k));
            --left;
            in_lane[k] = next;
            if (next < unfinished.count) load(law, points, unfinished, next++, k, block);
        }
    }
}

template <bool square_roots, Integration order>
inline void advance_points(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                           const UbcSandArrays& points)
{
    Block block{};
    Unfinished unfinished;
    for (std::size_t p = first; p < last; p += width) {
        const std::size_t count = last - p < width ? last - p : width;
        load(law, points, p, count, dt, block);
        take_substep<square_roots, order>(law, block);
        store(block, p, count, points);
        note_unfinished(block, p, count, unfinished);
        if (unfinished.count + width > segment || p + count == last) {
            finish<square_roots, order>(law, unfinished, points);
            unfinished.count = 0;
        }
    }
}

WIDE_VECTOR_KERNEL
void advance_first_order(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                         const UbcSandArrays& points)
{
    advance_points<false, Integration::first_order>(law, dt, first, last, points);
}

/// With the exponents of the generic set.
WIDE_VECTOR_KERNEL
void advance_generic_first_order(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                                 const UbcSandArrays& points)
{
    advance_points<true, Integration::first_order>(law, dt, first, last, points);
}

WIDE_VECTOR_KERNEL
void advance_second_order(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                          const UbcSandArrays& points)
{
    advance_points<false, Integration::second_order>(law, dt, first, last, points);
}

WIDE_VECTOR_KERNEL
void advance_generic_second_order(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                                  const UbcSandArrays& points)
{
    advance_points<true, Integration::second_order>(law, dt, first, last, points);
}

} // namespace

void update(const UbcSand& law, double dt, std::size_t first, std::size_t last, const UbcSandArrays& points)
{
    if (law.integration == Integration::first_order) {
        (law.square_roots ? advance_generic_first_order : advance_first_order)(law, dt, first, last, points);
    } else {
        (law.square_roots ? advance_generic_second_order : advance_second_order)(law, dt, first, last,
                                                                                 points);
    }
}

VECTOR_KERNEL
ParticleModuli particle_moduli(const UbcSand& law, std::size_t first, std::size_t last,
                               const double* stress_xx, const double* stress_yy, const double* volume)
{
    return collect_moduli(first, last, volume, [&](std::size_t p) {
        const double s = larger(law.s_min, -0.5 * (stress_xx[p] + stress_yy[p]));
        return law.square_roots ? elastic_moduli<true>(law, s).E1 : elastic_moduli<false>(law, s).E1;
    });
}

} // namespace quicksand
