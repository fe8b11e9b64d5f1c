#include "solver/cpdi.hpp"

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

bool Cpdi::evaluate(const BackgroundGrid& grid, const Particles& particles, std::size_t p, NodePatch& patch)
{
    ParallelogramDomain domain{particles.position[p], particles.half_edge_1[p], particles.half_edge_2[p]};
    const bool limited = limit_domain(grid.cell_size, domain);
    evaluate_cpdi(grid, domain, patch);
    return limited;
}

void evaluate_cpdi(const BackgroundGrid& grid, const ParallelogramDomain& domain, NodePatch& patch)
{
    const Vector2 &r1 = domain.half_edge_1, &r2 = domain.half_edge_2, &x = domain.centre;
    const double inverse_volume = 1.0 / (4.0 * (r1.x() * r2.y() - r1.y() * r2.x()));
    const Vector2 g1 = inverse_volume * Vector2(r1.y() - r2.y(), r2.x() - r1.x());
    const Vector2 g2 = inverse_volume * Vector2(r1.y() + r2.y(), -r1.x() - r2.x());
    const CornerWeights corners[4] = {
        {x - r1 - r2, 0.25, g1}, {x + r1 - r2, 0.25, g2}, {x + r1 + r2, 0.25, -g1}, {x - r1 + r2, 0.25, -g2}};
    sum_corner_weights(grid, corners, patch);
}

void sum_corner_weights(const BackgroundGrid& grid, const CornerWeights (&corners)[4], NodePatch& patch)
{
    const Vector2 rim = grid.rim_origin();
    const double inverse = 1.0 / grid.cell_size;
    PlaceInCell cells[4];
    for (int c = 0; c < 4; ++c) cells[c] = place_in_cell((corners[c].position - rim) * inverse);
    const auto [i_min, i_max] = std::minmax({cells[0].i, cells[1].i, cells[2].i, cells[3].i});
    const auto [j_min, j_max] = std::minmax({cells[0].j, cells[1].j, cells[2].j, cells[3].j});
    patch.width = i_max - i_min + 2;
    patch.height = j_max - j_min + 2;
    patch.column = i_min, patch.row = j_min;

    std::fill_n(patch.weights, patch.width * patch.height, NodeWeight{0.0, 0.0, 0.0});
    for (int c = 0; c < 4; ++c) {
        const PlaceInCell& cell = cells[c];
        const double N[2][2] = {{(1.0 - cell.xi) * (1.0 - cell.eta), cell.xi * (1.0 - cell.eta)},
                                {(1.0 - cell.xi) * cell.eta, cell.xi * cell.eta}};
        NodeWeight* row = patch.weights + (cell.j - j_min) * patch.width + (cell.i - i_min);
        for (int b = 0; b < 2; ++b, row += patch.width) {
            for (int a = 0; a < 2; ++a) {
                row[a].value += corners[c].value * N[b][a];
                row[a].gradient_x += corners[c].gradient.x() * N[b][a];
                row[a].gradient_y += corners[c].gradient.y() * N[b][a];
            }
        }
    }
}

} // namespace quicksand
