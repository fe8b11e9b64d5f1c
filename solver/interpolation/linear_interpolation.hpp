// The bilinear functions of the cell, taken at the particle: phi_ip = N_i(x_p).
#pragma once

#include "solver/interpolation/interpolation.hpp"

namespace quicksand {

struct LinearInterpolation {
    static bool evaluate(const BackgroundGrid& grid, const Particles& particles, std::size_t p,
                         NodeStencil& stencil);
};

} // namespace quicksand
