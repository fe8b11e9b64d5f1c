// UBCSAND for arrays of points: blocks of lanes that take a substep together, so that the compiler makes
// vectors of the kernel's arithmetic. A block without plastic lanes skips the return. Points that need more
// than one substep wait for a second round, where a lane that is done goes on with the next of them; that
// round alone looks for the events at which substeps of second order end.
#if defined(__GNUC__) && !defined(__clang__)
// lets both sides of a choice be computed and keeps them from becoming branches again, and a block's few
// lanes from being copied by string instructions; changes no value
#pragma GCC optimize("no-trapping-math", "no-thread-jumps", "no-tree-loop-distribute-patterns")
#endif

#include "solver/base/lanes.hpp"
#include "solver/particles/particles.hpp"
#include "solver/ubcsand/ubcsand.hpp"
#include "solver/ubcsand/ubcsand_blocks.hpp"

namespace quicksand {

namespace {

using namespace ubcsand;

constexpr std::size_t segment = 512; // most points that wait for their second substep [-]

inline double sum(const double (&values)[width])
{
    double total = 0.0;
    for (const double value : values) total += value;
    return total;
}

/// [2] to [7] of one substep of first order; elastic lanes are finished. Returns the number of plastic lanes.
template <ElasticForm form>
inline double step_elastically(const UbcSand& law, Block& block, TrialBlock& trials)
{
    for (std::size_t k = 0; k < width; ++k) {
        UbcSandState state = block.state(k);
        const Strain remaining = block.strain(k);
        const Start start = start_of<form>(law, state);
        const double fraction = fixed_fraction(law, start, remaining, block.budget[k]);
        const Strain strain = part_of(remaining, fraction);
        const Trial trial = elastic_trial<Integration::first_order, form>(law, state, start, strain);
        const double plastic = select(trial.plastic, block.open[k], 0.0);
        finish_elastic(law, trial, state);
        block.set(k, block.open[k] > plastic, state);
        trials.set(k, trial, plastic);
        block.set_strain(k, rest_of(remaining, strain));
        block.budget[k] -= 1.0;
        block.open[k] = select(fraction >= 1.0, 0.0, block.open[k]);
    }
    return sum(trials.plastic);
}

/// [8] to [10] of the plastic lanes.
template <Locking locking>
inline void flow_in_first_order(const UbcSand& law, Block& block, const TrialBlock& trials)
{
    for (std::size_t k = 0; k < width; ++k) {
        UbcSandState state = block.state(k);
        finish_in_first_order<locking>(law, trials.trial(law, k), state);
        block.set(k, trials.plastic[k] > 0.0, state);
    }
}

template <ElasticForm form>
inline void step_in_first_order(const UbcSand& law, Block& block)
{
    TrialBlock trials;
    if (!(step_elastically<form>(law, block, trials) > 0.0)) return;
    if (locking_of(law) == Locking::none) return flow_in_first_order<Locking::none>(law, block, trials);
    flow_in_first_order<Locking::by_dilation>(law, block, trials);
}

/// Which substep of second order: the first one, of the whole strain, or one to the next event.
enum class Round { first, later };

/// [2] to [7] of a substep of second order, but for its end. gcc 12 keeps structures that are constant in
/// memory here, where they would not become vectors.
template <ElasticForm form, Round round>
inline void make_trials(const UbcSand& law, const Block& block, TrialBlock& trials, VerdictBlock& verdicts)
{
    for (std::size_t k = 0; k < width; ++k) {
        const UbcSandState state = block.state(k);
        const Strain remaining = block.strain(k);
        Start start = start_of<form>(law, state);
        double fraction = 1.0;
        if constexpr (round == Round::later) {
            fraction = next_fraction(law, start, state, remaining, block.size[k], block.budget[k]);
        }
        const Strain strain = part_of(remaining, fraction);
        Trial trial = elastic_trial<Integration::second_order, form>(law, state, start, strain);
        trials.set(k, trial, select(trial.plastic, block.open[k], 0.0));
        verdicts.fraction[k] = fraction;
        verdicts.elastic_event[k] = verdicts.plastic_event[k] = 0.0;
    }
}

/// What the whole strains of a block may meet.
inline void note_events(const UbcSand& law, const Block& block, const TrialBlock& trials,
                        VerdictBlock& verdicts)
{
    for (std::size_t k = 0; k < width; ++k) {
        const Events events = events_of(law, trials.trial(law, k), block.state(k));
        verdicts.elastic_event[k] = events.elastic;
        verdicts.plastic_event[k] = events.plastic;
    }
}

/// [7] of the elastic lanes: those that stand are finished.
inline void try_elastically(const UbcSand& law, Block& block, const TrialBlock& trials,
                            VerdictBlock& verdicts)
{
    for (std::size_t k = 0; k < width; ++k) {
        UbcSandState next = block.state(k);
        const Trial trial = trials.trial(law, k);
        finish_elastic(law, trial, next);
        Verdict verdict = judge_elastic(law, trial, verdicts.elastic_event[k]);
        verdict.excess = select(block.budget[k] <= 1.0, 0.0, verdict.excess);
        const double elastic = block.open[k] - trials.plastic[k];
        block.set(k, verdict.excess + 2.0 * (1.0 - elastic) <= 1.0, next);
        verdicts.set(k, true, verdict);
    }
}

/// [8] to [10] of the plastic lanes, of which those that stand are finished.
template <Locking locking>
inline void try_plastically(const UbcSand& law, Block& block, const TrialBlock& trials,
                            VerdictBlock& verdicts)
{
    for (std::size_t k = 0; k < width; ++k) {
        const Trial trial = trials.trial(law, k);
        UbcSandState next = block.state(k);
        double error = 0.0;
        finish_in_second_order<locking>(law, trial, next, error);
        Verdict verdict = judge_plastic<locking>(law, trial, error, verdicts.plastic_event[k], next);
        verdict.excess = select(block.budget[k] <= 1.0, 0.0, verdict.excess);
        const double plastic = trials.plastic[k];
        block.set(k, verdict.excess + 2.0 * (1.0 - plastic) <= 1.0, next);
        verdicts.set(k, plastic > 0.0, verdict);
    }
}

/// Try a substep of second order in every lane, and take the strain off that it has used.
template <ElasticForm form, Round round>
inline void try_block_substep(const UbcSand& law, Block& block)
{
    TrialBlock trials;
    VerdictBlock verdicts;
    make_trials<form, round>(law, block, trials, verdicts);
    if constexpr (round == Round::first) note_events(law, block, trials, verdicts);
    const double plastic = sum(trials.plastic);
    if (plastic < width) try_elastically(law, block, trials, verdicts);
    if (plastic > 0.0 && locking_of(law) == Locking::none)
        try_plastically<Locking::none>(law, block, trials, verdicts);
    else if (plastic > 0.0)
        try_plastically<Locking::by_dilation>(law, block, trials, verdicts);
    for (std::size_t k = 0; k < width; ++k) {
        const Verdict verdict = {verdicts.excess[k], verdicts.longer[k]};
        const double fraction = verdicts.fraction[k];
        const Strain remaining = block.strain(k);
        block.set_strain(k, rest_of(remaining, part_of(remaining, select(verdict.stands(), fraction, 0.0))));
        block.size[k] = next_size(verdict, fraction);
        block.budget[k] -= 1.0;
        block.open[k] = select(verdict.stands() & (fraction >= 1.0), 0.0, block.open[k]);
    }
}

template <ElasticForm form, Integration order, Round round>
inline void take_substep(const UbcSand& law, Block& block)
{
    if constexpr (order == Integration::first_order) {
        step_in_first_order<form>(law, block);
    } else {
        try_block_substep<form, round>(law, block);
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

/// What the stress at the start of shaking makes of the hardening of `count` points from p on.
inline void take_start_factors(const UbcSandArrays& points, std::size_t p, std::size_t count, Block& block)
{
    for (std::size_t k = 0; k < width; ++k) block.start_factor[k] = 1.0;
    if (points.start_factor == nullptr) return;
    for (std::size_t k = 0; k < count; ++k) block.start_factor[k] = points.start_factor[p + k];
}

/// The senses in which `count` points from p on have dilated, and of their static shear.
inline void take_senses(const UbcSandArrays& points, std::size_t p, std::size_t count, Block& block)
{
    if (points.dilated_x == nullptr) return;
    for (std::size_t k = 0; k < count; ++k) block.dilated_x[k] = points.dilated_x[p + k];
    for (std::size_t k = 0; k < count; ++k) block.dilated_y[k] = points.dilated_y[p + k];
    for (std::size_t k = 0; k < count; ++k) block.static_x[k] = points.static_x[p + k];
    for (std::size_t k = 0; k < count; ++k) block.static_y[k] = points.static_y[p + k];
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
    block.set_strain(k, strain);
    block.budget[k] = most_substeps;
    block.open[k] = 1.0;
}

/// Put `count` points from p on into the lanes.
inline void load(const UbcSand& law, const UbcSandArrays& points, std::size_t p, std::size_t count, double dt,
                 Block& block)
{
    take_start_factors(points, p, count, block);
    if (count == width) { // a known count makes vectors
        for (std::size_t k = 0; k < width; ++k) load(law, points, p + k, dt, k, block);
    } else {
        for (std::size_t k = 0; k < count; ++k) load(law, points, p + k, dt, k, block);
        for (std::size_t k = count; k < width; ++k) block.open[k] = 0.0;
    }
    take_senses(points, p, count, block);
}

inline void store(const Block& block, std::size_t p, std::size_t count, const UbcSandArrays& points)
{
    if (count == width) {
#pragma GCC ivdep // the arrays do not overlap
        for (std::size_t k = 0; k < width; ++k) points.set(p + k, block.state(k));
    } else {
        for (std::size_t k = 0; k < count; ++k) points.set(p + k, block.state(k));
    }
    if (points.dilated_x == nullptr) return;
    for (std::size_t k = 0; k < count; ++k) points.set_dilated(p + k, block.state(k));
}

/// Points with strain left after their first substep.
struct Unfinished {
    std::size_t point[segment];
    Strain strain[segment]; // what remains
    double size[segment];   // of the next substep, over that
    std::size_t count = 0;
};

inline void note_unfinished(const Block& block, std::size_t p, std::size_t count, Unfinished& unfinished)
{
    if (sum(block.open) == 0.0) return;
    for (std::size_t k = 0; k < count; ++k) {
        if (block.open[k] == 0.0) continue;
        unfinished.point[unfinished.count] = p + k;
        unfinished.strain[unfinished.count] = block.strain(k);
        unfinished.size[unfinished.count] = block.size[k];
        ++unfinished.count;
    }
}

/// Put an unfinished point into a lane.
inline void load(const UbcSand& law, const UbcSandArrays& points, const Unfinished& unfinished, std::size_t i,
                 std::size_t k, Block& block)
{
    UbcSandState state = points.state(unfinished.point[i]);
    points.add_to(unfinished.point[i], state);
    block.set(k, true, state);
    block.start_factor[k] = state.start_factor;
    block.static_x[k] = state.static_x, block.static_y[k] = state.static_y;
    bound_contraction(law, points, unfinished.point[i], k, block);
    block.set_strain(k, unfinished.strain[i]);
    block.size[k] = unfinished.size[i];
    block.budget[k] = most_substeps - 1.0;
    block.open[k] = 1.0;
}

/// The substeps after the first, in lanes that are filled anew as soon as their point is done.
template <ElasticForm form, Integration order>
inline void finish(const UbcSand& law, const Unfinished& unfinished, const UbcSandArrays& points)
{
    Block block{};
    std::size_t in_lane[width];
    const std::size_t lanes = unfinished.count < width ? unfinished.count : width;
    for (std::size_t k = 0; k < lanes; ++k) load(law, points, unfinished, in_lane[k] = k, k, block);
    std::size_t next = lanes;
    for (std::size_t left = unfinished.count; left > 0;) {
        take_substep<form, order, Round::later>(law, block);
        for (std::size_t k = 0; k < lanes; ++k) {
            if (block.open[k] > 0.0 || in_lane[k] == unfinished.count) continue;
            points.set(unfinished.point[in_lane[k]], block.state(k));
            points.set_dilated(unfinished.point[in_lane[k]], block.state(k));
            --left;
            in_lane[k] = next;
            if (next < unfinished.count) load(law, points, unfinished, next++, k, block);
        }
    }
}

template <ElasticForm form, Integration order>
inline void advance_points(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                           const UbcSandArrays& points)
{
    Block block{};
    Unfinished unfinished;
    for (std::size_t p = first; p < last; p += width) {
        const std::size_t count = last - p < width ? last - p : width;
        load(law, points, p, count, dt, block);
        take_substep<form, order, Round::first>(law, block);
        store(block, p, count, points);
        note_unfinished(block, p, count, unfinished);
        if (unfinished.count + width > segment || p + count == last) {
            finish<form, order>(law, unfinished, points);
            unfinished.count = 0;
        }
    }
}

WIDE_VECTOR_KERNEL
void advance_first_order(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                         const UbcSandArrays& points)
{
    advance_points<ElasticForm::powers, Integration::first_order>(law, dt, first, last, points);
}

/// With the exponents of the generic set.
WIDE_VECTOR_KERNEL
void advance_generic_first_order(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                                 const UbcSandArrays& points)
{
    advance_points<ElasticForm::square_roots, Integration::first_order>(law, dt, first, last, points);
}

WIDE_VECTOR_KERNEL
void advance_softening_first_order(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                                   const UbcSandArrays& points)
{
    advance_points<ElasticForm::softening_powers, Integration::first_order>(law, dt, first, last, points);
}

WIDE_VECTOR_KERNEL
void advance_generic_softening_first_order(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                                           const UbcSandArrays& points)
{
    advance_points<ElasticForm::softening_square_roots, Integration::first_order>(law, dt, first, last,
                                                                                  points);
}

WIDE_VECTOR_KERNEL
void advance_second_order(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                          const UbcSandArrays& points)
{
    advance_points<ElasticForm::powers, Integration::second_order>(law, dt, first, last, points);
}

WIDE_VECTOR_KERNEL
void advance_generic_second_order(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                                  const UbcSandArrays& points)
{
    advance_points<ElasticForm::square_roots, Integration::second_order>(law, dt, first, last, points);
}

WIDE_VECTOR_KERNEL
void advance_softening_second_order(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                                    const UbcSandArrays& points)
{
    advance_points<ElasticForm::softening_powers, Integration::second_order>(law, dt, first, last, points);
}

WIDE_VECTOR_KERNEL
void advance_generic_softening_second_order(const UbcSand& law, double dt, std::size_t first,
                                            std::size_t last, const UbcSandArrays& points)
{
    advance_points<ElasticForm::softening_square_roots, Integration::second_order>(law, dt, first, last,
                                                                                   points);
}

} // namespace

void update(const UbcSand& law, double dt, std::size_t first, std::size_t last, const UbcSandArrays& points)
{
    using Advance = void (*)(const UbcSand&, double, std::size_t, std::size_t, const UbcSandArrays&);
    constexpr Advance first_order[] = {advance_first_order, advance_generic_first_order, // by ElasticForm
                                       advance_softening_first_order, advance_generic_softening_first_order};
    constexpr Advance second_order[] = {advance_second_order, advance_generic_second_order,
                                        advance_softening_second_order,
                                        advance_generic_softening_second_order};
    const auto form = static_cast<std::size_t>(law.elastic);
    (law.integration == Integration::first_order ? first_order : second_order)[form](law, dt, first, last,
                                                                                     points);
}

} // namespace quicksand
