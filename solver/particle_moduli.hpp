// How stiff the skeleton of a few particles is, for the time step.
#pragma once

#include <algorithm>
#include <cstddef>

namespace quicksand {

/// P-wave moduli of unloading at the particles' present state, per present volume, in the stiffest direction.
struct ParticleModuli {
    double mean = 0.0;     // over their volume [Pa]
    double stiffest = 0.0; // of any of them [Pa]
};

/// Those of the particles [first, last) from modulus(p) [Pa] and their volumes [m3/m].
template <class Modulus>
ParticleModuli collect_moduli(std::size_t first, std::size_t last, const double* volume, Modulus&& modulus)
{
    double stiffest = 0.0, sum = 0.0, whole = 0.0;
    for (std::size_t p = first; p < last; ++p) {
        const double M = modulus(p);
        stiffest = std::max(stiffest, M);
        sum += volume[p] * M;
        whole += volume[p];
    }
    return {sum / whole, stiffest};
}

} // namespace quicksand
