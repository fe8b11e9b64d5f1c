#include "solver/interpolation/linear_interpolation.hpp"

namespace quicksand {

bool LinearInterpolation::evaluate(const BackgroundGrid& grid, const Particles& particles, std::size_t p,
                                   NodeStencil& stencil)
{
    const double inverse = 1.0 / grid.cell_size;
    const auto [i, j, xi, eta] = place_in_cell((particles.position[p] - grid.rim_origin()) * inverse);
    stencil.column = i, stencil.row = j;
    stencil.width = stencil.height = 2;
    const double Nx[2] = {1.0 - xi, xi}, Ny[2] = {1.0 - eta, eta};
    const double dN[2] = {-inverse, inverse};
    for (int b = 0; b < 2; ++b) {
        for (int a = 0; a < 2; ++a)
            stencil.weights[2 * b + a] = {Nx[a] * Ny[b], dN[a] * Ny[b], Nx[a] * dN[b]};
    }
    return false;
}

} // namespace quicksand
