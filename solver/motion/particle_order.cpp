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
    FailureRecord record;
    record.phase = phase;
    record.what = what;
    record.causes = causes;
    record.step = state.step;
    record.time = state.time;
    record.time_step = dt;
    record.identifier = state.particles.identifier[p];
    record.position = state.particles.position[p];
    throw NumericalError(record);
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

} // namespace

void sort_particles(const BackgroundGrid& grid, double dt, State& state, CellLists& lists)
{
    constexpr std::int64_t steps_between = 64;
    constexpr double tolerated = 0.05;
    std::int64_t lost = update_cell_lists(grid, state.particles, lists);
    if (lost >= 0) {
        const auto p = static_cast<std::size_t>(lost);
        const bool number =
            std::isfinite(state.particles.position.x[p]) && std::isfinite(state.particles.position.y[p]);
        fail_at("sort", number ? "a particle has left the grid" : "a particle's position is not a number",
                number
                    ? "the soil moves farther than the grid reaches (enlarge grid.cells or shift "
                      "grid.origin); a wall "
                      "is missing among the boundaries; the run has become unstable"
                    : "the run has become unstable: look at the last good frame for the place where it began",
                dt, state, p);
    }
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
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!(particles.volume[p] > 0.0)) {
            fail_at("motion",
                    "a particle's volume is no longer positive: " + std::to_string(particles.volume[p]) +
                        " m3/m",
                    "the soil is torn or crushed there; its material is too soft for its load; cells are too "
                    "large",
                    dt, state, p);
        }
        if (particles.has_fluid() && !(particles.porosity[p] > 0.0)) {
            fail_at("motion",
                    "a particle has no pores left for its water: its porosity is " +
                        std::to_string(particles.porosity[p]),
                    "the soil is crushed there; its material is too soft for its load, or contracts without "
                    "end",
                    dt, state, p);
        }
        const double speed = particles.velocity_solid[p].norm();
        if (!std::isfinite(speed)) {
            fail_at("gather", "a particle's velocity is not a number",
                    "the run has become unstable: look at the last good frame for the place where it began; "
                    "a material "
                    "parameter or a load is far from what the soil can carry",
                    dt, state, p);
        }
    }
}

} // namespace quicksand
