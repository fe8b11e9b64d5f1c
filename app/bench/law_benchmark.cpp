#include "app/bench/law_benchmark.hpp"

#include "io/laws/soil_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <variant>

namespace quicksand {

namespace {

constexpr std::size_t particle_count = 1024;
constexpr int steps_of_a_run = 100;
constexpr std::size_t runs = 7;

/// Simple shear of every particle in step k: its rate times dt.
using Shear = double (*)(int k);

double ripple(int k)
{
    return k % 2 == 0 ? -2e-7 : 2e-7; // below the reversal tolerance of UBCSAND: elastic
}

double loading(int)
{
    return 1e-6; // where the soil yields, in one substep
}

void shear_all(const SkeletonLaw& law, double shear, Particles& particles)
{
    std::fill(particles.velocity_gradient_solid.xy.begin(), particles.velocity_gradient_solid.xy.end(),
              -shear);
    std::visit([&](const auto& any) { update_stress(any, 1.0, 0, particle_count, particles); }, law);
}

/// At 100 kPa, K0 = 0.5 and after a shear strain that brings soil with a strength to it.
Particles soil_at_100_kpa(const SkeletonLaw& law)
{
    Particles particles;
    resize(particles, particle_count, std::nullopt);
    add_memory(particles, memory_of(law).size());
    for (std::size_t p = 0; p < particle_count; ++p) {
        const double vertical = 100e3 * (1.0 + 1e-3 * static_cast<double>(p % 7));
        particles.stress.yy[p] = -vertical;
        particles.stress.xx[p] = particles.stress.zz[p] = -0.5 * vertical;
        particles.half_edge_1.x[p] = particles.half_edge_2.y[p] = 0.5;
        particles.volume[p] = particles.mass_solid[p] = 1.0;
    }
    reset_reference(particles);
    start_memory(law, 0, particle_count, particles);
    for (int k = 0; k < 200; ++k) shear_all(law, 1e-5, particles);
    return particles;
}

/// Wall time of a particle and step, the median of the runs [ns].
double cost_of(const SkeletonLaw& law, Shear shear)
{
    const Particles start = soil_at_100_kpa(law);
    std::array<double, runs> costs{};
    for (double& cost : costs) {
        Particles particles = start;
        const auto begin = std::chrono::steady_clock::now();
        for (int k = 0; k < steps_of_a_run; ++k) shear_all(law, shear(k), particles);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        cost = 1e9 * seconds / (static_cast<double>(particle_count) * steps_of_a_run);
    }
    std::nth_element(costs.begin(), costs.begin() + runs / 2, costs.end());
    return costs[runs / 2];
}

} // namespace

std::string describe_law_cost()
{
    std::string text = fmt::format("Soil laws alone, {} particles: median of {} runs\n{:<20}{:>16}{:>16}\n",
                                   particle_count, runs, "law", "elastic, ns", "loading, ns");
    for (const SoilLaw& law : soil_laws()) {
        const SkeletonLaw example = example_of(law);
        text += fmt::format("{:<20}{:>16.1f}{:>16.1f}\n", law.word, cost_of(example, ripple),
                            cost_of(example, loading));
    }
    return text;
}

} // namespace quicksand
