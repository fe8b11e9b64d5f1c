// Points of PM4Sand side by side, one array per quantity, so that loops over the lanes of a block become
// vectors.
#pragma once

#include "solver/pm4sand/pm4sand_control.hpp"

#include <cstddef>

namespace quicksand::pm4sand {

inline constexpr std::size_t width = 8; // lanes of a block [-]

/// The states of a block.
struct States {
    double sigma_x[width], sigma_y[width], sigma_z[width], tau_xy[width], alpha_x[width], alpha_y[width],
        start_x[width], start_y[width], turn_x[width], turn_y[width], previous_x[width], previous_y[width],
        least_x[width], least_y[width], most_x[width], most_y[width], fabric_x[width], fabric_y[width],
        origin_x[width], origin_y[width], fabric_path[width], fabric_peak[width], peak_stress[width],
        peak_product[width], void_ratio[width], fabric_limit[width], dilatancy_factor[width],
        least_stress[width];

    Pm4SandState state(std::size_t k) const
    {
        return {sigma_x[k],      sigma_y[k],          sigma_z[k],     tau_xy[k],       alpha_x[k],
                alpha_y[k],      start_x[k],          start_y[k],     turn_x[k],       turn_y[k],
                previous_x[k],   previous_y[k],       least_x[k],     least_y[k],      most_x[k],
                most_y[k],       fabric_x[k],         fabric_y[k],    origin_x[k],     origin_y[k],
                fabric_path[k],  fabric_peak[k],      peak_stress[k], peak_product[k], void_ratio[k],
                fabric_limit[k], dilatancy_factor[k], least_stress[k]};
    }

    void set(std::size_t k, const Pm4SandState& state)
    {
        sigma_x[k] = state.sigma_x;
        sigma_y[k] = state.sigma_y;
        sigma_z[k] = state.sigma_z;
        tau_xy[k] = state.tau_xy;
        alpha_x[k] = state.alpha_x;
        alpha_y[k] = state.alpha_y;
        start_x[k] = state.start_x;
        start_y[k] = state.start_y;
        turn_x[k] = state.turn_x;
        turn_y[k] = state.turn_y;
        previous_x[k] = state.previous_x;
        previous_y[k] = state.previous_y;
        least_x[k] = state.least_x;
        least_y[k] = state.least_y;
        most_x[k] = state.most_x;
        most_y[k] = state.most_y;
        fabric_x[k] = state.fabric_x;
        fabric_y[k] = state.fabric_y;
        origin_x[k] = state.origin_x;
        origin_y[k] = state.origin_y;
        fabric_path[k] = state.fabric_path;
        fabric_peak[k] = state.fabric_peak;
        peak_stress[k] = state.peak_stress;
        peak_product[k] = state.peak_product;
        void_ratio[k] = state.void_ratio;
        fabric_limit[k] = state.fabric_limit;
        dilatancy_factor[k] = state.dilatancy_factor;
        least_stress[k] = state.least_stress;
    }
};

/// Points of a block, or their changes.
struct Points {
    double p[width], s_x[width], s_y[width], sigma_z[width], alpha_x[width], alpha_y[width], fabric_x[width],
        fabric_y[width], fabric_path[width], void_ratio[width];

    Point point(std::size_t k) const
    {
        return {p[k],       s_x[k],      s_y[k],      sigma_z[k],     alpha_x[k],
                alpha_y[k], fabric_x[k], fabric_y[k], fabric_path[k], void_ratio[k]};
    }

    void set(std::size_t k, const Point& point)
    {
        p[k] = point.p;
        s_x[k] = point.s_x;
        s_y[k] = point.s_y;
        sigma_z[k] = point.sigma_z;
        alpha_x[k] = point.alpha_x;
        alpha_y[k] = point.alpha_y;
        fabric_x[k] = point.fabric_x;
        fabric_y[k] = point.fabric_y;
        fabric_path[k] = point.fabric_path;
        void_ratio[k] = point.void_ratio;
    }
};

/// A block of points on their way through their strains.
struct Block {
    States states, memories;                     // memories: after the contact
    Points contacts, firsts;                     // firsts: changes at the rates of the contact
    double elastic[width], elastic_error[width]; // as in Contact
    double strain_x[width], strain_y[width], strain_volumetric[width]; // the whole [-]
    double fraction[width];                                            // of it that is tried [-]
    double done[width], size[width], budget[width];                    // as in Progress

    Strain strain(std::size_t k) const { return {strain_x[k], strain_y[k], strain_volumetric[k]}; }
    Contact contact(std::size_t k) const { return {contacts.point(k), elastic[k], elastic_error[k]}; }
    Progress progress(std::size_t k) const { return {done[k], size[k], budget[k]}; }

    void set_progress(std::size_t k, const Progress& progress)
    {
        done[k] = progress.done, size[k] = progress.size, budget[k] = progress.budget;
    }
};

} // namespace quicksand::pm4sand
