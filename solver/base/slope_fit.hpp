// The slope of a quantity over a cell from the means of its neighbours, by least squares.
#pragma once

#include "solver/base/conventions.hpp"

namespace quicksand {

/// Normal equations of the least-squares slope of a quantity from a cell to its neighbours.
struct SlopeFit {
    double xx = 0.0, xy = 0.0, yy = 0.0; // [m2]
    double x = 0.0, y = 0.0;             // [quantity m]

    void add(const Vector2& apart, double difference)
    {
        xx += apart.x() * apart.x();
        xy += apart.x() * apart.y();
        yy += apart.y() * apart.y();
        x += apart.x() * difference;
        y += apart.y() * difference;
    }

    /// The slope; along the one line that the neighbours lie on when they hardly span the plane. The slope
    /// across a line that is nearly straight, as of cells in one row, would be many times that along it
    /// [quantity/m].
    Vector2 slope(double cell_size) const
    {
        constexpr double width = 0.05; // squared, of what spans the plane [cells]
        const double determinant = xx * yy - xy * xy, trace = xx + yy;
        if (determinant > width * cell_size * cell_size * trace) // the product and the sum of the moments
            return Vector2(yy * x - xy * y, xx * y - xy * x) / determinant;
        return trace > 0.0 ? Vector2(x / trace, y / trace) : Vector2(0.0, 0.0);
    }
};

} // namespace quicksand
