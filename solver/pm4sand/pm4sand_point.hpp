// The stress and memory of a point of PM4Sand, and a strain increment.
//
// A deviator a in the plane is the vector (x, y) = ((a_xx - a_yy)/2, a_xy); for two of them a:b = 2 (a_x b_x
// + a_y b_y), and the unit tensor n of the loading direction is the unit vector u over sqrt(2).
#pragma once

namespace quicksand {

/// Compression positive, as the law is published.
struct Pm4SandState {
    double sigma_x = 0.0, sigma_y = 0.0, sigma_z = 0.0, tau_xy = 0.0; // effective stress [Pa]
    double alpha_x = 0.0, alpha_y = 0.0;                              // back-stress ratio [-]
    double start_x = 0.0, start_y = 0.0;       // alpha_in, where loading began, apparent [-]
    double turn_x = 0.0, turn_y = 0.0;         // where it began in truth [-]
    double previous_x = 0.0, previous_y = 0.0; // alpha_in before that [-]
    double least_x = 0.0, least_y = 0.0;       // least of the starts on the positive side [-]
    double most_x = 0.0, most_y = 0.0;         // largest of the starts on the negative side [-]
    double fabric_x = 0.0, fabric_y = 0.0;     // z [-]
    double origin_x = 0.0, origin_y = 0.0;     // z_in, at the last reversal [-]
    double fabric_path = 0.0;                  // z_cum, length of the path of z [-]
    double fabric_peak = 0.0;                  // z_peak, largest |z| so far [-]
    double peak_stress = 0.0;      // p_zp, mean stress at the reversal with the largest p |z| [Pa]
    double peak_product = 0.0;     // that p |z|, below zero before the first reversal [Pa]
    double void_ratio = 0.0;       // e [-]
    double fabric_limit = 0.0;     // z_max [-]
    double dilatancy_factor = 0.0; // A_d0 [-]
    double least_stress = 0.0;     // p_min [Pa]
};

/// Compression positive; the state has been turned by the rotation that comes with it.
struct Pm4SandStrain {
    double x = 0.0, y = 0.0; // [-]
    double shear = 0.0;      // d gamma_xy, of the sign of tau_xy [-]
};

} // namespace quicksand
