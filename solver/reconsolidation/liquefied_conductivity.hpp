// The conductivity of liquefied sand, whose grains float.
//
//   k/k_0 = 1 + (largest - 1) ru^8.9      as Shahir and others (2012) let it fall [Sha12]
// ru is the part of s_0 above the floor of the law that is lost, so that sand at the floor floats however
// little stress it had. [Sha12] let k grow by ru^1.0: then sand of ru = 0.4 drains 2.6 times faster at
// unchanged voids, and slopes shaken a little less do not liquefy at all [own].
#pragma once

#include "solver/particles/particles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace quicksand {

/// k over that of sand at rest [-], at a mean stress s, of the floor of the law and of the start [Pa];
/// `largest` is that at ru = 1 [-].
inline double liquefied_conductivity_factor(double largest, double s, double floor, double start_mean)
{
    constexpr double exponent = 8.9; // of ru [-] [Sha12]
    const double lost = start_mean - s, whole = start_mean - floor;
    const double ru = whole > 0.0 ? std::clamp(lost / whole, 0.0, 1.0) : 1.0;
    return 1.0 + (largest - 1.0) * std::pow(ru, exponent);
}

/// The same of a particle whose memory has a ShakingHistory from the column `first` on; 1 before the shaking,
/// when there is no memory.
template <class Law>
double liquefied_conductivity_factor(const Law& law, std::size_t first, std::size_t p,
                                     const Particles& particles)
{
    if (law.liquefied_conductivity <= 1.0 || particles.memory.size() <= first) return 1.0;
    const double floor = least_mean_stress(law);
    const double s = std::max(floor, -0.5 * (particles.stress.xx[p] + particles.stress.yy[p]));
    return liquefied_conductivity_factor(law.liquefied_conductivity, s, floor, particles.memory[first][p]);
}

} // namespace quicksand
