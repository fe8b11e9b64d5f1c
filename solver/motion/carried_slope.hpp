// The slope of the nodes' motion about a particle, which it carries to the nodes of its next step.
//
// With d = x_i - x_p, sum phi = 1 and sum phi d = 0 it is the best linear fit to the nodes' velocities by the
// weights phi (Jiang, Schroeder, Selle, Teran and Stomakhin 2015):
//   C = [sum phi v_i (x) d] D^-1,  D = sum phi d (x) d
// Scatter and gather are then each other's adjoint: what particles carry is projected on what the grid holds
// and back, and cannot grow from step to step, in whatever way few particles lie about a node. The gradient
// sum v_i (x) grad phi that deforms the domain is another average of the same slope. Carried, it may give
// more than was taken: two or three stretched domains about a node gain a per cent a step.
#pragma once

#include "solver/base/lanes.hpp"

namespace quicksand {

/// Derivatives of four velocities along x and y [1/s].
struct Slopes {
    Lanes x, y;
};

/// The sums of the fit over the nodes of a patch, row by row. Sums of running sums stand for those of
/// coordinates: a node joins as many running sums as there are nodes from it to the end of its row, which is
/// its distance u from there in cells, and likewise v rows to the last one. Moments about the mean do not ask
/// where they are counted from.
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

    /// C with nodes at the distance h [m]. A point on a line between nodes has no extent across it, and no
    /// slope.
    Slopes slopes(double h) const
    {
        constexpr double least_extent = 1e-12; // of D, that rounding does not make slopes [-]
        // a node at u adds u (u + 1) / 2 to the sums of sums of sums
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
