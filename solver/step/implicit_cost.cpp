#include "solver/step/implicit_cost.hpp"

#include "solver/inertia/node_rows.hpp"
#include "solver/step/scheme_choice.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step/two_phase_step.hpp"
#include "solver/step_length/time_step_control.hpp"

#include <algorithm>
#include <vector>

namespace quicksand {

namespace {

template <class Sums>
StepParts count(const BackgroundGrid& grid, const State& state, const std::vector<Sums>& sums,
                const WallRows& walls)
{
    StepParts parts;
    parts.particles = static_cast<double>(state.particles.size());
    parts.rows = static_cast<double>(walls.rows.size());
    parts.rows_repeat = walls.rows.repeat();
    const auto has_soil = [&](std::size_t i) { return sums[i].active(); };
    for (std::size_t i = 0; i < sums.size(); ++i) parts.nodes += has_soil(i) ? 1.0 : 0.0;
    if (parts.nodes == 0.0) return parts;
    const Extent extent = extent_of(make_node_rows(grid), has_soil);
    parts.height = static_cast<double>(std::min(extent.x1 - extent.x0, extent.y1 - extent.y0));
    return parts;
}

} // namespace

StepParts count_parts(const Problem& problem, const State& state)
{
    const Problem form = with_scheme(problem, scheme_of_waves(problem));
    State copy = state;
    copy.balance_terms.reset();
    copy.free_fields.clear(); // their rows are not in checkpoints, and forces do not count
    copy.stage = Stage::shaking;
    const double dt = stable_time_step(form, copy).dt;
    if (water_flow(form) == WaterFlow::coupled) {
        TwoPhaseWorkspace work = make_two_phase_workspace(form);
        locate_particles(form, dt, copy, work);
        scatter_to_nodes(form, dt, copy.time, copy, work);
        assemble_walls(form, dt, work.sums, work);
        return count(form.grid, copy, work.sums, work.walls);
    }
    SinglePhaseWorkspace work = make_single_phase_workspace(form);
    locate_particles(form, dt, copy, work);
    scatter_to_nodes(form, dt, copy, work);
    assemble_walls(form, dt, work.sums, work);
    return count(form.grid, copy, work.sums, work.walls);
}

double implicit_cost(const StepParts& parts)
{
    // thousands of instructions (callgrind), fitted to ten bodies of 120 to 14,700 particles within 12 %
    const double by_waves = 1.6 * parts.particles + 4.5 * parts.nodes + 10.0 * parts.rows;
    const double more =
        (12.0 + 0.12 * parts.height) * parts.nodes + (parts.rows_repeat ? 52.0 : 5.0) * parts.rows;
    return by_waves > 0.0 ? 1.0 + more / by_waves : 1.0;
}

} // namespace quicksand
