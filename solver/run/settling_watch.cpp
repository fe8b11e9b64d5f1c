#include "solver/run/settling_watch.hpp"

#include "solver/base/failure.hpp"
#include "solver/measure/elastic_displacement.hpp"
#include "solver/measure/particle_quantities.hpp"
#include "solver/motion/particle_order.hpp"

#include <algorithm>
#include <sstream>
#include <string>

namespace quicksand {

namespace {

/// The most likely first: where most of the weight is out of balance, nothing bears the soil.
std::string causes_of_running_away(const UnbalancedForces& unbalanced)
{
    const std::string slope =
        "the slope cannot stand under its weight (quicksand stability tells its factor of safety)";
    const std::string wall = "a wall is missing among the boundaries";
    const bool falls = unbalanced.of_weight > 0.5;
    return (falls ? wall + "; " + slope : slope + "; " + wall) + "; the soil is far too soft for its weight";
}

std::size_t farthest_particle(const Particles& particles)
{
    std::size_t farthest = 0;
    double most = -1.0; // [m2]
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double square = displacement(particles, p).squaredNorm();
        if (square > most) {
            farthest = p;
            most = square;
        }
    }
    return farthest;
}

/// Displacement that no soil reaches which comes to rest as drawn: a cell, a quarter of its height and twice
/// its elastic displacement, whichever is largest [m].
double largest_settling(const Problem& problem, const Particles& particles)
{
    return std::max({problem.grid.cell_size, 0.25 * drawn_height(particles),
                     2.0 * elastic_displacement(problem, particles)});
}

std::string describe(const UnbalancedForces& unbalanced)
{
    std::ostringstream text;
    text.precision(3);
    text << "the unbalanced force is " << unbalanced.of_weight << " of the weight and largest at ("
         << unbalanced.place.x() << ", " << unbalanced.place.y() << ") m";
    return text.str();
}

[[noreturn]] void fail(const State& state, std::size_t p, const std::string& what, const std::string& causes,
                       double dt)
{
    FailureRecord record = failure_at(dt, state, p);
    record.phase = "relaxation";
    record.what = what;
    record.causes = causes;
    throw NumericalError(record);
}

} // namespace

SettlingWatch::SettlingWatch(const Problem& problem, const RelaxationControls& controls,
                             const Particles& particles)
    : controls_(controls), largest_displacement_(largest_settling(problem, particles)),
      least_of_slides_(0.5 * elastic_displacement(problem, particles)), runaway_(least_of_slides_)
{
}

void SettlingWatch::look(const State& state, const UnbalancedForces& unbalanced, double dt)
{
    const std::size_t farthest = farthest_particle(state.particles);
    const double moved = displacement(state.particles, farthest).norm();
    std::ostringstream what;
    what.precision(3);
    const auto fail_by_running_away = [&](const char* than_soil, double limit) {
        what << "the soil runs away instead of settling: it has moved " << moved << than_soil << limit
             << " m; " << describe(unbalanced);
        fail(state, farthest, what.str(), causes_of_running_away(unbalanced), dt);
    };
    runaway_.note(moved, unbalanced.of_weight);
    if (runaway_.is_certain())
        fail_by_running_away(" m and goes on, soil that stands moves less than ", least_of_slides_);
    if (moved > largest_displacement_)
        fail_by_running_away(" m, soil that comes to rest moves less than ", largest_displacement_);
    if (state.step < controls_.max_steps) return;
    what << "the soil does not settle: after " << state.step << " steps the out-of-balance force is "
         << unbalanced.of_weight << " of the weight, the tolerance " << controls_.tolerance << "; "
         << describe(unbalanced) << "; the particle below has moved farthest";
    fail(state, farthest, what.str(),
         "the slope cannot stand under its weight; a wall is missing among the boundaries; tolerance is too "
         "small or max_steps too few (go on with --resume and a larger relaxation.tolerance or more "
         "relaxation.max_steps)",
         dt);
}

} // namespace quicksand
