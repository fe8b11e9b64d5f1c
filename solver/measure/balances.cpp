#include "solver/measure/balances.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/threads.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/water/pore_pressure.hpp"

#include <array>
#include <cmath>

namespace quicksand {

namespace {

/// sum value(p) over the particles, four sums side by side: one alone would wait for each addition.
template <class Value>
double sum_particles(std::size_t count, Value&& value)
{
    return ordered_sum(count, 0.0, [&](std::size_t first, std::size_t last) {
        std::array<double, 4> lanes{};
        for (; first + 4 <= last; first += 4)
            for (std::size_t k = 0; k < 4; ++k) lanes[k] += value(first + k);
        for (; first < last; ++first) lanes[0] += value(first);
        return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
    });
}

/// Sum over the particles [first, last) of the growth of their volume in the step times the velocity of their
/// water [m4/(m s)].
VECTOR_KERNEL
Vector2 momentum_of_growth(double dt, const Scalars& volume, const Particles& particles, std::size_t first,
                           std::size_t last)
{
    const Gradients& L = particles.velocity_gradient_solid;
    const Vectors& water =
        particles.velocity_fluid.x.empty() ? particles.velocity_solid : particles.velocity_fluid;
    const auto growth = [dt](const auto& V, const auto& xx, const auto& xy, const auto& yx, const auto& yy) {
        return V * (dt * (xx + yy) + dt * dt * (xx * yy - xy * yx));
    };
    Lanes x = all_lanes(0.0), y = x;
    std::size_t p = first;
    for (; p + 4 <= last; p += 4) {
        const Lanes dV = growth(load_lanes(&volume[p]), load_lanes(&L.xx[p]), load_lanes(&L.xy[p]),
                                load_lanes(&L.yx[p]), load_lanes(&L.yy[p]));
        x += dV * load_lanes(&water.x[p]);
        y += dV * load_lanes(&water.y[p]);
    }
    for (; p < last; ++p) {
        const double dV = growth(volume[p], L.xx[p], L.xy[p], L.yx[p], L.yy[p]);
        x[0] += dV * water.x[p];
        y[0] += dV * water.y[p];
    }
    return {(x[0] + x[1]) + (x[2] + x[3]), (y[0] + y[1]) + (y[2] + y[3])};
}

/// Whether a particle is wet, a function of its number; materials are looked up only where there are both
/// kinds.
auto wetness(const Problem& problem, const Particles& particles)
{
    return [&, all_wet = !is_partly_wet(problem)](std::size_t p) {
        return all_wet || is_wet(problem.materials[static_cast<std::size_t>(particles.material[p])]);
    };
}

/// With the kinetic energy that a sum over the particles has found.
EnergyBalance balance_energy(const Problem& problem, const State& state, double kinetic_energy)
{
    const BalanceTerms& terms = *state.balance_terms;
    EnergyBalance result;
    result.kinetic = kinetic_energy;
    const double kinetic = kinetic_energy - terms.opening_kinetic_energy;
    result.numerical_loss = terms.kinetic_change - kinetic + terms.wall_loss;
    const double outside = terms.gravity_work + terms.base_work + terms.boundary_work;
    double stored = 0.0, storage = 0.0;
    if (problem.water) {
        storage = storage_energy(problem, state.particles);
        // undrained, the skeleton's work is that of the total stress and includes the water's part
        if (water_flow(problem) == WaterFlow::coupled)
            stored = storage - terms.late_pressure_work - terms.opening_storage_energy;
    }
    result.residual = kinetic + result.numerical_loss + terms.skeleton_work + stored + terms.inertia_work +
                      terms.drag_dissipation - outside;
    result.turnover = kinetic_energy + terms.opening_kinetic_energy + std::abs(terms.skeleton_work) +
                      storage + std::abs(terms.opening_storage_energy) + std::abs(terms.inertia_work) +
                      std::abs(terms.drag_dissipation) + std::abs(terms.gravity_work) +
                      std::abs(terms.base_work) + std::abs(terms.boundary_work);
    return result;
}

} // namespace

void open_balances(const Problem& problem, State& state)
{
    const Monitors sums = monitor(problem, state, {});
    BalanceTerms terms;
    terms.opening_kinetic_energy = sums.kinetic_energy;
    terms.opening_momentum_x = sums.momentum_x;
    terms.opening_momentum_y = sums.momentum_y;
    if (problem.water) {
        terms.opening_storage_energy = storage_energy(problem, state.particles);
        terms.opening_water_content = water_content(problem, state.particles);
    }
    state.balance_terms = terms;
}

double stress_power(const Particles& particles)
{
    const Gradients& L = particles.velocity_gradient_solid;
    const SymmetricTensors& stress = particles.stress;
    return sum_particles(particles.size(), [&](std::size_t p) {
        return particles.volume[p] *
               (stress.xx[p] * L.xx[p] + stress.yy[p] * L.yy[p] + stress.xy[p] * (L.xy[p] + L.yx[p]));
    });
}

void enter_skeleton_work(double work, double work_of_nodes, BalanceTerms& terms)
{
    terms.skeleton_work += work - work_of_nodes;
    terms.inertia_work -= work - work_of_nodes;
}

void enter_outflow(const Problem& problem, double dt, const Particles& particles,
                   const Scalars& flux_divergence, BalanceTerms& terms)
{
    const Gradients& L = particles.velocity_gradient_solid;
    const auto is_wet = wetness(problem, particles);
    const auto outflow = [&](std::size_t p) {
        if (!is_wet(p)) return 0.0;
        return particles.volume[p] * (flux_divergence[p] - (L.xx[p] + L.yy[p]));
    };
    terms.outflow += dt * sum_particles(particles.size(), outflow);
}

void enter_exchange(const Problem& problem, double dt, const Particles& particles, BalanceTerms& terms)
{
    const bool pores_are_constant = problem.strain == StrainForm::small;
    if (!problem.water || pores_are_constant || water_flow(problem) == WaterFlow::undrained) return;
    Scalars wet;
    if (is_partly_wet(problem)) set_wet_volumes(problem, particles, wet);
    const Scalars& volume = wet.empty() ? particles.volume : wet;
    const Vector2 sum =
        ordered_sum<Vector2>(particles.size(), Vector2::Zero(), [&](std::size_t first, std::size_t last) {
            return momentum_of_growth(dt, volume, particles, first, last);
        });
    terms.exchange_x += problem.water->density * sum.x();
    terms.exchange_y += problem.water->density * sum.y();
}

BalanceErrors balance(const Problem& problem, const State& state)
{
    BalanceErrors result;
    if (!state.balance_terms) return result;
    const BalanceTerms& terms = *state.balance_terms;
    const Monitors sums = monitor(problem, state, {});
    const EnergyBalance energy = balance_energy(problem, state, sums.kinetic_energy);
    result.numerical_loss = energy.numerical_loss;
    result.energy_error = energy.error();
    // drained water comes and goes uncounted
    if (problem.water && water_flow(problem) != WaterFlow::drained && terms.opening_water_content > 0.0)
        result.water_error =
            (water_content(problem, state.particles) + terms.outflow - terms.opening_water_content) /
            terms.opening_water_content;
    result.momentum_error_x = sums.momentum_x - terms.opening_momentum_x - terms.impulse_x - terms.exchange_x;
    result.momentum_error_y = sums.momentum_y - terms.opening_momentum_y - terms.impulse_y - terms.exchange_y;
    return result;
}

EnergyBalance energy_balance(const Problem& problem, const State& state)
{
    if (!state.balance_terms) return {};
    return balance_energy(problem, state, kinetic_energy(problem, state.particles));
}

double energy_put_in(const BalanceTerms& terms)
{
    return terms.opening_kinetic_energy + std::abs(terms.opening_storage_energy) +
           std::abs(terms.gravity_work) + std::abs(terms.base_work) + std::abs(terms.boundary_work);
}

double storage_energy(const Problem& problem, const Particles& particles)
{
    double sum = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double pressure = excess_pore_pressure(particles, p);
        // cavities have opened against the tension of the limit
        const double missing = particles.tension_deficit.empty() ? 0.0 : particles.tension_deficit[p];
        sum += particles.porosity[p] * particles.volume[p] * pressure * (0.5 * pressure + missing);
    }
    return sum / problem.water->bulk_modulus;
}

double water_content(const Problem& problem, const Particles& particles)
{
    const bool fixed = problem.strain == StrainForm::small;
    const auto is_wet = wetness(problem, particles);
    const Scalars& heights = fixed ? particles.reference_position.y : particles.position.y;
    double sum = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!is_wet(p)) continue;
        // cavities have the volume that belongs to the missing tension
        const double cavities = particles.tension_deficit.empty() ? 0.0 : particles.tension_deficit[p];
        const double pressure =
            excess_pore_pressure(particles, p) + cavities + static_water_pressure(problem, heights[p]);
        sum += particles.porosity[p] * particles.volume[p] * (1.0 + pressure / problem.water->bulk_modulus);
        if (fixed) sum += particles.volume[p] * (deformation_gradient(particles, p).trace() - 2.0);
    }
    return sum;
}

} // namespace quicksand
