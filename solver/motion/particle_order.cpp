#include "solver/motion/particle_order.hpp"

#include "solver/base/failure.hpp"
#include "solver/base/lanes.hpp"
#include "solver/base/threads.hpp"

#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>

namespace quicksand {

namespace {

[[noreturn]] void fail_at(const char* phase, const std::string& what, const std::string& causes, double dt,
                          const State& state, std::size_t p)
{
    FailureRecord record = failure_at(dt, state, p);
    record.phase = phase;
    record.what = what;
    record.causes = causes;
    throw NumericalError(record);
}

[[noreturn]] void fail_lost(const BackgroundGrid& grid, double dt, const State& state, std::size_t p)
{
    const Particles& particles = state.particles;
    if (!std::isfinite(particles.position.x[p]) || !std::isfinite(particles.position.y[p]))
        fail_at("sort", "a particle's position is not a number", causes_of_instability, dt, state, p);
    const std::string unstable = causes_of_instability;
    const std::string moved = "a wall is missing among the boundaries; the soil moves farther than the grid "
                              "reaches (enlarge grid.cells or shift grid.origin)";
    const bool has_jumped = dt * particles.velocity_solid[p].norm() > grid.cell_size;
    fail_at("sort", "a particle has left the grid",
            has_jumped ? unstable + "; " + moved : moved + "; " + unstable, dt, state, p);
}

[[noreturn]] void fail_bad(double dt, const State& state, std::size_t p)
{
    const Particles& particles = state.particles;
    const double volume = particles.volume[p];
    if (!std::isfinite(particles.velocity_solid[p].norm()))
        fail_at("gather", "a particle's velocity is not a number", causes_of_instability, dt, state, p);
    if (!std::isfinite(volume) || (particles.has_fluid() && !std::isfinite(particles.porosity[p])))
        fail_at("motion", "a particle's volume is not a number", causes_of_instability, dt, state, p);
    const std::string crushed =
        "the time step is too long (a smaller analysis.step_share shows it); a wall or "
        "a load crushes or tears the soil there; its material is too soft for its load";
    if (!(volume > 0.0))
        fail_at("motion", "a particle's volume is no longer positive: " + std::to_string(volume) + " m3/m",
                crushed + "; cells are too large", dt, state, p);
    fail_at("motion",
            "a particle has no pores left for its water: its porosity is " +
                std::to_string(particles.porosity[p]),
            crushed + ", or contracts without end", dt, state, p);
}

/// Particles whose velocity or volume is out of all bounds.
VECTOR_KERNEL
std::int64_t count_bad(const Particles& particles, std::size_t first, std::size_t last)
{
    const double *x = particles.velocity_solid.x.data(), *y = particles.velocity_solid.y.data();
    const double* volume = particles.volume.data();
    std::int64_t bad = 0;
    for (std::size_t p = first; p < last; ++p) {
        const bool slow = x[p] * x[p] + y[p] * y[p] < std::numeric_limits<double>::max();
        bad += !(slow & (volume[p] > 0.0));
    }
    return bad;
}

/// Particles whose grains fill more than their volume.
VECTOR_KERNEL
std::int64_t count_overfull(const Scalars& porosity, std::size_t first, std::size_t last)
{
    std::int64_t overfull = 0;
    for (std::size_t p = first; p < last; ++p) overfull += !(porosity[p] > 0.0);
    return overfull;
}

bool is_finite(const Particles& particles, std::size_t p)
{
    return std::isfinite(particles.velocity_solid[p].norm()) && std::isfinite(particles.volume[p]) &&
           (!particles.has_fluid() || std::isfinite(particles.porosity[p]));
}

bool is_bad(const Particles& particles, std::size_t p)
{
    return count_bad(particles, p, p + 1) > 0 ||
           (particles.has_fluid() && count_overfull(particles.porosity, p, p + 1) > 0);
}

} // namespace

void sort_particles(const BackgroundGrid& grid, double dt, State& state, CellLists& lists)
{
    constexpr std::int64_t steps_between = 64;
    constexpr double tolerated = 0.05;
    const std::int64_t lost = update_cell_lists(grid, state.particles, lists);
    if (lost >= 0) fail_lost(grid, dt, state, static_cast<std::size_t>(lost));
    if (state.step % steps_between == 0 && disorder(lists) > tolerated) {
        reorder(state.particles, lists.order);
        lists.cell_of_particle.clear();
        update_cell_lists(grid, state.particles, lists);
    }
}

void throw_lost_corner(double dt, const State& state, std::size_t p)
{
    fail_at(
        "motion", "a corner of a particle's quadrilateral has left the grid",
        "the soil is torn there and the corner has gone on alone: interpolation = \"cpdi\" bears more; the "
        "run has become unstable",
        dt, state, p);
}

void check_particles(double dt, const State& state)
{
    const Particles& particles = state.particles;
    std::atomic<bool> all_good = true;
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        if (count_bad(particles, first, last) > 0) all_good = false;
        if (particles.has_fluid() && count_overfull(particles.porosity, first, last) > 0) all_good = false;
    });
    if (all_good) return;
    // what is no number spoils its neighbours: it is told before what is only out of bounds
    for (const bool is_number : {false, true}) {
        for (std::size_t p = 0; p < particles.size(); ++p) {
            if (is_bad(particles, p) && is_finite(particles, p) == is_number) fail_bad(dt, state, p);
        }
    }
}

FailureRecord failure_at(double dt, const State& state, std::size_t p)
{
    FailureRecord record;
    record.stage = state.stage;
    record.step = state.step;
    record.time = state.time;
    record.time_step = dt;
    record.identifier = state.particles.identifier[p];
    record.position = state.particles.position[p];
    return record;
}

std::size_t fastest_particle(const Particles& particles)
{
    std::size_t fastest = 0;
    double most = -1.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double speed = particles.velocity_solid[p].norm();
        if (!std::isfinite(speed)) return p;
        if (speed > most) {
            fastest = p;
            most = speed;
        }
    }
    return fastest;
}

} // namespace quicksand
