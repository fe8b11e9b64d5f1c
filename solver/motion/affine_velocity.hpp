// The affine velocity of a particle: the matrix C_p of its linear velocity field v_p + C_p (x - x_p), which
// gives the nodes their velocities in the next step (affine particle-in-cell method).
//
// With d = x_i - x_p, sum phi = 1 and sum phi d = 0, C is the least-squares fit to the nodes' velocities with
// the weights phi (Jiang, Schroeder, Selle, Teran and Stomakhin 2015):
//   C = [sum phi v_i (x) d] D^-1,  D = sum phi d (x) d
// Scatter is then the adjoint of gather, and both are projections: the kinetic energy of the affine
// velocities cannot grow from step to step, also where few particles surround a node. The velocity gradient
// sum v_i (x) grad phi, which deforms the domain, is another average of the same derivatives. In the place of
// C it can add energy: two or three stretched domains about a node gain one per cent in a step.
#pragma once

#include "solver/base/lanes.hpp"

namespace quicksand {

/// Derivatives of four velocities along x and y [1/s].
struct LaneGradients {
    Lanes x, y;
};

/// The sums of the fit over the nodes of a stencil, row by row. With u the number of nodes from a node to the
/// end of its row, this node included, sum phi u is the sum of the running sums of phi along the row; v
/// counts the rows to the last one likewise. No coordinate is multiplied. Moments about the mean do not
/// depend on the origin of u and v.
class MotionFit {
public:
    void begin_row()
    {
        velocity_ = all_lanes(0.0);
        weight_ = first_ = 0.0;
    }

    void add(double phi, const Lanes& velocity)
    {
        velocity_ += phi * velocity;
        velocity_u_ += velocity_;
        weight_ += phi;
        first_ += weight_;
        second_ += first_;
    }

    void end_row()
    {
        mean_ += velocity_;
        velocity_v_ += mean_;
        weights_ += weight_;
        u_ += first_;
        uv_ += u_;
        v_ += weights_;
        second_v_ += v_;
    }

    /// sum phi v_i [m/s].
    const Lanes& mean() const { return mean_; }

    /// C with nodes at the distance h [m]. The stencil of a point on a grid line has no width across the
    /// line; the derivative across it is zero.
    LaneGradients gradients(double h) const
    {
        constexpr double least_extent = 1e-12; // added to D against rounding [-]
        // a node at u adds u (u + 1) / 2 to the third running sum
        const double uu = 2.0 * second_ - u_ - u_ * u_ + least_extent;
        const double vv = 2.0 * second_v_ - v_ - v_ * v_ + least_extent;
        const double uv = uv_ - u_ * v_;
        const Lanes b_u = velocity_u_ - u_ * mean_, b_v = velocity_v_ - v_ * mean_;
        const double scale = -1.0 / (h * (uu * vv - uv * uv)); // u and v fall as x and y grow
        return {scale * (vv * b_u - uv * b_v), scale * (uu * b_v - uv * b_u)};
    }

private:
    Lanes velocity_ = all_lanes(0.0), velocity_u_ = velocity_; // sum phi v_i of the row, sum phi v_i u [m/s]
    Lanes mean_ = velocity_, velocity_v_ = velocity_;          // sum phi v_i, sum phi v_i v [m/s]
    double weight_ = 0.0, first_ = 0.0, second_ = 0.0;         // sum phi, phi u of the row, phi u (u+1)/2 [-]
    double weights_ = 0.0, u_ = 0.0, uv_ = 0.0;                // sum phi, phi u, phi u v [-]
    double v_ = 0.0, second_v_ = 0.0;                          // sum phi v, phi v (v+1)/2 [-]
};

} // namespace quicksand
