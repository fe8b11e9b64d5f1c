#include "solver/run/watchdog.hpp"

#include "solver/measure/balances.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/motion/particle_order.hpp"
#include "solver/vibration/small_motion.hpp"

#include <algorithm>
#include <string>

namespace quicksand {

namespace {

// Semi-implicit steps lose what they do not resolve of the sound of the water: less than 2e-3 of the energy
// turned over in the examples, 0.1 to 0.9 of it in random scenes with sudden loads, resonance of a body with
// its base, or cavities that close.
constexpr double energy_damped = 0.02, damped_at_once = 5e-4; // of the energy turned over
constexpr double energy_made = 0.1;                           // of the energy turned over
constexpr double growth = 4.0; // of the kinetic energy from one restart point to the next
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
    if (state.balance_terms) {
        kinetic_energy_ = kinetic_energy(problem, state.particles);
        const BalanceErrors errors = balance(problem, state);
        numerical_loss_ = errors.numerical_loss;
        energy_residual_ = errors.energy_residual;
    }
    if (state.time > failed_time_) halvings_ = 0;
}

void Watchdog::check_growth(const Problem& problem, double dt, const State& state) const
{
    if (!state.balance_terms || state.step == kept_.step) return;
    if (kinetic_energy(problem, state.particles) <= growth * kinetic_energy_) return;
    const double made = balance(problem, state).energy_error;
    if (made <= energy_made) return;
    fail("the steps have made energy, " + percentage(made) + " of what was turned over, and the motion grows",
         dt, state);
}

void Watchdog::check_sound(const Problem& problem, double dt, const State& state) const
{
    if (problem.scheme != TimeScheme::semi_implicit || water_flow(problem) != WaterFlow::coupled) return;
    if (kept_.step < state.explicit_end) return; // the steps since then were explicit
    const BalanceErrors errors = balance(problem, state);
    const double lost_at_once = energy_residual_ - errors.energy_residual;
    if (errors.energy_residual >= -energy_damped * errors.turnover ||
        lost_at_once <= damped_at_once * errors.turnover)
        return;
    fail("semi-implicit steps have damped the sound of the water by " + percentage(-errors.energy_error) +
             " of the energy that was turned over",
         dt, state, Remedy::explicit_steps);
}

void Watchdog::check(const Problem& problem, double dt, const State& state) const
{
    check_growth(problem, dt, state);
    if (!state.balance_terms || state.step == kept_.step) return;
    check_sound(problem, dt, state);
    const double loss = balance(problem, state).numerical_loss;
    double given = energy_put_in(*state.balance_terms);
    if (loss <= energy_lost * given) return;        // as a rule
    given += energy_held(problem, kept_.particles); // stresses of steps that are too long have grown since
    if (loss <= energy_lost * given || loss - numerical_loss_ <= lost_at_once * given) return;
    fail("the steps have made energy that is lost again between particles and grid, " +
             percentage((loss - numerical_loss_) / given) + " of all that was put in",
         dt, state);
}

void Watchdog::go_back(const NumericalError& error, State& state)
{
    if (error.record.remedy == Remedy::explicit_steps) {
        kept_.explicit_end = kept_.step + explicit_steps;
        std::fill(kept_.particles.pore_pressure_rate.begin(), kept_.particles.pore_pressure_rate.end(), 0.0);
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
