#include "solver/interpolation/gimp.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// The hat function around 0 in cells.
double hat(double z)
{
    return std::max(0.0, 1.0 - std::abs(z));
}

/// Its integral from `low` to `high`. Each side by its distances from the foot: what just reaches over the
/// foot has the square of the overlap, without the rounding of what lies between.
double hat_integral(double low, double high)
{
    const auto flank = [](double from_foot, double to_top) { // a slope of 1 from the foot on
        const double a = std::clamp(from_foot, 0.0, 1.0), b = std::clamp(to_top, 0.0, 1.0);
        return 0.5 * (b * b - a * a);
    };
    return flank(1.0 + low, 1.0 + high) + flank(1.0 - high, 1.0 - low);
}

/// Weights of one direction.
struct LineWeights {
    int first = 0, count = 0; // nodes [-]
    double value[NodeStencil::max_width];
    double slope[NodeStencil::max_width]; // [1/m]
};

LineWeights line_weights(double cells, double length_in_cells, double cell_size)
{
    LineWeights line;
    const double low = cells - 0.5 * length_in_cells, high = cells + 0.5 * length_in_cells;
    // an overlap of rounding alone would give a node a force without a mass
    constexpr double rounding = 1e-10;
    line.first = static_cast<int>(low + rounding);
    line.count = static_cast<int>(high - rounding) - line.first + 2;
    for (int a = 0; a < line.count; ++a) {
        const double node = line.first + a;
        line.value[a] = hat_integral(low - node, high - node) / length_in_cells;
        line.slope[a] = (hat(high - node) - hat(low - node)) / (length_in_cells * cell_size);
    }
    return line;
}

/// Lengths of a box as far as its weights may reach [m].
Vector2 limited(const BackgroundGrid& grid, const Vector2& lengths)
{
    return lengths.cwiseMin(2.0 * BackgroundGrid::domain_reach * grid.cell_size);
}

/// The weights of a box of such lengths [m] around a centre; whether they reached too far and were limited.
bool evaluate_box(const BackgroundGrid& grid, const Vector2& centre, Vector2 lengths, NodeStencil& stencil)
{
    const Vector2 asked = lengths;
    lengths = limited(grid, asked);
    const Vector2 cells = grid.cells_from_rim(centre);
    const LineWeights x = line_weights(cells.x(), lengths.x() / grid.cell_size, grid.cell_size);
    const LineWeights y = line_weights(cells.y(), lengths.y() / grid.cell_size, grid.cell_size);
    stencil.column = x.first, stencil.row = y.first;
    stencil.width = x.count;
    stencil.height = y.count;
    NodeWeight* weight = stencil.weights;
    for (int b = 0; b < y.count; ++b) {
        for (int a = 0; a < x.count; ++a) {
            *weight++ = {x.value[a] * y.value[b], x.slope[a] * y.value[b], x.value[a] * y.slope[b]};
        }
    }
    return lengths != asked;
}

/// Size of the axis-parallel box around the reference domain [m].
Vector2 reference_lengths(const Particles& particles, std::size_t p)
{
    return 2.0 * (particles.reference_edge_1[p].cwiseAbs() + particles.reference_edge_2[p].cwiseAbs());
}

/// Size of the box that stretches with the domain.
Vector2 stretched_lengths(const Particles& particles, std::size_t p)
{
    // U = sqrt(C) of C = F^T F; in two dimensions sqrt(C) = (C + J I) / sqrt(tr C + 2 J)
    const Eigen::Matrix2d F = deformation_gradient(particles, p);
    const Eigen::Matrix2d C = F.transpose() * F;
    const double J = F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0);
    const double scale = 1.0 / std::sqrt(C(0, 0) + C(1, 1) + 2.0 * J);
    const Vector2 stretches = scale * Vector2(C(0, 0) + J, C(1, 1) + J);
    return reference_lengths(particles, p).cwiseProduct(stretches);
}

} // namespace

Vector2 uniform_box(const BackgroundGrid& grid, const Particles& particles, std::size_t p)
{
    return limited(grid, reference_lengths(particles, p));
}

Vector2 contiguous_box(const BackgroundGrid& grid, const Particles& particles, std::size_t p)
{
    return limited(grid, stretched_lengths(particles, p));
}

bool UniformGimp::evaluate(const BackgroundGrid& grid, const Particles& particles, std::size_t p,
                           NodeStencil& stencil)
{
    return evaluate_box(grid, particles.position[p], reference_lengths(particles, p), stencil);
}

bool ContiguousGimp::evaluate(const BackgroundGrid& grid, const Particles& particles, std::size_t p,
                              NodeStencil& stencil)
{
    return evaluate_box(grid, particles.position[p], stretched_lengths(particles, p), stencil);
}

} // namespace quicksand
