// What a point of UBCSAND remembers of its cycles: where stress and strain turned, and how often.
//
// Symbols    r = q/(s + a) a vector of the stress ratio; the strain's vector is (eps_x - eps_y, gamma_xy).
//            Both turn by twice the angle of the body.
#pragma once

#include "solver/soil/rotation.hpp"
#include "solver/ubcsand/ubcsand_choices.hpp"
#include "solver/ubcsand/ubcsand_point.hpp"

namespace quicksand::ubcsand {

/// Where a point is on its branch: doubles, so that vectors hold one kind of number. Unloading that has just
/// begun may be an excursion of the loading before, until the strain has turned and the stress ratio has gone
/// the tolerance from there.
inline constexpr double just_reversed = 0.0, strain_reversed = 0.5, far_from_reversal = 1.0,
                        loading_in_ripple = 1.5, loading = 2.0;

/// What the reversals of the strain and the beginnings of loading owe each other, a half cycle for each pair.
inline constexpr double loading_waits = -1.0, even = 0.0, reversal_waits = 1.0;

inline void turn_stress(const Rotation& turn, UbcSandState& state)
{
    const double s = 0.5 * (state.sigma_x + state.sigma_y), q_x = 0.5 * (state.sigma_x - state.sigma_y);
    const double turned = turn.cosine * q_x - turn.sine * state.tau_xy;
    state.tau_xy = turn.sine * q_x + turn.cosine * state.tau_xy;
    state.sigma_x = s + turned;
    state.sigma_y = s - turned;
}

inline void turn_memory(const Rotation& turn, UbcSandState& state)
{
    turn_vector(turn, state.peak_x, state.peak_y);
    turn_vector(turn, state.origin_x, state.origin_y);
    turn_vector(turn, state.dilated_x, state.dilated_y);
    turn_vector(turn, state.static_x, state.static_y);
    turn_vector(turn, state.leg_x, state.leg_y);
    turn_vector(turn, state.back_x, state.back_y);
}

/// Of the longer of the present leg of the strain and the last one, which a reversal must go back; and a
/// strain, squared, that is more than rounding and less than any strain of soil.
inline constexpr double least_fraction_of_a_leg = 0.25; // [-]
inline constexpr double least_strain_squared = 1e-18;   // [-]

/// What the strain must go back to have turned, squared: the ripple's strain, or a fraction of the leg if
/// that is less. [-]
inline double least_turn(const UbcSand& m, const UbcSandState& state)
{
    const double leg = state.leg_x * state.leg_x + state.leg_y * state.leg_y;
    const double fraction = least_fraction_of_a_leg * least_fraction_of_a_leg * larger(leg, state.last_leg);
    return smaller(m.ripple_squared, larger(fraction, least_strain_squared));
}

/// Follow the strain in its plane of shear: the leg goes from where it last turned to the farthest point
/// since; it has turned again when the strain has gone the ripple's strain, or a fraction of the leg if that
/// is less, back from the farthest point. Without a ripple's strain every substep counts as a turn. Returns 1
/// for a turn, else 0.
inline double follow_strain(const UbcSand& m, double strain_x, double strain_y, UbcSandState& state)
{
    const double back_x = state.back_x + strain_x, back_y = state.back_y + strain_y;
    const double all_x = state.leg_x + back_x, all_y = state.leg_y + back_y;
    const double leg = state.leg_x * state.leg_x + state.leg_y * state.leg_y;
    const double back = back_x * back_x + back_y * back_y;
    const double least = least_turn(m, state);
    // a substep of more than a ripple may pass the whole leg: then it has turned on the way
    const double same_side = select(all_x * state.leg_x + all_y * state.leg_y >= 0.0, 1.0, 0.0);
    const double outside = select(all_x * all_x + all_y * all_y >= leg, 1.0, 0.0);
    const double farther = outside * select(back >= m.ripple_squared, same_side, 1.0);
    const double turned = select(farther > 0.0, 0.0, select(back >= least, 1.0, 0.0));
    state.last_leg = select(turned > 0.0, leg, state.last_leg);
    state.leg_x = select(turned > 0.0, back_x, select(farther > 0.0, all_x, state.leg_x));
    state.leg_y = select(turned > 0.0, back_y, select(farther > 0.0, all_y, state.leg_y));
    state.back_x = select(turned + farther > 0.0, 0.0, back_x);
    state.back_y = select(turned + farther > 0.0, 0.0, back_y);
    return select(m.ripple_squared <= 0.0, 1.0, turned);
}

/// What the sand has dilated up to here softens what follows, where the condition is 1 and not 0.
inline void soften_by_dilation(const UbcSand& m, double condition, UbcSandState& state)
{
    const double dilated = select(m.per_dilation > 0.0, state.dilation - state.active_dilation, 0.0);
    state.dilated_x = select(condition * dilated > 0.0, state.peak_x, state.dilated_x);
    state.dilated_y = select(condition * dilated > 0.0, state.peak_y, state.dilated_y);
    state.active_dilation = select(condition > 0.0, state.dilation, state.active_dilation);
}

/// A half cycle is a reversal of the strain and a beginning of loading, whichever comes first; both are 1 or
/// 0. The reversal makes where the stress turned the origin of the present branch.
inline void count_half_cycles(const UbcSand& m, double turned, double loads, UbcSandState& state)
{
    const double began = select(state.waiting == even, reversal_waits, state.waiting);
    const double waiting = select(turned > 0.0, began, state.waiting);
    const double counts = select(waiting > even, loads, select(waiting < even, turned, 0.0));
    state.half_cycles += counts;
    soften_by_dilation(m, counts, state);
    state.waiting = select(counts > 0.0, even, select(loads > 0.0, loading_waits, waiting));
    state.origin_x = select(turned > 0.0, state.peak_x, state.origin_x);
    state.origin_y = select(turned > 0.0, state.peak_y, state.origin_y);
}

} // namespace quicksand::ubcsand
