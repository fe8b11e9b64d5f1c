// Points of UBCSAND side by side, one array per quantity, so that loops over the lanes of a block become
// vectors.
#pragma once

#include "solver/ubcsand/ubcsand_attempt.hpp"

#include <cstddef>

namespace quicksand::ubcsand {

inline constexpr std::size_t width = 8; // lanes of a block [-]

/// The points of a block, one array per quantity. Lanes beyond the last point are closed.
struct Block {
    double sigma_x[width], sigma_y[width], sigma_z[width], tau_xy[width];
    double eta_max[width], branch[width], peak_x[width], peak_y[width], origin_x[width], origin_y[width];
    double leg_x[width], leg_y[width], back_x[width], back_y[width], last_leg[width], waiting[width];
    double half_cycles[width], dilation[width], active_dilation[width], dilated_x[width], dilated_y[width];
    double least_contraction[width], most_contraction[width], start_factor[width];
    double static_x[width], static_y[width];
    double strain_x[width], strain_y[width], strain_xy[width]; // what remains
    double size[width];                                        // of the next substep, over that
    double budget[width];                                      // substeps left
    double open[width];                                        // 1 until the last substep is done

    Strain strain(std::size_t k) const { return {strain_x[k], strain_y[k], strain_xy[k]}; }

    void set_strain(std::size_t k, const Strain& strain)
    {
        strain_x[k] = strain.x, strain_y[k] = strain.y, strain_xy[k] = strain.xy;
    }

    UbcSandState state(std::size_t k) const
    {
        return {sigma_x[k],
                sigma_y[k],
                sigma_z[k],
                tau_xy[k],
                eta_max[k],
                branch[k],
                peak_x[k],
                peak_y[k],
                origin_x[k],
                origin_y[k],
                leg_x[k],
                leg_y[k],
                back_x[k],
                back_y[k],
                last_leg[k],
                waiting[k],
                half_cycles[k],
                dilation[k],
                active_dilation[k],
                dilated_x[k],
                dilated_y[k],
                least_contraction[k],
                most_contraction[k],
                start_factor[k],
                static_x[k],
                static_y[k]};
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
        dilated_x[k] = select(condition, state.dilated_x, dilated_x[k]);
        dilated_y[k] = select(condition, state.dilated_y, dilated_y[k]);
    }
};

/// The trials of a block between their making and the return.
struct TrialBlock {
    double G[width], B[width], E2[width], s_old[width], s_start[width], per_s[width], per_sb[width];
    double start_x[width], start_y[width];
    double s[width], q_x[width], q_y[width], t[width], sigma_z[width];
    double volumetric[width], shear_x[width], shear_y[width], eta_y[width], branch[width], least_D[width],
        most_D[width], plastic[width];

    void set(std::size_t k, const Trial& trial, double is_plastic)
    {
        G[k] = trial.start.moduli.G, B[k] = trial.start.moduli.B, E2[k] = trial.E2;
        s_old[k] = trial.start.s_old, s_start[k] = trial.start.s;
        per_s[k] = trial.start.per_s, per_sb[k] = trial.start.per_sb;
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
                       per_sb[k],
                       start_x[k],
                       start_y[k],
                       start_x[k] * start_x[k] + start_y[k] * start_y[k]};
        trial.s = s[k], trial.q_x = q_x[k], trial.q_y = q_y[k], trial.t = t[k], trial.sigma_z = sigma_z[k];
        trial.volumetric = volumetric[k], trial.shear_x = shear_x[k], trial.shear_y = shear_y[k];
        trial.eta_y = eta_y[k], trial.branch = branch[k], trial.E2 = E2[k];
        trial.least_D = least_D[k], trial.most_D = most_D[k];
        return trial;
    }
};

/// What has become of the substeps of second order of a block.
struct VerdictBlock {
    double fraction[width];                            // of the strain that remained [-]
    double elastic_event[width], plastic_event[width]; // 1 or 0
    double excess[width];                              // [-]
    double longer[width];                              // [-]

    void set(std::size_t k, bool condition, const Verdict& verdict)
    {
        excess[k] = select(condition, verdict.excess, excess[k]);
        longer[k] = select(condition, verdict.longer, longer[k]);
    }
};

} // namespace quicksand::ubcsand
