#include "solver/run/strength_reduction.hpp"

#include "solver/base/failure.hpp"
#include "solver/measure/elastic_displacement.hpp"
#include "solver/problem/solid_mixture.hpp"
#include "solver/run/held_shape.hpp"
#include "solver/run/settling_problem.hpp"
#include "solver/run/simulation.hpp"
#include "solver/step_length/time_step_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

constexpr std::int64_t steps_between_judgements = 50;
constexpr double factor_growth = 1.25; // of the factor while the bracket is open

/// Time of the slowest shear wave along the width and the height of the grid [s].
double shear_crossing_time(const Problem& problem)
{
    double slowest = std::numeric_limits<double>::infinity();
    for (const Material& material : problem.materials)
        slowest =
            std::min(slowest, wave_speeds(material, water_of(problem, material), material.porosity).shear);
    return problem.grid.cell_size * (problem.grid.cells_x + problem.grid.cells_y) / slowest;
}

/// What presses on the nodes from outside.
struct OuterLoads {
    double weight = 0.0;   // of the body [N/m]
    double whole = 0.0;    // sum of the loads' sizes [N/m]
    double pressure = 0.0; // of the largest one on the width of a cell [Pa]

    /// Weight over weight and loads; 1 without weight, where forces are counted by others [-].
    double share_of_weight() const { return weight > 0.0 ? weight / (weight + whole) : 1.0; }
};

OuterLoads outer_loads(const Problem& problem, const HeldShape& shape)
{
    OuterLoads loads;
    for (const SinglePhaseSums& node : shape.rest) {
        const double load = std::hypot(node.stress_force_x, node.stress_force_y);
        loads.weight += node.weight * problem.gravity;
        loads.whole += load;
        loads.pressure = std::max(loads.pressure, load / problem.grid.cell_size);
    }
    return loads;
}

/// (gamma H + p) H / G with the pressure p of the loads: the size of elastic displacements. G is that of the
/// softest soil, or the mean of all at the present stress, 1/G by volume, if that is softer: sand that has
/// liquefied moves farther without failing [m].
double elastic_displacement_under(const OuterLoads& loads, const Problem& problem, const Particles& particles)
{
    const double G = softest_shear_modulus(problem);
    const double at_one_atmosphere =
        elastic_displacement(problem, particles) + loads.pressure * drawn_height(particles) / G;
    return at_one_atmosphere * std::max(1.0, G * mean_shear_compliance(problem, particles));
}

/// Whether the out-of-balance force falls to a half while the steps double. Soil that is soft in a pattern
/// beside stiff soil comes to rest ten times slower than shear waves cross it.
bool comes_to_rest(const std::vector<double>& out_of_balance)
{
    return !out_of_balance.empty() && out_of_balance.back() < 0.5 * out_of_balance[out_of_balance.size() / 2];
}

/// The trials of one body.
class StrengthReduction {
public:
    StrengthReduction(const Problem& problem, const StrengthReductionControls& controls, State& state)
        : problem_(problem), controls_(controls), state_(state),
          shape_(hold_shape(with_reduced_strength(problem, 1.0), state)),
          loads_(outer_loads(problem, shape_)),
          largest_displacement_(controls.largest_displacement *
                                elastic_displacement_under(loads_, problem, state.particles)),
          crossing_time_(shear_crossing_time(problem))
    {
    }

    /// Relax with the strength divided by `factor`; the state moves on when the body stands.
    StrengthTrial relax(double factor) { return relax(factor, largest_displacement_); }

    /// Let the body come to rest with the greatest strength, however far it moves: a body at the end of a
    /// shaking is out of balance. Returns whether it has moved so far that a trial before tells nothing.
    bool moves_to_rest()
    {
        constexpr double much = 0.1; // of the largest displacement
        const StrengthTrial rest =
            relax(1.0 / controls_.greatest_factor, std::numeric_limits<double>::infinity());
        return rest.stands && rest.displacement > much * largest_displacement_;
    }

    /// The particles displaced as in the last trial that failed.
    Particles failure() && { return std::move(failure_); }

private:
    /// Relax until the body stands, or has moved by more than `most` [m].
    StrengthTrial relax(double factor, double most)
    {
        Problem weaker = with_reduced_strength(problem_, factor);
        soften_solids(fastest_waves(weaker, state_.particles), weaker);
        const double dt = stable_relaxation_step(weaker, state_.particles).dt;
        const double acceleration = -controls_.seismic_coefficient * problem_.gravity;
        Particles trial_particles = state_.particles;
        HeldShape trial_shape = shape_;
        StrengthTrial trial;
        trial.factor = factor;
        const auto most_steps = static_cast<std::int64_t>(controls_.crossings * crossing_time_ / dt);
        constexpr std::int64_t patience = 4;       // times as many for a body that comes to rest
        std::vector<double> out_of_balance_so_far; // judgement by judgement
        const auto lasts = [&] {
            return trial.steps < most_steps ||
                   (trial.steps < patience * most_steps && comes_to_rest(out_of_balance_so_far));
        };
        while (!trial.stands && trial.displacement < most && lasts()) {
            for (std::int64_t step = 0; step < steps_between_judgements; ++step, ++trial.steps)
                advance_held_shape(weaker, dt, controls_.damping, acceleration, trial_particles, trial_shape);
            trial.displacement = largest_displacement(problem_, trial_shape);
            trial.out_of_balance =
                loads_.share_of_weight() * out_of_balance(problem_, acceleration, trial_shape);
            if (!std::isfinite(trial.out_of_balance)) fail(trial, dt);
            out_of_balance_so_far.push_back(trial.out_of_balance);
            trial.stands = trial.out_of_balance <= controls_.settled;
        }
        if (!trial.stands) {
            failure_ = std::move(trial_particles);
            displace(problem_, trial_shape, failure_);
            return trial;
        }
        state_.particles = std::move(trial_particles);
        shape_ = std::move(trial_shape);
        set_at_rest(shape_);
        if (!has_stood_) reset_displacement(shape_);
        has_stood_ = true;
        return trial;
    }

    [[noreturn]] void fail(const StrengthTrial& trial, double dt) const
    {
        FailureRecord record;
        record.phase = "strength reduction";
        record.what = "the stresses are not numbers";
        record.causes = "a wall is missing among the boundaries; the soil is far too weak for its weight";
        record.step = trial.steps;
        record.time_step = dt;
        throw NumericalError(record);
    }

    const Problem& problem_;
    const StrengthReductionControls& controls_;
    State& state_;
    HeldShape shape_;
    OuterLoads loads_;
    double largest_displacement_; // [m]
    double crossing_time_;        // of a shear wave along the grid's width and height [s]
    bool has_stood_ = false;
    Particles failure_;
};

} // namespace

bool has_strength(const Problem& problem, const Particles& particles)
{
    return std::any_of(particles.material.begin(), particles.material.end(), [&](auto material) {
        return has_strength(problem.materials[static_cast<std::size_t>(material)].law);
    });
}

MovingSoil moving_soil(const Particles& failure)
{
    constexpr double much = 0.25; // of the largest displacement
    const auto displacement = [&](std::size_t p) {
        return (failure.position[p] - failure.reference_position[p]).norm();
    };
    double largest = 0.0;
    for (std::size_t p = 0; p < failure.size(); ++p) largest = std::max(largest, displacement(p));
    constexpr double infinite = std::numeric_limits<double>::infinity();
    MovingSoil moving{0.0, Vector2::Constant(infinite), Vector2::Constant(-infinite)};
    for (std::size_t p = 0; p < failure.size(); ++p) {
        if (displacement(p) < much * largest) continue;
        moving.area += failure.volume[p];
        moving.low = moving.low.cwiseMin(failure.reference_position[p]);
        moving.high = moving.high.cwiseMax(failure.reference_position[p]);
    }
    return moving;
}

Problem with_reduced_strength(const Problem& problem, double factor)
{
    Problem weaker = problem_at_strength(problem);
    for (Material& material : weaker.materials) material.law = reduced(material.law, factor);
    return weaker;
}

SafetyFactor safety_factor(const Problem& problem, const StrengthReductionControls& controls, State& state,
                           const std::function<void(const StrengthTrial&)>& progress)
{
    StrengthReduction reduction(problem, controls, state);
    SafetyFactor result;
    result.fails = std::numeric_limits<double>::infinity();
    double factor = 1.0;
    for (;;) {
        const StrengthTrial trial = reduction.relax(factor);
        result.trials.push_back(trial);
        if (progress) progress(trial);
        if (!trial.stands && result.trials.size() == 1 && reduction.moves_to_rest()) continue;
        (trial.stands ? result.stands : result.fails) = factor;
        if (result.stands == 0.0) {
            factor /= factor_growth;
            if (factor * controls.greatest_factor < 1.0) break;
        } else if (std::isinf(result.fails)) {
            if (factor >= controls.greatest_factor) break;
            factor = std::min(factor_growth * factor, controls.greatest_factor);
        } else {
            factor = 0.5 * (result.stands + result.fails);
            if (result.fails - result.stands <= controls.tolerance * factor) break;
        }
    }
    const bool is_bracketed = result.stands > 0.0 && std::isfinite(result.fails);
    result.factor = is_bracketed ? 0.5 * (result.stands + result.fails) : result.stands;
    result.failure = std::move(reduction).failure();
    return result;
}

} // namespace quicksand
