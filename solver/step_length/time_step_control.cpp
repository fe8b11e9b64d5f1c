#include "solver/step_length/time_step_control.hpp"

#include "solver/base/failure.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/step_length/accuracy_control.hpp"
#include "solver/step_length/cell_extremes.hpp"
#include "solver/step_length/own_vibration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

// Random motion of partly filled patches grows from 0.795 h / c on, in the two-phase step (k from 1e-2 to
// 1e-5 m/s) and in that of one phase alike, and the vortex of the largest shear fails at 0.75 on 96 cells;
// the rest is margin, which soil that moves less leaves unused.
constexpr double wave_safety = 0.65;
// Local damping adds up to 70 % to a braking force, which raises frequencies by a third; 0.65 grows, 0.45
// settles.
constexpr double relaxation_safety = 0.45;
// Of the limits of the slow P wave and the dragged shear wave: random motion decays at 0.78 of them and grows
// at 0.84, for k from 1e-3 to 1e-5 m/s and G of 20 and 100 MPa.
constexpr double semi_implicit_safety = 0.72;
// Waves at nodes of cut cells, over those of whole ones: where a wall and a free surface meet in a cell
// random motion decays at the step without it and grows at 1.05 of it (columns at 9 angles and 8 offsets);
// the margin is that of whole cells.
constexpr double cut_cell_fraction = 0.92;
constexpr double shear_safety = 0.85; // shear waves on a bilinear grid [-]
constexpr double motion_safety = 0.2; // of a cell per step [-]

/// The least of limit(material, its extremes, porosity) over all materials and their extreme cells.
template <class Limit>
TimeStep least_limit(const Problem& problem, const CellExtremes& extremes, Limit&& limit_of)
{
    TimeStep limit;
    limit.dt = std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < problem.materials.size(); ++m) {
        const Material& material = problem.materials[m];
        const MaterialExtremes& extreme = extremes.materials[m];
        if (extreme.min_porosity > extreme.max_porosity) continue; // no particle of this material
        for (const double porosity : {extreme.min_porosity, extreme.max_porosity}) {
            const double dt = limit_of(material, extreme, porosity);
            if (dt < limit.dt) limit = {dt, TimeStepLimiter::wave, material.name};
        }
    }
    return limit;
}

/// The fastest of a wave decides, by speed(material, its waves); 0: no wave of the material does.
template <class Speed>
TimeStep wave_limit(const Problem& problem, const CellExtremes& extremes, double safety, Speed&& speed)
{
    const auto limit = [&](const Material& material, const MaterialExtremes& extreme, double porosity) {
        return safety * problem.grid.cell_size /
               speed(material,
                     wave_speeds(material, extreme.stiffest_modulus, water_of(problem, material), porosity));
    };
    return least_limit(problem, extremes, limit);
}

/// The drag beyond it brakes a motion that changes its sign in every step: 2 (C dt - this), see centre_drag.
double centred_drag_impulse(double r_s, double r_w)
{
    return r_w > 0.0 ? 2.0 * semi_implicit_strong_drag * r_s * r_w / (r_s + r_w) : 0.0;
}

/// dt of the slow P wave where the pressure is implicit: the skeleton moves without changing the pressure.
double slow_wave_limit(double modulus, double drag, double n, double r_s, double r_w, double h)
{
    const double a = 4.0 * modulus / (h * h), half_b = drag / (n * n);
    const double mass = r_s + (1.0 - n) * (1.0 - n) / (n * n) * r_w;
    const double braked = 4.0 * mass - 2.0 * centred_drag_impulse(r_s, r_w) / (n * n);
    return std::max(std::sqrt(4.0 * mass / a), (half_b + std::sqrt(half_b * half_b + a * braked)) / a);
}

/// dt of the shear wave whose water is dragged along: between those of the grains alone and of the mixture.
double dragged_shear_limit(double G, double drag, double r_s, double r_w, double h)
{
    double low = h * std::sqrt(r_s / G), high = h * std::sqrt((r_s + r_w) / G);
    for (int halving = 0; halving < 40; ++halving) {
        const double dt = 0.5 * (low + high),
                     x = 2.0 * std::max(0.0, dt * drag - centred_drag_impulse(r_s, r_w));
        const bool stable = 4.0 * G / (h * h) * dt * dt <= 4.0 * r_s + 4.0 * r_w * x / (4.0 * r_w + x);
        (stable ? low : high) = dt;
    }
    return low;
}

TimeStep limit_motion(const Problem& problem, const CellExtremes& extremes, TimeStep limit)
{
    if (problem.strain == StrainForm::small) return limit; // no particle moves through the grid
    const double dt = motion_safety * problem.grid.cell_size / extremes.max_speed;
    return dt < limit.dt ? TimeStep{dt, TimeStepLimiter::motion, ""} : limit;
}

/// The slow P wave and the shear wave of every material.
TimeStep semi_implicit_limit(const Problem& problem, const CellExtremes& extremes)
{
    const double h = problem.grid.cell_size;
    return least_limit(
        problem, extremes, [&](const Material& material, const MaterialExtremes& extreme, double n) {
            const double modulus =
                std::max(extreme.stiffest_modulus,
                         extreme.stiffest_cut_modulus / (cut_cell_fraction * cut_cell_fraction));
            const double shear_fraction = std::visit(
                [](const auto& law) { return shear_modulus(law) / constrained_modulus(law); }, material.law);
            const bool wet = material.saturated;
            const double r_s = (1.0 - n) * material.grain_density,
                         r_w = wet ? n * problem.water->density : 0.0;
            const double most_conductive =
                std::visit([](const auto& law) { return largest_conductivity_factor(law); }, material.law);
            const double drag = wet ? drag_coefficient(material, *problem.water, n) / most_conductive : 0.0;
            return semi_implicit_safety *
                   std::min(slow_wave_limit(modulus, drag, n, r_s, r_w, h),
                            shear_safety * dragged_shear_limit(shear_fraction * modulus, drag, r_s, r_w, h));
        });
}

TimeStep limit_of_waves(const Problem& problem, const CellExtremes& extremes)
{
    if (water_flow(problem) == WaterFlow::coupled && problem.scheme != TimeScheme::explicit_steps)
        return semi_implicit_limit(problem, extremes);
    return wave_limit(problem, extremes, wave_safety, [&](const Material&, const WaveSpeeds& speeds) {
        return fastest_speed(problem, speeds);
    });
}

TimeStep step_from(const Problem& problem, double time, double whole_step, const Particles& particles,
                   double scale)
{
    const CellExtremes extremes = find_extremes(problem, particles);
    TimeStep limit = limit_of_waves(problem, extremes);
    if (const double coarsest = coarsest_step(problem, time); coarsest < limit.dt)
        limit = {coarsest, TimeStepLimiter::shaking, ""};
    if (problem.scheme == TimeScheme::implicit) {
        const double before = whole_step / (scale * problem.step_fraction); // of which the steps are a part
        limit = accurate_time_step(problem, time, before, limit.dt, particles, extremes);
    }
    if (scale < 1.0) {
        limit.dt *= scale;
        limit.limiter = TimeStepLimiter::vibration;
    }
    TimeStep step = limit_motion(problem, extremes, limit);
    step.dt *= problem.step_fraction;
    return step;
}

} // namespace

std::vector<WaveSpeeds> fastest_waves(const Problem& problem, const Particles& particles)
{
    const CellExtremes extremes = find_extremes(problem, particles);
    std::vector<WaveSpeeds> waves;
    for (std::size_t m = 0; m < problem.materials.size(); ++m) {
        const Material& material = problem.materials[m];
        const double M = extremes.materials[m].stiffest_modulus;
        waves.push_back(M > 0.0 ? wave_speeds(material, M, water_of(problem, material), material.porosity)
                                : wave_speeds(material, water_of(problem, material), material.porosity));
    }
    return waves;
}

double sound_time(const Problem& problem, const Particles& particles)
{
    if (water_flow(problem) != WaterFlow::coupled) return 0.0;
    double speed = 0.0;
    for (const WaveSpeeds& waves : fastest_waves(problem, particles)) speed = std::max(speed, waves.fast);
    return body_height(particles) / speed;
}

TimeStep stable_time_step(const Problem& problem, const State& state, double scale)
{
    return step_from(problem, state.time, state.whole_step, state.particles, scale);
}

TimeStep stable_time_step(const Problem& problem, const Particles& particles, double scale)
{
    return step_from(problem, 0.0, 0.0, particles, scale);
}

TimeStep stable_relaxation_step(const Problem& problem, const Particles& particles)
{
    const CellExtremes extremes = find_extremes(problem, particles);
    const bool soil_alone = has_soil_and_solids(problem); // solids resist accelerations with their stiffness
    const TimeStep wave = wave_limit(
        problem, extremes, relaxation_safety, [&](const Material& material, const WaveSpeeds& speeds) {
            if (soil_alone && !material.has_pores) return 0.0;
            return settles_undrained(problem) ? fastest_speed(problem, speeds) : speeds.skeleton;
        });
    return limit_motion(problem, extremes, wave);
}

const char* name_of(TimeStepLimiter limiter)
{
    switch (limiter) {
    case TimeStepLimiter::wave:
        return "wave";
    case TimeStepLimiter::sound:
        return "sound of the water";
    case TimeStepLimiter::vibration:
        return "vibration of the nodes";
    case TimeStepLimiter::inertia:
        return "inertia of shear waves";
    case TimeStepLimiter::own_vibration:
        return "vibration of the body";
    case TimeStepLimiter::shaking:
        return "period of the shaking";
    case TimeStepLimiter::growth:
        return "growth from step to step";
    case TimeStepLimiter::pressure:
        return "change of pore pressure";
    case TimeStepLimiter::strain:
        return "strain of a step";
    case TimeStepLimiter::flow:
        return "flow of the soil";
    case TimeStepLimiter::motion:
        return "motion";
    case TimeStepLimiter::output:
        return "output";
    }
    ENSURE(false);
}

const char* name_of(TimeScheme scheme)
{
    switch (scheme) {
    case TimeScheme::explicit_steps:
        return "explicit";
    case TimeScheme::semi_implicit:
        return "semi-implicit";
    case TimeScheme::implicit:
        return "implicit";
    }
    ENSURE(false);
}

} // namespace quicksand
