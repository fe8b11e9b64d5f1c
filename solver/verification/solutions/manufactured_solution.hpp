// Manufactured solutions of large-strain elastodynamics: displacement fields chosen first, and the body force
// that makes them exact for a neo-Hookean body. They measure the order of an interpolation.
#pragma once

#include "solver/base/conventions.hpp"

#include <variant>

namespace quicksand {

/// The body of both solutions; wave speed c = sqrt(E / rho_0).
struct ManufacturedBody {
    double youngs_modulus = 1000.0; // E [Pa]
    double poisson_ratio = 0.3;     // [-]
    double density = 1000.0;        // rho_0 [kg/m3]

    double lame_modulus() const
    {
        return youngs_modulus * poisson_ratio / ((1.0 + poisson_ratio) * (1.0 - 2.0 * poisson_ratio));
    }
    double shear_modulus() const { return 0.5 * youngs_modulus / (1.0 + poisson_ratio); }
    double wave_speed() const; // [m/s]
};

/// Axis-aligned displacement on the unit square between rollers:
///   u_i = A sin(pi X_i) sin(c pi t + phi_i),  phi = (0, pi)
struct AxisAlignedMotion {
    double amplitude = 0.05; // A [m]
};

/// Generalised vortex (Kamojjala, Brannon, Sadeghirad and Guilkey 2015): every point turns about the centre
/// by
///   alpha = A sin(c pi t) h(R),  h = [1 - 16 (R - 1)^2]^2 for 0.75 < R < 1.25, zero elsewhere.
struct VortexMotion {
    double amplitude = 0.1;           // A; the largest shear strain is about 7 A [rad]
    Vector2 centre = Vector2::Zero(); // [m]
};

using ManufacturedMotion = std::variant<AxisAlignedMotion, VortexMotion>;

/// u of the point X at time t [m].
Vector2 displacement(const ManufacturedMotion& motion, const ManufacturedBody& body, const Vector2& X,
                     double t);

/// du/dt of the point X at time t [m/s].
Vector2 velocity(const ManufacturedMotion& motion, const ManufacturedBody& body, const Vector2& X, double t);

/// The body force per mass that makes the displacement exact: b = d2u/dt2 - Div P / rho_0 [m/s2].
Vector2 body_acceleration(const ManufacturedMotion& motion, const ManufacturedBody& body, const Vector2& X,
                          double t);

} // namespace quicksand
