#include "solver/step/step_workspace.hpp"

#include "solver/base/failure.hpp"
#include "solver/motion/grid_to_particle.hpp"
#include "solver/motion/particle_order.hpp"
#include "solver/water/pore_pressure.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace quicksand {

namespace {

/// Exchanges the particles' shape with that of the reference during its lifetime.
class ReferenceShape {
public:
    explicit ReferenceShape(Particles& particles) : particles_(particles) { exchange(); }
    ~ReferenceShape() { exchange(); }
    ReferenceShape(const ReferenceShape&) = delete;
    ReferenceShape& operator=(const ReferenceShape&) = delete;

private:
    void exchange()
    {
        std::swap(particles_.position, particles_.reference_position);
        std::swap(particles_.half_edge_1, particles_.reference_edge_1);
        std::swap(particles_.half_edge_2, particles_.reference_edge_2);
    }

    Particles& particles_;
};

void keep_reference_weights(const Problem& problem, double dt, State& state, StepWorkspace& work)
{
    {
        const ReferenceShape reference(state.particles);
        sort_particles(problem.grid, dt, state, work.lists);
    }
    Particles undisplaced = state.particles;
    return_to_reference(undisplaced);
    for_each_weighted_tile(problem, undisplaced, work, [](const Tile&) {});
    work.stencils_are_kept = true;
}

/// Add the slots with wet and dry soil, see StepWorkspace::lists_of_kept_volume().
void add_parted_slots(const CellLists& lists, const CellLists& wet_lists, std::vector<std::uint8_t>& slots)
{
    slots.resize(lists.cell_of_slot.size());
    for (std::size_t s = 0; s < slots.size(); ++s) {
        const std::int32_t wet = wet_lists.cell_start[s + 1] - wet_lists.cell_start[s],
                           all = lists.cell_start[s + 1] - lists.cell_start[s];
        if (wet > 0 && wet < all) slots[s] = 1;
    }
}

/// Bring the lists of kept volume up to date; `spoilt` has the slots that do not strain as their water would.
void aggregate_kept_volume(const std::vector<std::uint8_t>& spoilt, StepWorkspace& work)
{
    std::vector<AggregatedCell> whole = work.walls.shared_pressures();
    std::erase_if(whole, [&](const AggregatedCell& cell) {
        return !spoilt.empty() && spoilt[static_cast<std::size_t>(cell.slot)] != 0;
    });
    if (!work.kept_lists) work.kept_lists.emplace();
    aggregate_cells(work.wet_lists, whole, *work.kept_lists);
}

/// Mark the roots of cells that hold little water and are well filled by soil; `solids` has the slots with
/// solids, which take the place of water.
void mark_water_table(const WallRows& walls, const std::vector<std::uint8_t>& solids, CellLists& lists)
{
    const std::vector<AggregatedCell>& ill = walls.roots.aggregated;
    lists.takes_table.assign(lists.takes_others.size(), 0);
    for (const AggregatedCell& cell : walls.shared_pressures()) {
        if (!solids.empty() && solids[static_cast<std::size_t>(cell.slot)] != 0) continue;
        if (!std::binary_search(ill.begin(), ill.end(), cell,
                                [](const auto& a, const auto& b) { return a.slot < b.slot; }))
            lists.takes_table[static_cast<std::size_t>(cell.root)] = 1;
    }
}

} // namespace

void set_up_workspace(const Problem& problem, StepWorkspace& work, Stage stage)
{
    work.lists = make_cell_lists(problem.grid);
    work.partly_wet = is_partly_wet(problem);
    if (work.partly_wet) work.wet_lists = work.lists;
    work.conditions = node_conditions(problem, stage);
    if (problem.water && has_soil_and_solids(problem)) work.drawn_conditions = work.conditions.of_node;
    set_up_wall_rows(problem, stage, work.walls);
    work.wall_kinds = balance_nodes(work.conditions);
    work.balance_nodes = work.wall_kinds;
    work.stencils.resize(work.lists.tiles.size());
    work.cell_strain = make_cell_strain(problem, stage);
    work.null_space_time = null_space_time(problem);
    const bool resists =
        stage == Stage::shaking ? problem.scheme == TimeScheme::implicit : has_soil_and_solids(problem);
    if (resists) work.inertia = make_inertia_solve(problem, work.conditions, stage);
}

void sum_moduli(const Problem& problem, double dt, const Particles& particles, StepWorkspace& work)
{
    sum_cell_moduli(problem, dt, particles, work.lists, work.stencils, work.inertia->resists,
                    work.inertia->rows, work.inertia->cells);
}

void update_stresses(const Problem& problem, double dt, StepWorkspace& work, State& state)
{
    Particles& particles = state.particles;
    const auto update = [&] {
        update_stress_of_cells(problem, dt, work.volume_lists(), particles, work.cell_strain);
    };
    if (!work.work_of_nodes) {
        update();
        return;
    }
    const double before = stress_power(particles);
    update();
    enter_skeleton_work(0.5 * dt * (before + stress_power(particles)), *work.work_of_nodes,
                        *state.balance_terms);
}

void fail_to_resist(double dt, const State& state)
{
    FailureRecord record = failure_at(dt, state, fastest_particle(state.particles));
    record.phase = "inertia";
    record.what = "the accelerations of the grains are not found; the particle below is the fastest";
    record.causes = causes_of_instability;
    throw NumericalError(record);
}

void place_boundaries(const Problem& problem, double dt, const State& state, StepWorkspace& work)
{
    place_wall_rows(problem, dt, state, work.conditions, work.lists, work.stencils, work.walls);
    // nodes that the dashpots and rows of the last step have left count no reaction any more
    if (work.walls.any || !work.dashpots.empty()) work.balance_nodes = work.wall_kinds;
    work.dashpots.clear();
    if (state.stage == Stage::shaking)
        gather_dashpots(problem, state.particles, work.conditions, work.places, work.dashpots);
    for (const Dashpot& dashpot : work.dashpots) count_reaction(dashpot.node, work.balance_nodes);
}

void locate_particles(const Problem& problem, double dt, State& state, StepWorkspace& work)
{
    work.grid_velocity.x.resize(state.particles.size());
    work.grid_velocity.y.resize(state.particles.size());
    if (work.stencils_are_kept) return;
    if (problem.strain == StrainForm::small) {
        keep_reference_weights(problem, dt, state, work);
    } else {
        sort_particles(problem.grid, dt, state, work.lists);
    }
    if (work.partly_wet) select_wet(problem, state.particles, work.lists, work.wet_lists);
    if (!work.walls.any) return;
    WallRows& walls = work.walls;
    if (walls.aggregates_soil) {
        find_roots(problem, work.conditions, work.lists, state.particles, {}, walls.roots);
        aggregate_cells(work.lists, walls.roots.aggregated, work.aggregated_lists);
    }
    const bool has_wet_roots = walls.aggregates_water || walls.shares_pressures;
    std::vector<std::uint8_t> solids, spoilt;
    if (has_wet_roots) {
        solids = slots_with_solids(problem, work.lists, state.particles);
        spoilt = solids;
        if (walls.keeps_water && work.partly_wet) add_parted_slots(work.lists, work.wet_lists, spoilt);
        find_roots(problem, work.conditions, work.wet_lists, state.particles, spoilt, walls.wet_roots);
    }
    if (!work.partly_wet) return;
    aggregate_cells(work.wet_lists, walls.shared_pressures(), work.aggregated_wet_lists);
    if (walls.keeps_water && state.stage == Stage::relaxation) aggregate_kept_volume(spoilt, work);
    if (has_wet_roots) mark_water_table(walls, solids, work.aggregated_wet_lists.lists);
}

} // namespace quicksand
