#include "solver/run/watchdog.hpp"

#include "solver/measure/balances.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/motion/particle_order.hpp"
#include "solver/step/scheme_choice.hpp"
#include "solver/step_length/end_of_motion.hpp"
#include "solver/step_length/time_step_control.hpp"
#include "solver/vibration/small_motion.hpp"

#include <algorithm>
#include <string>

namespace quicksand {

namespace {

// Semi-implicit steps lose what they do not resolve of the sound of the water: less than 2e-3 of the energy
// turned over in the examples, 0.1 to 0.9 of it in random scenes with sudden loads, resonance of a body with
// its base, or cavities that close. Implicit steps lose as much where they are not much longer than those of
// sound; where they are, or where sound rises through half the body in one, it is not to be followed.
constexpr double most_steps_of_sound = 64.0;                  // in an implicit one
constexpr double most_of_body = 0.5;                          // that sound crosses in one of them
constexpr double energy_damped = 0.01, damped_at_once = 5e-4; // of the energy turned over
constexpr double energy_made = 0.1, made_at_once = 0.02;      // of the energy turned over
constexpr double most_growth = 4.0; // of the kinetic energy from one restart point to the next
// Of the energy put in: sound runs lose up to 0.8 of it from their start to their end.
constexpr double energy_lost = 2.0, lost_at_once = 0.1;

std::string percentage(double part)
{
    return std::to_string(static_cast<int>(100.0 * std::min(part, 10.0))) + " %";
}

/// What stress and water hold, which may have been there at the start: at most sum V sigma':sigma'/(4 G),
/// where Poisson's ratio is not negative [J/m].
double energy_held(const Problem& problem, const Particles& particles)
{
    const Scalars shear = tangent_moduli(problem, particles).shear;
    const SymmetricTensors& s = particles.stress;
    double sum = problem.water ? storage_energy(problem, particles) : 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double square =
            s.xx[p] * s.xx[p] + s.yy[p] * s.yy[p] + s.zz[p] * s.zz[p] + 2.0 * s.xy[p] * s.xy[p];
        sum += particles.volume[p] * square / (4.0 * shear[p]);
    }
    return sum;
}

/// The step that sound in the water limits [s].
double step_of_sound(const Problem& problem, const State& state)
{
    return stable_time_step(with_scheme(problem, TimeScheme::explicit_steps), state).dt;
}

/// Whether steps are implicit and too long to follow the sound of the water.
bool passes_over_sound(const Problem& problem, double dt, const State& state)
{
    if (problem.scheme != TimeScheme::implicit || water_flow(problem) != WaterFlow::coupled) return false;
    return dt > most_of_body * sound_time(problem, state.particles) ||
           dt > most_steps_of_sound * step_of_sound(problem, state);
}

[[noreturn]] void fail(const std::string& what, double dt, const State& state,
                       Remedy remedy = Remedy::shorter_steps)
{
    FailureRecord record = failure_at(dt, state, fastest_particle(state.particles));
    record.phase = "watchdog";
    record.what = what + "; the particle below is the fastest";
    record.causes = causes_of_instability;
    record.remedy = remedy;
    throw NumericalError(record);
}

} // namespace

void Watchdog::keep(const Problem& problem, State& state)
{
    if (problem.scheme == TimeScheme::implicit) state.step_halvings = 0;
    kept_ = state;
    energy_ = energy_balance(problem, state);
    if (state.time > failed_time_) halvings_ = 0;
}

void Watchdog::check_growth(const EnergyBalance& energy, double dt, const State& state) const
{
    constexpr std::int64_t first_steps = 4; // from rest: their errors are large parts of what is little yet
    if (energy_.kinetic == 0.0 && state.step - kept_.step < first_steps) return;
    if (energy.kinetic <= most_growth * energy_.kinetic || energy.error() <= energy_made) return;
    if (energy.residual - energy_.residual <= made_at_once * energy.turnover) return; // made before
    fail("the steps have made energy, " + percentage(energy.error()) +
             " of what was turned over, and the motion grows",
         dt, state);
}

void Watchdog::check_sound(const Problem& problem, const EnergyBalance& energy, double dt,
                           const State& state) const
{
    if (problem.scheme == TimeScheme::explicit_steps || water_flow(problem) != WaterFlow::coupled) return;
    if (kept_.step < state.explicit_end) return;              // the steps since then were explicit
    const double damped = energy_.residual - energy.residual; // since then
    if (energy.error() >= -energy_damped || damped <= damped_at_once * energy.turnover) return;
    if (passes_over_sound(problem, dt, state)) return;
    const std::string kind = problem.scheme == TimeScheme::implicit ? "implicit" : "semi-implicit";
    fail(kind + " steps have damped the sound of the water by " + percentage(-energy.error()) +
             " of the energy that was turned over",
         dt, state, Remedy::explicit_steps);
}

void Watchdog::check_loss(const Problem& problem, const EnergyBalance& energy, double dt,
                          const State& state) const
{
    const double loss = energy.numerical_loss;
    double given = energy_put_in(*state.balance_terms);
    if (loss <= energy_lost * given) return;        // as a rule
    given += energy_held(problem, kept_.particles); // stresses of steps that are too long have grown since
    const double at_once = loss - energy_.numerical_loss;
    if (loss <= energy_lost * given || at_once <= lost_at_once * given) return;
    fail("the steps have made energy that is lost again between particles and grid, " +
             percentage(at_once / given) + " of all that was put in",
         dt, state);
}

void Watchdog::check_growth(const Problem& problem, double dt, const State& state) const
{
    if (has_nothing_to_check(state) || begins_with_sound(problem, dt, state)) return;
    check_growth(energy_balance(problem, state), dt, state);
}

void Watchdog::check(const Problem& problem, double dt, const State& state) const
{
    if (has_nothing_to_check(state) || begins_with_sound(problem, dt, state)) return;
    const EnergyBalance energy = energy_balance(problem, state);
    check_growth(energy, dt, state);
    check_sound(problem, energy, dt, state);
    check_loss(problem, energy, dt, state);
}

bool Watchdog::has_nothing_to_check(const State& state) const
{
    return !state.balance_terms || state.step == kept_.step;
}

bool Watchdog::begins_with_sound(const Problem& problem, double dt, const State& state) const
{
    if (energy_.kinetic != 0.0 || duration(problem.base_motion) > 0.0) return false;
    if (!passes_over_sound(problem, dt, state)) return false;
    const double shear_speed = find_extremes(problem, state.particles).shear_speed;
    return is_loaded_fast(problem, crossing_time(problem.grid, shear_speed));
}

void Watchdog::go_back(const NumericalError& error, State& state)
{
    if (error.record.remedy == Remedy::explicit_steps) {
        kept_.explicit_end = kept_.step + explicit_steps;
        std::fill(kept_.particles.pore_pressure_rate.begin(), kept_.particles.pore_pressure_rate.end(), 0.0);
        for (FreeFieldState& field : kept_.free_fields) {
            Scalars& rate = field.column.particles.pore_pressure_rate;
            std::fill(rate.begin(), rate.end(), 0.0);
        }
        state = kept_;
        return;
    }
    if (halvings_ == most_halvings) {
        FailureRecord record = error.record;
        record.what += "; half the step, taken " + std::to_string(most_halvings) +
                       " times from the last restart point, has not helped";
        throw NumericalError(record);
    }
    ++halvings_;
    failed_time_ = std::max(failed_time_, error.record.time);
    kept_.step_halvings = std::max(kept_.step_halvings, state.step_halvings) + 1;
    kept_.times_halved = std::max(kept_.times_halved, state.times_halved) + 1;
    state = kept_;
}

} // namespace quicksand
