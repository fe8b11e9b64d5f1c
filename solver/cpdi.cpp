#include "solver/cpdi.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// Scale one edge so that neither component of the whole edge exceeds a cell.
bool limit_edge(double cell_size, Vector2& half_edge)
{
    const double longest = 2.0 * std::max(std::abs(half_edge.x()), std::abs(half_edge.y()));
    if (longest <= cell_size) return false;
    half_edge *= cell_size / longest;
    return true;
}

/// A corner's cell and its place in it.
struct Corner {
    int i, j;
    double xi, eta; // 0..1 from the cell's lower left node [-]
};

Corner locate(const Vector2& point, const Vector2& rim, double inverse_cell_size)
{
    const double x = (point.x() - rim.x()) * inverse_cell_size, y = (point.y() - rim.y()) * inverse_cell_size;
    const int i = static_cast<int>(x), j = static_cast<int>(y); // coordinates from the rim are positive
    return {i, j, x - i, y - j};
}

} // namespace

bool limit_domain(double cell_size, ParallelogramDomain& domain)
{
    const bool first = limit_edge(cell_size, domain.half_edge_1);
    const bool second = limit_edge(cell_size, domain.half_edge_2);
    return first || second;
}

void evaluate_cpdi(const BackgroundGrid& grid, const ParallelogramDomain& domain, NodePatch& patch)
{
    const Vector2 &r1 = domain.half_edge_1, &r2 = domain.half_edge_2;
    const double inverse_volume = 1.0 / (4.0 * (r1.x() * r2.y() - r1.y() * r2.x()));
    // d phi / d N_i(x_c) for corners 1 and 2; corners 3 and 4 have the opposite sign
    const Vector2 g1 = inverse_volume * Vector2(r1.y() - r2.y(), r2.x() - r1.x());
    const Vector2 g2 = inverse_volume * Vector2(r1.y() + r2.y(), -r1.x() - r2.x());

    const Vector2 rim = grid.rim_origin();
    const double inverse = 1.0 / grid.cell_size;
    const Corner corners[4] = {
        locate(domain.centre - r1 - r2, rim, inverse), locate(domain.centre + r1 - r2, rim, inverse),
        locate(domain.centre + r1 + r2, rim, inverse), locate(domain.centre - r1 + r2, rim, inverse)};
    const double gx[4] = {g1.x(), g2.x(), -g1.x(), -g2.x()};
    const double gy[4] = {g1.y(), g2.y(), -g1.y(), -g2.y()};

    const auto [i_min, i_max] = std::minmax({corners[0].i, corners[1].i, corners[2].i, corners[3].i});
    const auto [j_min, j_max] = std::minmax({corners[0].j, corners[1].j, corners[2].j, corners[3].j});
    patch.width = i_max - i_min + 2;
    patch.height = j_max - j_min + 2;
    patch.base = j_min * grid.nodes_x() + i_min;
    patch.offset_x = rim.x() + i_min * grid.cell_size - domain.centre.x();
    patch.offset_y = rim.y() + j_min * grid.cell_size - domain.centre.y();

    std::fill_n(patch.weights, patch.width * patch.height, NodeWeight{0.0, 0.0, 0.0});
    for (int c = 0; c < 4; ++c) {
        const Corner& corner = corners[c];
        const double N[2][2] = {{(1.0 - corner.xi) * (1.0 - corner.eta), corner.xi * (1.0 - corner.eta)},
                                {(1.0 - corner.xi) * corner.eta, corner.xi * corner.eta}};
        NodeWeight* row = patch.weights + (corner.j - j_min) * patch.width + (corner.i - i_min);
        for (int b = 0; b < 2; ++b, row += patch.width) {
            for (int a = 0; a < 2; ++a) {
                row[a].value += 0.25 * N[b][a];
                row[a].gradient_x += gx[c] * N[b][a];
                row[a].gradient_y += gy[c] * N[b][a];
            }
        }
    }
}

} // namespace quicksand
