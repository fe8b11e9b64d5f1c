// A rectangular neo-Hookean block under suddenly applied gravity by finite elements in the reference
// configuration (bilinear quadrilaterals, 2 x 2 Gauss points, lumped mass, central differences): a reference
// for large vibrations that shares neither grid nor points with the solver.
#pragma once

#include "solver/verification/bodies/solid_body.hpp"

#include <vector>

namespace quicksand {

/// Edges and what holds them.
struct BlockSupports {
    enum Edge { left, right, bottom, top };
    bool fixed_x[4] = {}, fixed_y[4] = {}; // by edge

    bool any() const;
};

/// Supports of the block by the problem's boundaries: a wall counts where it runs along the whole edge.
BlockSupports read_supports(const Problem& problem, const SolidBody& body);

/// Vertical motion of one point of the block.
struct PointHistory {
    std::vector<double> time;         // [s]
    std::vector<double> displacement; // u_y [m]
};

/// Turn of a history: its largest sag, and the time of the parabola through all within a hundredth of it,
/// which ripples of higher modes on a flat turn do not move.
struct Peak {
    double time = 0.0;         // [s]
    double displacement = 0.0; // [m]
};

/// A history has to go on to this multiple of the time of its largest sag [-].
inline constexpr double peak_margin = 1.2;

/// Throws InputError where the history does not turn.
Peak first_peak(const PointHistory& history);

/// u_y at a time, linear between the samples [m].
double displacement_at(const PointHistory& history, double time);

/// Let the block go at t = 0 and follow a point of it to peak_margin times the time of its first turn.
/// `elements` across the shorter side.
PointHistory drop_block(const SolidBody& body, const BlockSupports& supports, double gravity, int elements,
                        const Vector2& point);

} // namespace quicksand
