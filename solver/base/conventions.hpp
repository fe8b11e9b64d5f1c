// The one statement of Quicksand's conventions. Every other file only states exceptions.
//
// Units      SI throughout: m, kg, s, N, Pa. Angles are radians except where a name ends in _deg.
// Space      Plane strain in x-y, y up, per metre of thickness; areas stand for volumes [m3/m].
// Frame      Base shaking is applied as a body force: velocities and displacements are relative to the base.
// Stress     The stress tensor is the effective stress, tension positive. Strain follows it: extension
//            positive; shear strain is engineering shear (gamma_xy = du_x/dy + du_y/dx).
// Pressure   Pore pressure, mean effective stress and vertical effective stress are compression positive.
//            The solver's pore pressure is the excess over the static water pressure of the water level.
// Settlement Positive downward; displacement_y is positive upward.
// Phases     _solid is the grain skeleton, _fluid the pore water (true velocity, not Darcy's flux).
// Gradients  L_ab = d v_a / d x_b.
// Subscripts _p particle, _i node, _c cell.
#pragma once

#include <Eigen/Core>

namespace quicksand {

using Vector2 = Eigen::Vector2d;

inline constexpr double standard_gravity = 9.81; // g [m/s2], the value of the reference solutions
inline constexpr double atmospheric_pressure =
    100e3; // P_a [Pa], the reference stress of the soil models and the pressure of the air

} // namespace quicksand
