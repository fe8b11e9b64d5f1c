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
    constexpr std::size_t block = 8; // evaluated side by side
    double M[block];
    double stiffest = 0.0, sum = 0.0, whole = 0.0;
    for (std::size_t start = first; start < last; start += block) {
        const std::size_t count = std::min(block, last - start);
        if (count == block) {
            for (std::size_t k = 0; k < block; ++k) M[k] = modulus(start + k);
        } else {
            for (std::size_t k = 0; k < count; ++k) M[k] = modulus(start + k);
        }
        for (std::size_t k = 0; k < count; ++k) {
            stiffest = std::max(stiffest, M[k]);
            sum += volume[start + k] * M[k];
            whole += volume[start + k];
        }
    }
    return {sum / whole, stiffest};
}

} // namespace quicksand
