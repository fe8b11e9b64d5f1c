// The rotation of a point in a step, as stresses and what laws remember of directions turn with it.
#pragma once

namespace quicksand {

struct Rotation {
    double cosine, sine; // of twice the angle: deviators turn so [-]
};

/// The rotation of a spin, tan(angle/2) = spin/2 (Hughes and Winget 1980).
inline Rotation rotation_of(double spin)
{
    const double h = 0.5 * spin;
    const double scale = 1.0 / (1.0 + h * h);
    const double c = (1.0 - h * h) * scale, s = 2.0 * h * scale;
    return {c * c - s * s, 2.0 * s * c};
}

/// Turn (x, y) = ((a_xx - a_yy)/2, a_xy) of a tensor a, or (eps_x - eps_y, gamma_xy) of a strain.
inline void turn_vector(const Rotation& turn, double& x, double& y)
{
    const double turned = turn.cosine * x - turn.sine * y;
    y = turn.sine * x + turn.cosine * y;
    x = turned;
}

} // namespace quicksand
