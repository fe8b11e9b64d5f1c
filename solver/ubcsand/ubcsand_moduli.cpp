// The elastic moduli of arrays of points, by which the length of a step is chosen.
#if defined(__GNUC__) && !defined(__clang__)
// lets both sides of a choice be computed, as ubcsand_arrays.cpp does; changes no value
#pragma GCC optimize("no-trapping-math", "no-thread-jumps", "no-tree-loop-distribute-patterns")
#endif

#include "solver/base/lanes.hpp"
#include "solver/particles/particle_moduli.hpp"
#include "solver/particles/particles.hpp"
#include "solver/ubcsand/ubcsand.hpp"
#include "solver/ubcsand/ubcsand_kernel.hpp"

namespace quicksand {

using namespace ubcsand;

VECTOR_KERNEL
ParticleModuli particle_moduli(const UbcSand& law, std::size_t first, std::size_t last,
                               const double* stress_xx, const double* stress_yy, const double* volume)
{
    return collect_moduli(first, last, volume, [&](std::size_t p) {
        const double s = larger(law.s_min, -0.5 * (stress_xx[p] + stress_yy[p]));
        return moduli_at(law, s).E1;
    });
}

VECTOR_KERNEL
ParticleModuli expected_moduli(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                               const Gradients& L, const double* stress_xx, const double* stress_yy,
                               const double* volume)
{
    const double *L_xx = L.xx.data(), *L_xy = L.xy.data(), *L_yx = L.yx.data(), *L_yy = L.yy.data();
    const double dilation = law.dilation * larger(0.0, law.eta_f - law.sin_cv); // of a shear strain
    return collect_moduli(first, last, volume, [&](std::size_t p) {
        const double s = larger(law.s_min, -0.5 * (stress_xx[p] + stress_yy[p]));
        const Moduli present = moduli_at(law, s);
        const double x = L_xx[p] - L_yy[p], xy = L_xy[p] + L_yx[p];
        const double strain =
            larger(0.0, -dt * (L_xx[p] + L_yy[p])) + dt * dilation * std::sqrt(x * x + xy * xy);
        return present.E1 * (1.0 + 0.5 * present.K / s * strain);
    });
}

} // namespace quicksand
