#include "solver/problem/kept_water.hpp"
#include "solver/walls/wall_rows.hpp"

#include <algorithm>

namespace quicksand {

namespace {

/// Mark the nodes in contact, and the cells from which particles may reach them.
void mark_touched(const BackgroundGrid& grid, const NodeConditions& conditions, const CellLists& lists,
                  WallRows& walls)
{
    constexpr int reach = 4; // of a node in contact: of its function and of the largest domains [cells]
    std::fill(walls.touched_nodes.begin(), walls.touched_nodes.end(), std::uint8_t{0});
    std::fill(walls.touched_slots.begin(), walls.touched_slots.end(), std::uint8_t{0});
    const auto mark = [&](std::size_t node) {
        if (walls.touched_nodes[node] != 0) return;
        walls.touched_nodes[node] = 1;
        const int i = static_cast<int>(node) % grid.nodes_x(), j = static_cast<int>(node) / grid.nodes_x();
        for (int b = std::max(0, j - reach); b < std::min(j + reach, grid.all_cells_y()); ++b) {
            for (int a = std::max(0, i - reach); a < std::min(i + reach, grid.all_cells_x()); ++a) {
                const auto cell = static_cast<std::size_t>(b * grid.all_cells_x() + a);
                walls.touched_slots[static_cast<std::size_t>(lists.slot_of_cell[cell])] = 1;
            }
        }
    };
    for (const WallContact& contact : walls.contacts.walls) mark(contact.node);
    // tied nodes are touched with their masters: their normals are added to theirs
    for (const TiedNodes& tie : conditions.tied)
        if (walls.touched_nodes[tie.master] != 0) mark(tie.node);
}

void add_normal(const StencilStore& store, const StoredStencil& stencil, std::int32_t nodes_x, double volume,
                const std::vector<std::uint8_t>& touched, Vectors& normal)
{
    for_each_node(stencil, store, nodes_x, [&](std::size_t i, const NodeWeight& w) {
        if (touched[i] == 0) return;
        normal.x[i] += volume * w.gradient_x;
        normal.y[i] += volume * w.gradient_y;
    });
}

void sum_tile(const Problem& problem, const Particles& particles, const CellLists& lists, const Tile& tile,
              const StencilStore& store, WallRows& walls)
{
    const std::size_t first_entry = lists.first_entry(tile);
    const std::int32_t nodes_x = problem.grid.nodes_x();
    for (auto slot = static_cast<std::size_t>(tile.first_cell);
         slot < static_cast<std::size_t>(tile.last_cell); ++slot) {
        if (walls.touched_slots[slot] == 0) continue;
        for (auto k = static_cast<std::size_t>(lists.cell_start[slot]);
             k < static_cast<std::size_t>(lists.cell_start[slot + 1]); ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            const StoredStencil& stencil = store.stencils[k - first_entry];
            add_normal(store, stencil, nodes_x, particles.volume[p], walls.touched_nodes, walls.normal);
            if (walls.divides_water &&
                is_wet(problem.materials[static_cast<std::size_t>(particles.material[p])]))
                add_normal(store, stencil, nodes_x, particles.volume[p], walls.touched_nodes,
                           walls.wet_normal);
        }
    }
}

void sum_normals(const Problem& problem, const Particles& particles, const NodeConditions& conditions,
                 const CellLists& lists, const std::vector<StencilStore>& stencils, WallRows& walls)
{
    std::vector<Vectors*> normals = {&walls.normal};
    if (walls.divides_water) normals.push_back(&walls.wet_normal);
    for (Vectors* normal : normals) {
        normal->x.assign(problem.grid.node_count(), 0.0);
        normal->y.assign(problem.grid.node_count(), 0.0);
    }
    for_each_tile_by_colour(lists, [&](const Tile& tile) {
        sum_tile(problem, particles, lists, tile, stencils[static_cast<std::size_t>(tile.number)], walls);
    });
    for (const TiedNodes& tie : conditions.tied) {
        if (walls.touched_nodes[tie.master] == 0) continue;
        for (Vectors* normal : normals) normal->set(tie.master, (*normal)[tie.master] + (*normal)[tie.node]);
    }
}

} // namespace

void set_up_wall_rows(const Problem& problem, Stage stage, WallRows& walls)
{
    walls.edges = make_soil_edges(problem, stage);
    walls.divides_water = is_partly_wet(problem);
    const bool has_solids = stage == Stage::shaking && problem.water && has_soil_and_solids(problem);
    // slivers of soil get into the cells of a solid as soon as it moves, wherever it was drawn
    const bool has_slivers = has_solids && problem.strain == StrainForm::large;
    walls.aggregates_soil = !walls.edges.empty() || has_cut_soil(problem) || has_slivers;
    const bool shakes = stage == Stage::shaking;
    const bool flows = shakes && water_flow(problem) == WaterFlow::coupled;
    walls.keeps_water = keeps_water(problem, stage);
    const bool divides_pressures = walls.divides_water && (flows || walls.keeps_water);
    walls.aggregates_water = divides_pressures && flows && problem.scheme == TimeScheme::explicit_steps;
    walls.shares_pressures = has_solids || (divides_pressures && !walls.aggregates_water);
    walls.any = walls.aggregates_soil || walls.aggregates_water || walls.shares_pressures;
    if (!walls.any) return;
    for (const WallChain& chain : walls.edges.chains) {
        walls.chain_moves.push_back(moves(problem.boundaries[chain.edges.front().boundary].soil));
        walls.moves = walls.moves || walls.chain_moves.back();
    }
    walls.touched_nodes.resize(problem.grid.node_count());
    walls.touched_slots.resize(problem.grid.cell_count());
}

void place_wall_rows(const Problem& problem, double dt, const State& state, const NodeConditions& conditions,
                     const CellLists& lists, const std::vector<StencilStore>& stencils, WallRows& walls)
{
    if (walls.edges.empty()) return;
    if (walls.contacts_are_due || walls.moves) {
        walls.contacts =
            find_contacts(problem, walls.edges, conditions, state.stage, {state.time, dt, state.last_step});
        mark_touched(problem.grid, conditions, lists, walls);
        walls.contacts_are_due = false;
    }
    if (walls.normals_are_kept) return;
    sum_normals(problem, state.particles, conditions, lists, stencils, walls);
    walls.normals_are_kept = problem.strain == StrainForm::small;
}

} // namespace quicksand
