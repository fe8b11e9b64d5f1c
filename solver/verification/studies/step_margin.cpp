#include "solver/verification/studies/step_margin.hpp"

#include "solver/base/failure.hpp"
#include "solver/base/mixed_bits.hpp"
#include "solver/run/simulation.hpp"
#include "solver/vibration/step_bound.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace quicksand {

namespace {

constexpr double largest_share = 5.0, least_share = 0.05, precision = 1.02;
constexpr double growth = 30.0;    // of the motion's size
constexpr double cell_part = 1e-6; // that the motion covers in a step [-]
constexpr int portions = 10, portion_steps = 50;

/// In [-1, 1], the same on every machine.
double noise(std::uint64_t number)
{
    constexpr std::uint64_t start = 0x632be59bd9b4e019U - golden_increment;
    return 2.0 * static_cast<double>(mixed_bits(start + number * golden_increment) >> 11) * 0x1p-53 - 1.0;
}

void stir(double speed, Particles& particles)
{
    const bool flows = !particles.velocity_fluid.x.empty();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto number = 4 * static_cast<std::uint64_t>(particles.identifier[p]);
        particles.velocity_solid.x[p] += speed * noise(number);
        particles.velocity_solid.y[p] += speed * noise(number + 1);
        if (!flows) continue;
        particles.velocity_fluid.x[p] += speed * noise(number + 2);
        particles.velocity_fluid.y[p] += speed * noise(number + 3);
    }
}

/// sqrt(sum m |v_a - v_b|^2) of the grains; the arrays may be in different orders.
double distance(const Particles& a, const Particles& b)
{
    std::vector<std::size_t> place(b.size());
    for (std::size_t p = 0; p < b.size(); ++p) place[static_cast<std::size_t>(b.identifier[p])] = p;
    double squares = 0.0;
    for (std::size_t p = 0; p < a.size(); ++p) {
        const std::size_t q = place[static_cast<std::size_t>(a.identifier[p])];
        squares += a.mass_solid[p] * (a.velocity_solid[p] - b.velocity_solid[q]).squaredNorm();
    }
    return std::sqrt(squares);
}

bool grows(Problem problem, const State& start, double share)
{
    problem.step_fraction *= share;
    const double dt = measure_time_step(problem, start).dt;
    State calm = start, stirred = start;
    stir(cell_part * problem.grid.cell_size / dt, stirred.particles);
    const double size = distance(stirred.particles, calm.particles);
    try {
        for (int k = 1; k <= portions; ++k) {
            const double end = k * portion_steps * dt;
            run(problem, end, {}, calm);
            run(problem, end, {}, stirred);
            if (calm.times_halved + stirred.times_halved > 0) return true; // by the watchdog
            if (!(distance(stirred.particles, calm.particles) < growth * size)) return true;
        }
    } catch (const NumericalError&) {
        return true;
    }
    return false;
}

} // namespace

double step_margin(const Problem& problem, const State& start)
{
    double stable = 0.0, unstable = 1.0;
    while (unstable < largest_share && !grows(problem, start, unstable)) {
        stable = unstable;
        unstable *= 1.5;
    }
    while (stable == 0.0) {
        const double half = 0.5 * unstable;
        if (half < least_share) return 0.0;
        (grows(problem, start, half) ? unstable : stable) = half;
    }
    if (unstable >= largest_share) return largest_share;
    while (unstable > precision * stable) {
        const double between = std::sqrt(stable * unstable);
        (grows(problem, start, between) ? unstable : stable) = between;
    }
    return stable;
}

} // namespace quicksand
