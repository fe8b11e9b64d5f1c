// Substeps of UBCSAND in second order that are as long as their error allows: how far the next one goes at
// most, and whether it stands when it has been tried.
//
// A substep ends where the law changes: where the ratio is least, where an excursion meets its locus or is
// none any more, where the strain turns, and where the branch crosses the isotropic axis and softens. Elastic
// substeps are exact with exponents of 1/2; the error of plastic ones is estimated (ubcsand_turning.hpp), and
// goes with the square of their length. What does not stand is tried again, shorter.
#pragma once

#include "solver/ubcsand/ubcsand_turning.hpp"

namespace quicksand::ubcsand {

/// Below this fraction of the remaining strain the path to the least ratio is rounding. [-]
inline constexpr double least_inward_fraction = 1e-6;

/// The elastic path of a strain, a straight line of q and s whatever the moduli do, and how far on it the
/// ratio is least: eta(y) = |q + y dq|/(sb + y ds) is least at y = (|q|^2 ds - q.dq sb)/(|dq|^2 sb - q.dq
/// ds).
struct Course {
    double dq_x, dq_y, ds; // with the moduli of the start [Pa]
    double squared, along; // |dq|^2, q.dq [Pa^2]
    double inward, turns;  // numerator and denominator of y; positive only on the way in [Pa^3]
    double stiffens;       // growth of the moduli on the way, times y [-]
    bool goes_inward;
};

/// Of a shear strain, as a vector, and a volumetric one.
inline Course course_of(const UbcSand& m, const Start& start, double shear_x, double shear_y,
                        double volumetric)
{
    Course c;
    const double G = start.moduli.G;
    c.dq_x = G * shear_x;
    c.dq_y = G * shear_y;
    c.ds = start.moduli.K * volumetric;
    c.squared = c.dq_x * c.dq_x + c.dq_y * c.dq_y;
    c.along = start.q_x * c.dq_x + start.q_y * c.dq_y;
    c.inward = start.squared * c.ds - c.along * start.sb;
    c.turns = larger(c.squared * start.sb - c.along * c.ds, 0.0);
    c.goes_inward = c.inward > least_inward_fraction * c.turns; // turns is not negative
    c.stiffens = larger(-0.25, smaller(4.0, 0.5 * m.ne * c.ds * start.per_s));
    return c;
}

/// The fraction x of the strain that goes a way y: y = x (1 + x stiffens).
inline double fraction_of_way(const Course& c, double y)
{
    return 2.0 * y / (1.0 + std::sqrt(larger(0.0, 1.0 + 4.0 * c.stiffens * y)));
}

/// Farther than any way.
inline constexpr double beyond = 1e9;

/// The way y out of a region, A y^2 + 2 B y + C = 0 with C < 0 inside; from its edge none.
inline double way_out(double A, double B, double C)
{
    const double root = std::sqrt(larger(0.0, B * B - A * C));
    const bool outward = B > 0.0;
    const double way = select(outward, -C, root - B) / select(outward, B + root, larger(A, 1e-300));
    return select((C < 0.0) & (B * B >= A * C), smaller(beyond, way), beyond);
}

/// How near to its locus a stress may be to be on it, squared. [-]
inline constexpr double on_locus = 1.0 - 1e-3;

/// The way of an excursion to its locus, which is that of the last peak.
inline double way_to_locus(const UbcSand& m, const Start& start, const UbcSandState& state, const Course& c)
{
    const double peak = state.peak_x * state.peak_x + state.peak_y * state.peak_y;
    const double eta_2 = smaller(peak, m.eta_f * m.eta_f), edge = eta_2 * start.sb * start.sb;
    const double way =
        way_out(c.squared - eta_2 * c.ds * c.ds, c.along - eta_2 * start.sb * c.ds, start.squared - edge);
    return select(start.squared >= on_locus * edge, beyond, way);
}

/// The way of an excursion to where it is one no more, the tolerance from its peak.
inline double way_to_departure(const UbcSand& m, const Start& start, const UbcSandState& state,
                               const Course& c)
{
    const double x = start.q_x - state.peak_x * start.sb, y = start.q_y - state.peak_y * start.sb;
    const double dx = c.dq_x - state.peak_x * c.ds, dy = c.dq_y - state.peak_y * c.ds;
    const double least = m.tolerance_squared;
    return way_out(dx * dx + dy * dy - least * c.ds * c.ds, x * dx + y * dy - least * start.sb * c.ds,
                   x * x + y * y - least * start.sb * start.sb);
}

/// Whether a strain may turn on its way: it goes back far enough, and not just farther on its leg.
inline bool may_turn(const UbcSand& m, const UbcSandState& state, double shear_x, double shear_y)
{
    const double x = state.back_x + shear_x, y = state.back_y + shear_y;
    const double back = state.back_x * state.back_x + state.back_y * state.back_y;
    const double on = select(back > 0.0, -1.0, state.leg_x * shear_x + state.leg_y * shear_y);
    return select(on < 0.0, x * x + y * y, -1.0) >= least_turn(m, state);
}

/// The fraction of the strain to where it has turned.
inline double fraction_to_turn(const UbcSand& m, const UbcSandState& state, double shear_x, double shear_y)
{
    const double fraction =
        way_out(shear_x * shear_x + shear_y * shear_y, state.back_x * shear_x + state.back_y * shear_y,
                state.back_x * state.back_x + state.back_y * state.back_y - least_turn(m, state));
    return select(may_turn(m, state, shear_x, shear_y), fraction, beyond);
}

/// [2] Fraction of the strain that the next substep takes at most.
inline double fraction_to_event(const UbcSand& m, const Start& start, const UbcSandState& state,
                                const Strain& strain)
{
    constexpr double just_beyond = 1.0 + 1e-9, shortest = 1e-6;
    const double shear_x = strain.x - strain.y, shear_y = strain.xy;
    const Course c = course_of(m, start, shear_x, shear_y, strain.x + strain.y);
    const double to_least = c.inward / select(c.turns > 0.0, c.turns, 1e-300);
    const bool reversed = state.branch == strain_reversed;
    const double to_departure = way_to_departure(m, start, state, c) * just_beyond;
    const double outward = smaller(way_to_locus(m, start, state, c), select(reversed, to_departure, beyond));
    const bool excursion = state.branch < far_from_reversal;
    const double way = select(c.goes_inward, smaller(to_least, beyond), select(excursion, outward, beyond));
    const double to_turn = fraction_to_turn(m, state, shear_x, shear_y) * just_beyond;
    const double fraction =
        smaller(fraction_of_way(c, way), select(c.goes_inward | reversed, beyond, to_turn));
    return smaller(1.0, larger(shortest, fraction));
}

/// What became of a substep: it stands if nothing in it is larger than allowed, and the next one may be that
/// many times as long.
struct Verdict {
    double excess; // of what is largest over what it may be [-]
    double longer; // [-]

    bool stands() const { return excess <= 1.0; }
};

/// Length of the next substep to be tried, over the strain that remains: as the last one suggests, to the
/// next event, and all of it with the last of the budget.
inline double next_fraction(const UbcSand& m, const Start& start, const UbcSandState& state,
                            const Strain& remaining, double size, double budget)
{
    return select(budget > 1.0, smaller(size, fraction_to_event(m, start, state, remaining)), 1.0);
}

/// What a substep of a fraction suggests for the next one, over the strain that then remains.
inline double next_size(const Verdict& verdict, double fraction)
{
    const double remains = select(verdict.stands(), 1.0 - fraction, 1.0);
    return smaller(1.0, verdict.longer * fraction / larger(remains, 1e-12));
}

/// Substeps that change the stresses elastically by less than this stand in any case. [-]
inline constexpr double least_change = 0.01;

/// The elastic changes of a substep over the largest ones, squared; and over the least.
struct Change {
    double over_largest, over_least; // [-]
};

inline Change change_of(const UbcSand& m, const Trial& trial)
{
    const double resolved = larger(trial.start.s, m.resolved), G = trial.start.moduli.G;
    const Inverses per = inverses(resolved, resolved + m.a);
    const double shear = G * G * (trial.shear_x * trial.shear_x + trial.shear_y * trial.shear_y);
    const double by_ratio = shear * (per.of_b * per.of_b),
                 ds = trial.start.moduli.K * trial.volumetric * per.of_a;
    const double by_stress = ds * ds;
    return {larger(by_ratio * (m.per_ratio_step * m.per_ratio_step),
                   by_stress * (m.per_stress_step * m.per_stress_step)),
            larger(by_ratio, by_stress) * (1.0 / (least_change * least_change))};
}

/// Of an error and changes as they may be, 1, or larger ones.
inline double longer_by(double excess)
{
    constexpr double safety = 0.9, most = 4.0;
    return safety / std::sqrt(larger(excess, (safety / most) * (safety / most)));
}

/// What a whole strain that is not cut at events may meet on its way: 1 or 0.
struct Events {
    double elastic; // what is not inward all the way, and no excursion that still is one
    double plastic; // a way inward, or a turn of the strain
};

inline Events events_of(const UbcSand& m, const Trial& trial, const UbcSandState& state)
{
    const Course c = course_of(m, trial.start, trial.shear_x, trial.shear_y, trial.volumetric);
    const bool inward = c.inward >= larger(c.turns * (1.0 + c.stiffens), 1e-300);
    const double turns = select(may_turn(m, state, trial.shear_x, trial.shear_y), 1.0, 0.0);
    const double sb = trial.s + m.a;
    const double x = trial.q_x - state.peak_x * sb, y = trial.q_y - state.peak_y * sb;
    const double departs = select(x * x + y * y < m.tolerance_squared * (sb * sb), 0.0, 1.0);
    // loading that is elastic has just reversed
    const double reversing = select(trial.branch == loading, turns, 1.0);
    const double from_peak = select(trial.branch == just_reversed, turns, reversing);
    const double ends = select(trial.branch == strain_reversed, departs, from_peak);
    return {select(inward, 0.0, ends), select(c.goes_inward, 1.0, turns)};
}

/// An elastic substep stands if its changes are small enough and it has met no event.
inline Verdict judge_elastic(const UbcSand& m, const Trial& trial, double event)
{
    const Change change = change_of(m, trial);
    return {larger(2.0 * event, smaller(change.over_least, change.over_largest)),
            larger(event, longer_by(change.over_largest))};
}

inline double sign_of(double accord)
{
    return select(accord > 0.0, 1.0, -1.0);
}

/// Where between two accords of different signs the branch crosses the isotropic axis; 1 if it does not.
inline double crossing(double before, double after, double used)
{
    constexpr double near = 0.02;
    const double from = sign_of(before), to = sign_of(after);
    const double at = before / select(from == to, 1.0, before - after);
    const double crosses = select((at > near) & (at < 1.0 - near), at, 1.0);
    return select(from == to, select(to == sign_of(used), 1.0, 0.5), crosses);
}

/// A plastic substep stands if its error and its changes are small enough, it has met no event, it began on
/// the locus, and the branch kept its sense, or changed it at an end.
template <Locking locking>
inline Verdict judge_plastic(const UbcSand& m, const Trial& trial, double error, double event,
                             const UbcSandState& after)
{
    const Change change = change_of(m, trial);
    const Start& start = trial.start;
    const double s = larger(m.resolved, 0.5 * (after.sigma_x + after.sigma_y));
    const double worst = larger(error / (m.substep_tolerance * s), change.over_largest);
    const bool begins_on_locus =
        start.squared >= on_locus * (trial.eta_y * trial.eta_y) * (start.sb * start.sb);
    const Deviator end = {0.5 * (after.sigma_x - after.sigma_y), after.tau_xy};
    const double senses = crossing(
        softening_accord<locking>({start.q_x, start.q_y}, after), softening_accord<locking>(end, after),
        softening_accord<locking>(at_middle<Integration::second_order>(trial), after));
    const double cut =
        smaller(select(after.active_dilation > 0.0, senses, 1.0), select(begins_on_locus, 1.0, 0.5));
    const double excess = smaller(change.over_least, larger(worst, 2.0 - cut));
    return {larger(2.0 * event, excess),
            larger(event, smaller(longer_by(worst), select(cut < 1.0, cut, 4.0)))};
}

} // namespace quicksand::ubcsand
