// Factor of safety of the dry slopes of Griffiths and Lane (1999) by Bishop's simplified method of slices
// (Bishop 1955): the reference for strength reduction. Associated or not does not enter.
#pragma once

namespace quicksand {

/// A slope of straight face with its toe at the origin, rising towards +x to a level crest; a rigid base lies
/// at (depth_factor - 1) H below the toe.
struct HomogeneousSlope {
    double height = 10.0;             // H [m]
    double run = 2.0;                 // cotangent of the face: 2 means 2 horizontal to 1 vertical [-]
    double friction_angle = 0.0;      // phi [rad]
    double cohesion = 0.0;            // c [Pa]
    double unit_weight = 20e3;        // gamma [N/m3]
    double depth_factor = 1.0;        // D, depth of the base below the crest over H [-]
    double seismic_coefficient = 0.0; // k_h, horizontal inertia out of the slope over weight [-]
};

/// A slip circle by its centre and radius [m].
struct SlipCircle {
    double centre_x = 0.0, centre_y = 0.0, radius = 0.0;
};

/// The weakest circle found and its factor of safety [-].
struct CriticalCircle {
    SlipCircle circle;
    double factor_of_safety = 0.0;
};

/// Factor of safety of the arc that enters behind the face at x = `entry` and leaves at x = `exit` [m].
double bishop_factor_of_safety(const HomogeneousSlope& slope, const SlipCircle& circle, double exit,
                               double entry);

/// The circle of least factor of safety that stays above the base and does not overhang its entry: a coarse
/// search over entry, exit and depth, refined until the last moves are 1e-4 of the range.
CriticalCircle critical_circle(const HomogeneousSlope& slope);

} // namespace quicksand
