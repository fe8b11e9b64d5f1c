// The slope of a quantity over a cell from its mean and those of its neighbours, by least squares.
#pragma once

#include "solver/base/conventions.hpp"

#include <algorithm>

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

/// The weight of a neighbour with this volume of soil beside a cell's own: 1 down to half of it. Slivers of
/// soil have pressures of their own, which must not bend that of the cells beside.
inline double weight_of_soil(double volume, double own)
{
    return std::min(1.0, 2.0 * volume / own);
}

/// The least-squares plane through a cell and its neighbours, which may pass the cell's own value: what bends
/// along the end of a body, where neighbours lie on one side, has no slope across it.
class PlaneFit {
public:
    /// A neighbour at `apart` from the cell [m] that differs by `difference` and counts as `weight` cells.
    void add(double weight, const Vector2& apart, double difference)
    {
        weight_ += weight;
        apart_ += weight * apart;
        difference_ += weight * difference;
        moments_.xx += weight * apart.x() * apart.x();
        moments_.xy += weight * apart.x() * apart.y();
        moments_.yy += weight * apart.y() * apart.y();
        moments_.x += weight * apart.x() * difference;
        moments_.y += weight * apart.y() * difference;
    }

    /// As SlopeFit::slope() [quantity/m].
    Vector2 slope(double cell_size) const
    {
        const Vector2 mean = apart_ / weight_;
        SlopeFit fit = moments_; // about the centre of all
        fit.xx -= mean.x() * apart_.x();
        fit.xy -= mean.x() * apart_.y();
        fit.yy -= mean.y() * apart_.y();
        fit.x -= mean.x() * difference_;
        fit.y -= mean.y() * difference_;
        return fit.slope(cell_size);
    }

private:
    double weight_ = 1.0;             // the cell's own and its neighbours' [cells]
    Vector2 apart_ = Vector2::Zero(); // sums over the neighbours, about the cell: it adds nothing itself
    double difference_ = 0.0;
    SlopeFit moments_;
};

} // namespace quicksand
