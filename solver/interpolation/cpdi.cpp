#include "solver/interpolation/cpdi.hpp"

#include <algorithm>

namespace quicksand {

bool limit_domain(double cell_size, ParallelogramDomain& domain)
{
    const Vector2 reach = domain.half_edge_1.cwiseAbs() + domain.half_edge_2.cwiseAbs();
    const double allowed = BackgroundGrid::domain_reach * cell_size, farthest = reach.maxCoeff();
    if (farthest <= allowed) return false;
    domain.half_edge_1 *= allowed / farthest;
    domain.half_edge_2 *= allowed / farthest;
    return true;
}

bool Cpdi::evaluate(const BackgroundGrid& grid, const Particles& particles, std::size_t p,
                    NodeStencil& stencil)
{
    ParallelogramDomain domain{particles.position[p], particles.half_edge_1[p], particles.half_edge_2[p]};
    const bool limited = limit_domain(grid.cell_size, domain);
    evaluate_cpdi(grid, domain, stencil);
    return limited;
}

void evaluate_cpdi(const BackgroundGrid& grid, const ParallelogramDomain& domain, NodeStencil& stencil)
{
    const Vector2 &r1 = domain.half_edge_1, &r2 = domain.half_edge_2, &x = domain.centre;
    const double inverse_volume = 1.0 / (4.0 * (r1.x() * r2.y() - r1.y() * r2.x()));
    const Vector2 g1 = inverse_volume * Vector2(r1.y() - r2.y(), r2.x() - r1.x());
    const Vector2 g2 = inverse_volume * Vector2(r1.y() + r2.y(), -r1.x() - r2.x());
    const CornerWeights corners[4] = {
        {x - r1 - r2, 0.25, g1}, {x + r1 - r2, 0.25, g2}, {x + r1 + r2, 0.25, -g1}, {x - r1 + r2, 0.25, -g2}};
    sum_corner_weights(grid, corners, stencil, grid.line_tolerance);
}

void sum_corner_weights(const BackgroundGrid& grid, std::span<const CornerWeights> corners,
                        NodeStencil& stencil, double tolerance)
{
    const Vector2 rim = grid.rim_origin();
    const double inverse = 1.0 / grid.cell_size;
    const auto place_of = [&](const CornerWeights& corner) {
        return place_in_cell((corner.position - rim) * inverse, tolerance);
    };
    PlaceInCell lower = place_of(corners.front()), upper = lower;
    for (const CornerWeights& corner : corners) {
        const PlaceInCell cell = place_of(corner);
        lower.i = std::min(lower.i, cell.i), lower.j = std::min(lower.j, cell.j);
        upper.i = std::max(upper.i, cell.i), upper.j = std::max(upper.j, cell.j);
    }
    stencil.width = upper.i - lower.i + 2;
    stencil.height = upper.j - lower.j + 2;
    stencil.column = lower.i, stencil.row = lower.j;

    std::fill_n(stencil.weights, stencil.width * stencil.height, NodeWeight{0.0, 0.0, 0.0});
    for (const CornerWeights& corner : corners) {
        const PlaceInCell cell = place_of(corner);
        const double N[2][2] = {{(1.0 - cell.xi) * (1.0 - cell.eta), cell.xi * (1.0 - cell.eta)},
                                {(1.0 - cell.xi) * cell.eta, cell.xi * cell.eta}};
        NodeWeight* row = stencil.weights + (cell.j - lower.j) * stencil.width + (cell.i - lower.i);
        for (int b = 0; b < 2; ++b, row += stencil.width) {
            for (int a = 0; a < 2; ++a) {
                row[a].value += corner.value * N[b][a];
                row[a].gradient_x += corner.gradient.x() * N[b][a];
                row[a].gradient_y += corner.gradient.y() * N[b][a];
            }
        }
    }
}

} // namespace quicksand
