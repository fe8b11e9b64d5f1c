#include "solver/verification/solutions/manufactured_solution.hpp"

#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

using std::numbers::pi;
constexpr double phase[2] = {0.0, pi};

/// alpha = A sin(c pi t) h(R) with its derivatives.
struct Turn {
    double angle = 0.0, angle_t = 0.0, angle_tt = 0.0; // [rad], [rad/s], [rad/s2]
    double angle_R = 0.0, angle_RR = 0.0;              // [rad/m], [rad/m2]
};

Turn turn_of(const VortexMotion& motion, double wave_speed, double R, double t)
{
    if (R <= 0.75 || R >= 1.25) return {};
    // h = s^2 with s = 1 - 16 (R-1)^2
    const double s = 1.0 - 16.0 * (R - 1.0) * (R - 1.0), s_R = -32.0 * (R - 1.0), s_RR = -32.0;
    const double h = s * s, h_R = 2.0 * s * s_R, h_RR = 2.0 * (s_R * s_R + s * s_RR);
    const double omega = wave_speed * pi;
    const double g = motion.amplitude * std::sin(omega * t);
    const double g_t = motion.amplitude * omega * std::cos(omega * t);
    return {g * h, g_t * h, -omega * omega * g * h, g * h_R, g * h_RR};
}

Vector2 turned(const Vector2& arm, double angle)
{
    return {std::cos(angle) * arm.x() - std::sin(angle) * arm.y(),
            std::sin(angle) * arm.x() + std::cos(angle) * arm.y()};
}

Vector2 displacement(const AxisAlignedMotion& motion, const ManufacturedBody& body, const Vector2& X,
                     double t)
{
    Vector2 u;
    for (int i = 0; i < 2; ++i) {
        u[i] = motion.amplitude * std::sin(pi * X[i]) * std::sin(body.wave_speed() * pi * t + phase[i]);
    }
    return u;
}

Vector2 displacement(const VortexMotion& motion, const ManufacturedBody& body, const Vector2& X, double t)
{
    const Vector2 arm = X - motion.centre;
    return turned(arm, turn_of(motion, body.wave_speed(), arm.norm(), t).angle) - arm;
}

Vector2 velocity(const AxisAlignedMotion& motion, const ManufacturedBody& body, const Vector2& X, double t)
{
    const double omega = body.wave_speed() * pi;
    Vector2 v;
    for (int i = 0; i < 2; ++i)
        v[i] = motion.amplitude * omega * std::sin(pi * X[i]) * std::cos(omega * t + phase[i]);
    return v;
}

Vector2 velocity(const VortexMotion& motion, const ManufacturedBody& body, const Vector2& X, double t)
{
    const Vector2 arm = X - motion.centre;
    const Turn turn = turn_of(motion, body.wave_speed(), arm.norm(), t);
    const Vector2 now = turned(arm, turn.angle);
    return turn.angle_t * Vector2(-now.y(), now.x());
}

Vector2 body_acceleration(const AxisAlignedMotion& motion, const ManufacturedBody& body, const Vector2& X,
                          double t)
{
    // F is diagonal: b_i = pi^2 u_i {[lambda (1 - ln J) + mu] / (rho_0 F_ii^2) + mu / rho_0 - c^2}
    const double c = body.wave_speed();
    const Vector2 u = displacement(motion, body, X, t);
    Vector2 F;
    for (int i = 0; i < 2; ++i) {
        F[i] = 1.0 + motion.amplitude * pi * std::cos(pi * X[i]) * std::sin(c * pi * t + phase[i]);
    }
    const double lambda = body.lame_modulus(), mu = body.shear_modulus(), ln_J = std::log(F[0] * F[1]);
    Vector2 b;
    for (int i = 0; i < 2; ++i) {
        const double stiffness = (lambda * (1.0 - ln_J) + mu) / (F[i] * F[i]) + mu;
        b[i] = pi * pi * u[i] * (stiffness / body.density - c * c);
    }
    return b;
}

Vector2 body_acceleration(const VortexMotion& motion, const ManufacturedBody& body, const Vector2& X,
                          double t)
{
    // on the axes of the turned point: b_r = -R alpha_t^2 + mu/rho_0 R alpha_R^2,
    // b_theta = R alpha_tt - mu/rho_0 (3 alpha_R + R alpha_RR)
    const Vector2 arm = X - motion.centre;
    const double R = arm.norm();
    const Turn turn = turn_of(motion, body.wave_speed(), R, t);
    if (R <= 0.75 || R >= 1.25) return Vector2::Zero();
    const double stiffness = body.shear_modulus() / body.density;
    const double radial = R * (stiffness * turn.angle_R * turn.angle_R - turn.angle_t * turn.angle_t);
    const double tangential = R * turn.angle_tt - stiffness * (3.0 * turn.angle_R + R * turn.angle_RR);
    const Vector2 r = turned(arm, turn.angle) / R;
    return radial * r + tangential * Vector2(-r.y(), r.x());
}

} // namespace

double ManufacturedBody::wave_speed() const
{
    return std::sqrt(youngs_modulus / density);
}

Vector2 displacement(const ManufacturedMotion& motion, const ManufacturedBody& body, const Vector2& X,
                     double t)
{
    return std::visit([&](const auto& m) { return displacement(m, body, X, t); }, motion);
}

Vector2 velocity(const ManufacturedMotion& motion, const ManufacturedBody& body, const Vector2& X, double t)
{
    return std::visit([&](const auto& m) { return velocity(m, body, X, t); }, motion);
}

Vector2 body_acceleration(const ManufacturedMotion& motion, const ManufacturedBody& body, const Vector2& X,
                          double t)
{
    return std::visit([&](const auto& m) { return body_acceleration(m, body, X, t); }, motion);
}

} // namespace quicksand
