#include "app/bench/law_benchmark.hpp"

#include "solver/ubcsand/ubcsand_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

namespace quicksand {

namespace {

constexpr std::size_t particle_count = 4096;
constexpr int steps_of_a_run = 100;
constexpr std::size_t runs = 7;

/// Simple shear of every particle in step k: its rate times dt.
using Shear = double (*)(int k);

double ripple(int k)
{
    return k % 2 == 0 ? -2e-7 : 2e-7; // below the reversal tolerance: elastic
}

double loading(int)
{
    return 1e-6; // plastic, one substep
}

Particles sand_at_100_kpa(const UbcSand& law)
{
    Particles particles;
    resize(particles, particle_count, std::nullopt);
    add_memory(particles, memory_of(law).size());
    for (std::size_t p = 0; p < particle_count; ++p) {
        const double vertical = 100e3 * (1.0 + 1e-3 * static_cast<double>(p % 7));
        particles.stress.yy[p] = -vertical;
        particles.stress.xx[p] = particles.stress.zz[p] = -0.5 * vertical;
    }
    start_memory(law, 0, particle_count, particles);
    return particles;
}

/// Wall time of a particle and step, the median of the runs [ns].
template <class Run>
double median_nanoseconds(Run&& run)
{
    std::array<double, runs> costs{};
    for (double& cost : costs) {
        const auto start = std::chrono::steady_clock::now();
        run();
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        cost = 1e9 * seconds / (static_cast<double>(particle_count) * steps_of_a_run);
    }
    std::nth_element(costs.begin(), costs.begin() + runs / 2, costs.end());
    return costs[runs / 2];
}

double cost_in_vectors(const UbcSand& law, Shear shear)
{
    const Particles start = sand_at_100_kpa(law);
    return median_nanoseconds([&] {
        Particles particles = start;
        for (int k = 0; k < steps_of_a_run; ++k) {
            std::fill(particles.velocity_gradient_solid.xy.begin(),
                      particles.velocity_gradient_solid.xy.end(), -shear(k));
            update_stress(law, 1.0, 0, particle_count, particles);
        }
    });
}

double cost_one_by_one(const UbcSand& law, Shear shear)
{
    const Particles start = sand_at_100_kpa(law);
    std::vector<UbcSandState> states(particle_count);
    return median_nanoseconds([&] {
        for (std::size_t p = 0; p < particle_count; ++p) {
            states[p] = UbcSandState();
            states[p].sigma_x = states[p].sigma_z = -start.stress.xx[p];
            states[p].sigma_y = -start.stress.yy[p];
            begin_shaking(law, states[p]);
        }
        for (int k = 0; k < steps_of_a_run; ++k) {
            for (UbcSandState& state : states) update(law, {0.0, 0.0, shear(k), 0.0}, state);
        }
    });
}

} // namespace

std::string describe_law_cost()
{
    const UbcSand law = make_ubcsand(with(UbcSandRunSettings(), nevada_sand_55()));
    std::string text =
        fmt::format("UBCSAND alone, {} particles in one substep each: median of {} runs\n{:<16}"
                    "{:>20}{:>20}{:>12}\n",
                    particle_count, runs, "step", "one by one, ns", "in vectors, ns", "ratio");
    const auto row = [&](const char* name, Shear shear) {
        const double single = cost_one_by_one(law, shear), vectors = cost_in_vectors(law, shear);
        text += fmt::format("{:<16}{:>20.1f}{:>20.1f}{:>12.2f}\n", name, single, vectors, single / vectors);
    };
    row("elastic", ripple);
    row("plastic", loading);
    return text;
}

} // namespace quicksand
