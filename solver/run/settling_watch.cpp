#include "solver/run/settling_watch.hpp"

#include "solver/base/failure.hpp"
#include "solver/measure/elastic_displacement.hpp"
#include "solver/measure/particle_quantities.hpp"
#include "solver/motion/particle_order.hpp"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>

namespace quicksand {

namespace {

/// Where a law keeps a mean stress that nothing gives the sand, as in water that rises through it; "" where
/// hardly any sand has its least.
std::string cause_of_least_stress(const Problem& problem, const Particles& particles)
{
    constexpr double at_floor = 1.01, hardly_any = 0.05;
    double volume = 0.0, all = 0.0;
    StressFloor named;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        all += particles.volume[p];
        const auto material = static_cast<std::size_t>(particles.material[p]);
        const StressFloor floor = stress_floor_of(problem.materials[material].law);
        const double mean = -0.5 * (particles.stress.xx[p] + particles.stress.yy[p]);
        if (floor.stress <= 0.0 || mean > at_floor * floor.stress) continue;
        volume += particles.volume[p];
        if (floor.stress > named.stress) named = floor;
    }
    if (!(volume > hardly_any * all)) return "";
    std::ostringstream text;
    text.precision(3);
    text << "the law gives " << 100.0 * volume / all
         << " % of the soil more stress than there is: " << named.key << " is " << named.stress << " Pa; ";
    return text.str();
}

/// The most likely first: where most of the weight is out of balance, nothing bears the soil.
std::string causes_of_running_away(const UnbalancedForces& unbalanced, const std::string& floors)
{
    const std::string slope = "the soil does not bear its weight, the loads and the pore pressures "
                              "(quicksand stability tells its factor of safety)";
    const std::string wall = "a wall is missing among the boundaries";
    const bool falls = unbalanced.of_weight > 0.5;
    const std::string soft = "the soil is far too soft for its weight";
    return falls ? wall + "; " + slope + "; " + soft : floors + slope + "; " + wall + "; " + soft;
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

/// How far more than a share of the particles have moved [m].
double displacement_of(const Particles& particles, double share)
{
    Scalars moved(particles.size());
    for (std::size_t p = 0; p < particles.size(); ++p) moved[p] = displacement(particles, p).norm();
    const auto place = static_cast<std::ptrdiff_t>((1.0 - share) * static_cast<double>(moved.size() - 1));
    std::nth_element(moved.begin(), moved.begin() + place, moved.end());
    return moved[static_cast<std::size_t>(place)];
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
                             const Particles& particles, double share)
    : problem_(&problem), controls_(controls), share_(share),
      largest_displacement_(largest_settling(problem, particles)),
      least_of_slides_(0.5 * elastic_displacement_of_layers(problem, particles))
{
}

void SettlingWatch::look(const State& state, const UnbalancedForces& unbalanced, double dt)
{
    const double moved = displacement_of(state.particles, share_);
    std::ostringstream what;
    what.precision(3);
    const auto fail_by_running_away = [&](const char* than_soil, double limit) {
        what << "the soil runs away instead of settling: it has moved " << moved << than_soil << limit
             << " m; " << describe(unbalanced);
        fail(state, farthest_particle(state.particles), what.str(),
             causes_of_running_away(unbalanced, cause_of_least_stress(*problem_, state.particles)), dt);
    };
    if (!runaway_) {
        least_of_slides_ *= std::max(1.0, unbalanced.of_weight); // loads move soil as well as its weight does
        runaway_.emplace(least_of_slides_);
    }
    runaway_->note(moved, unbalanced.of_weight);
    if (runaway_->is_certain())
        fail_by_running_away(" m and goes on, soil that stands moves less than ", least_of_slides_);
    if (moved > largest_displacement_)
        fail_by_running_away(" m, soil that comes to rest moves less than ", largest_displacement_);
    if (state.step < controls_.max_steps) return;
    what << "the soil does not settle: after " << state.step << " steps the out-of-balance force is "
         << unbalanced.of_weight << " of the weight, the tolerance " << controls_.tolerance << "; "
         << describe(unbalanced) << "; the particle below has moved farthest";
    fail(state, farthest_particle(state.particles), what.str(),
         "the soil does not bear its weight, the loads and the pore pressures; a wall is missing among the "
         "boundaries; tolerance is too "
         "small or max_steps too few (go on with --resume and a larger relaxation.tolerance or more "
         "relaxation.max_steps)",
         dt);
}

} // namespace quicksand
