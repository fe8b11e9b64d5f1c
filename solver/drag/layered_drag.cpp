#include "solver/drag/layered_drag.hpp"

#include "solver/base/threads.hpp"
#include "solver/boundaries/grid_momentum.hpp"
#include "solver/drag/strip_parts.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace quicksand {

namespace {

constexpr std::int32_t no_water = -1, unlike = -2; // kinds of soil

std::int32_t both(std::int32_t a, std::int32_t b)
{
    if (a == no_water || a == b) return b;
    return b == no_water ? a : unlike;
}

/// Kinds of the soil in the cells of the grid.
std::vector<std::int32_t> kinds_of_cells(const Particles& particles, const CellLists& lists,
                                         const std::vector<std::int32_t>& kind_of_material)
{
    std::vector<std::int32_t> kinds(lists.cell_of_slot.size(), no_water);
    for_each_index(kinds.size(), [&](std::size_t slot) {
        std::int32_t kind = no_water;
        for (auto k = lists.cell_start[slot]; k < lists.cell_start[slot + 1]; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[static_cast<std::size_t>(k)]);
            kind = both(kind, kind_of_material[static_cast<std::size_t>(particles.material[p])]);
        }
        kinds[static_cast<std::size_t>(lists.cell_of_slot[slot])] = kind;
    });
    return kinds;
}

/// Call visit(cell) for the cells from whose particles a node may have weight: two on each side.
template <class Visit>
void for_each_cell_about(const BackgroundGrid& grid, std::size_t node, Visit&& visit)
{
    const int i = static_cast<int>(node) % grid.nodes_x(), j = static_cast<int>(node) / grid.nodes_x();
    for (int row = std::max(j - 2, 0); row < std::min(j + 2, grid.all_cells_y()); ++row)
        for (int column = std::max(i - 2, 0); column < std::min(i + 2, grid.all_cells_x()); ++column)
            visit(static_cast<std::size_t>(row * grid.all_cells_x() + column));
}

/// Extent of a domain from its centre along an axis, in cells [-]. The outermost tenth is left out: a domain
/// that enters a strip by less, as it does when the soil moves a little, has no part in it.
struct DomainReach {
    double x, y;
};

inline DomainReach reach_of(const Problem& problem, const Particles& particles, std::size_t p)
{
    const auto [r_1, r_2] = half_edges_in_equations(problem, particles);
    const double part = 0.9 / problem.grid.cell_size;
    return {part * (std::abs(r_1.x[p]) + std::abs(r_2.x[p])),
            part * (std::abs(r_1.y[p]) + std::abs(r_2.y[p]))};
}

/// Call visit(p, k) for the particles with water that flows in the near cells of a tile; k: the place of
/// their stencils.
template <class Visit>
inline void for_each_near(const Particles& particles, const CellLists& lists, const Tile& tile,
                          const LayeredDrag& layered, Visit&& visit)
{
    const std::size_t first = lists.first_entry(tile);
    for (auto slot = static_cast<std::size_t>(tile.first_cell);
         slot < static_cast<std::size_t>(tile.last_cell); ++slot) {
        if (!layered.is_near[static_cast<std::size_t>(lists.cell_of_slot[slot])]) continue;
        for (auto k = static_cast<std::size_t>(lists.cell_start[slot]);
             k < static_cast<std::size_t>(lists.cell_start[slot + 1]); ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            if (layered.kind_of_material[static_cast<std::size_t>(particles.material[p])] != no_water)
                visit(p, k - first);
        }
    }
}

/// Whether a stencil has nodes with a number.
inline bool touches_any(const StoredStencil& stencil, std::int32_t nodes_x, const std::int32_t* number_of)
{
    for (std::int32_t b = 0; b < stencil.height; ++b, number_of += nodes_x)
        for (std::int32_t a = 0; a < stencil.width; ++a)
            if (number_of[a] >= 0) return true;
    return false;
}

/// Find the nodes near unlike soils, and clear the kinds of their soils.
void find_candidates(const BackgroundGrid& grid, const Particles& particles, const CellLists& lists,
                     const NodeConditions& conditions, LayeredDrag& layered)
{
    if (layered.found_for != lists.changes) {
        layered.found_for = lists.changes;
        const std::vector<std::int32_t> kinds = kinds_of_cells(particles, lists, layered.kind_of_material);
        std::vector<std::uint8_t> is_candidate(grid.node_count(), 0);
        for (std::size_t n = 0; n < is_candidate.size(); ++n) {
            std::int32_t kind = no_water;
            for_each_cell_about(grid, n, [&](std::size_t cell) { kind = both(kind, kinds[cell]); });
            if (kind == unlike) is_candidate[n] = is_candidate[conditions.master[n]] = 1;
        }
        layered.candidates.clear();
        layered.is_near.assign(kinds.size(), 0);
        for (std::size_t n = 0; n < is_candidate.size(); ++n) {
            if (!is_candidate[conditions.master[n]]) continue;
            layered.candidates.push_back(n);
            for_each_cell_about(grid, n, [&](std::size_t cell) { layered.is_near[cell] = 1; });
        }
        layered.kinds_at_node.assign(grid.node_count(), 0);
        layered.strips_of_node.assign(grid.node_count(), -1);
        layered.parts_of_node.assign(grid.node_count(), -1);
    }
    for (const std::size_t n : layered.candidates) layered.kinds_at_node[n] = 0;
}

/// Note the kinds of the particles of a tile at the candidates.
void note_kinds(const Particles& particles, const CellLists& lists, const BackgroundGrid& grid,
                const Tile& tile, const StencilStore& store, LayeredDrag& layered)
{
    for_each_near(particles, lists, tile, layered, [&](std::size_t p, std::size_t place) {
        constexpr std::int32_t bits = 64;
        const std::int32_t kind = layered.kind_of_material[static_cast<std::size_t>(particles.material[p])];
        const std::uint64_t bit = std::uint64_t{1} << (kind % bits);
        for_each_node(store.stencils[place], store, grid.nodes_x(), [&](std::size_t n, const NodeWeight& w) {
            if (w.value > 0.0) layered.kinds_at_node[n] |= bit;
        });
    });
}

/// Give strips to the nodes that several kinds share.
void number_strips(const NodeConditions& conditions, LayeredDrag& layered)
{
    std::vector<std::uint64_t>& kinds = layered.kinds_at_node;
    for (const TiedNodes& tie : conditions.tied) kinds[tie.master] |= kinds[tie.node];
    std::int32_t count = 0;
    for (const std::size_t n : layered.candidates) {
        const bool is_shared = std::popcount(kinds[conditions.master[n]]) > 1 && kinds[n] != 0;
        layered.strips_of_node[n] = is_shared ? count++ : -1;
    }
    layered.strips.assign(static_cast<std::size_t>(count), NodeStrips{});
}

/// Add the particles of a tile to the strips, with the extent of their domains along x and y.
VECTOR_KERNEL
void scatter_strips(const Problem& problem, const Particles& particles, const CellLists& lists,
                    const Tile& tile, const StencilStore& store, LayeredDrag& layered)
{
    const BackgroundGrid& grid = problem.grid;
    const Vectors& place = place_in_equations(problem, particles);
    const Vector2 rim = grid.rim_origin();
    std::array<StripParts, NodeStencil::max_width> across;
    for_each_near(particles, lists, tile, layered, [&](std::size_t p, std::size_t k) {
        const StoredStencil& stencil = store.stencils[k];
        const std::int32_t* strips_of = layered.strips_of_node.data() + stencil.base(grid.nodes_x());
        if (!touches_any(stencil, grid.nodes_x(), strips_of)) return;
        const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
        const double V = particles.volume[p],
                     resistivity = flow_resistivity(material, *problem.water, particles, p);
        const DomainReach reach = reach_of(problem, particles, p);
        const double x = (place.x[p] - rim.x()) / grid.cell_size - stencil.column,
                     y = (place.y[p] - rim.y()) / grid.cell_size - stencil.row;
        for (int a = 0; a < stencil.width; ++a)
            across[static_cast<std::size_t>(a)] = parts_of(x - a - reach.x, x - a + reach.x);
        const double* phi = store.value.data() + stencil.first;
        for (int b = 0; b < stencil.height; ++b, strips_of += grid.nodes_x(), phi += stencil.width) {
            const StripParts up = parts_of(y - b - reach.y, y - b + reach.y);
            for (int a = 0; a < stencil.width; ++a) {
                if (strips_of[a] < 0) continue;
                NodeStrips& strips = layered.strips[static_cast<std::size_t>(strips_of[a])];
                const StripParts& along = across[static_cast<std::size_t>(a)];
                const double volume = phi[a] * V, resistance = volume * resistivity;
                strips.conductance += volume / resistivity;
                add_parts(volume, up, strips.row_volume);
                add_parts(resistance, up, strips.row_resistance);
                add_parts(volume, along, strips.column_volume);
                add_parts(resistance, along, strips.column_resistance);
            }
        }
    });
}

void gather_tied_strips(const NodeConditions& conditions, LayeredDrag& layered)
{
    for (const TiedNodes& tie : conditions.tied) {
        const std::int32_t from = layered.strips_of_node[tie.node], to = layered.strips_of_node[tie.master];
        if (from < 0) continue;
        const NodeStrips& node = layered.strips[static_cast<std::size_t>(from)];
        NodeStrips& master = layered.strips[static_cast<std::size_t>(to)];
        for (std::size_t s = 0; s < NodeStrips::count; ++s) {
            master.row_volume[s] += node.row_volume[s];
            master.column_volume[s] += node.column_volume[s];
            master.row_resistance[s] += node.row_resistance[s];
            master.column_resistance[s] += node.column_resistance[s];
        }
        master.conductance += node.conductance;
    }
}

/// Drags over n_i^2 by strips along the axes of the grid.
struct AlignedDrag {
    double x, y; // [N s/m2]
};

AlignedDrag aligned_drag(const NodeStrips& strips)
{
    return {resistance_of(strips.row_volume, strips.row_resistance),
            resistance_of(strips.column_volume, strips.column_resistance)};
}

/// Whether the strips along the axes lead less water in both directions together than layers would along
/// and across them.
bool lacks_flow(const NodeStrips& strips, const AlignedDrag& drag)
{
    constexpr double enough = 0.97;
    double whole = 0.0, resistance = 0.0;
    for (std::size_t s = 0; s < NodeStrips::count; ++s) {
        whole += strips.row_volume[s];
        resistance += strips.row_resistance[s];
    }
    return 1.0 / drag.x + 1.0 / drag.y < enough * (strips.conductance / (whole * whole) + 1.0 / resistance);
}

/// Set the drags along the axes, and number the nodes without conditions to which they give too little flow,
/// and those tied to one of these.
void set_aligned_drag(const Problem& problem, const NodeConditions& conditions,
                      std::vector<TwoPhaseSums>& sums, LayeredDrag& layered)
{
    layered.parts_count = 0;
    const auto number = [&](std::size_t i) {
        layered.parts_of_node[i] = static_cast<std::int32_t>(layered.parts_count++);
        if (layered.parts.size() < layered.parts_count) layered.parts.emplace_back();
        layered.parts[layered.parts_count - 1].clear();
    };
    constexpr std::int32_t none = -1, due = 0;
    for_each_index(layered.candidates.size(), [&](std::size_t c) {
        const std::size_t i = layered.candidates[c];
        layered.parts_of_node[i] = none;
        if (layered.strips_of_node[i] < 0) return;
        const NodeStrips& strips = layered.strips[static_cast<std::size_t>(layered.strips_of_node[i])];
        const AlignedDrag drag = aligned_drag(strips);
        if (!(drag.x > 0.0) || !(drag.y > 0.0)) return;
        const double n = node_porosity(problem, sums[i]);
        sums[i].drag_1 = n * n * drag.x;
        sums[i].drag_2 = n * n * drag.y;
        const bool is_free = conditions.of_node[i] == 0 && conditions.master[i] == i;
        if (is_free && lacks_flow(strips, drag)) layered.parts_of_node[i] = due;
    });
    for (const std::size_t i : layered.candidates)
        if (layered.parts_of_node[i] == due) number(i);
    for (const TiedNodes& tie : conditions.tied)
        if (layered.parts_of_node[tie.master] >= 0) number(tie.node);
}

/// Note what the particles of a tile have of the soil of the numbered nodes.
void list_parts(const Problem& problem, const Particles& particles, const CellLists& lists, const Tile& tile,
                const StencilStore& store, LayeredDrag& layered)
{
    const BackgroundGrid& grid = problem.grid;
    const Vectors& place = place_in_equations(problem, particles);
    const auto [r_1, r_2] = half_edges_in_equations(problem, particles);
    const double h = grid.cell_size;
    for_each_near(particles, lists, tile, layered, [&](std::size_t p, std::size_t k) {
        const StoredStencil& stencil = store.stencils[k];
        const std::int32_t* parts_of = layered.parts_of_node.data() + stencil.base(grid.nodes_x());
        if (!touches_any(stencil, grid.nodes_x(), parts_of)) return;
        const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
        SoilPart part;
        part.whole = particles.volume[p];
        part.resistivity = flow_resistivity(material, *problem.water, particles, p);
        part.edge_1 = r_1[p] / h;
        part.edge_2 = r_2[p] / h;
        const Vector2 from_first = (place[p] - grid.rim_origin()) / h - Vector2(stencil.column, stencil.row);
        const double* phi = store.value.data() + stencil.first;
        for (int b = 0; b < stencil.height; ++b, parts_of += grid.nodes_x(), phi += stencil.width) {
            for (int a = 0; a < stencil.width; ++a) {
                if (parts_of[a] < 0 || !(phi[a] > 0.0)) continue;
                part.volume = phi[a] * part.whole;
                part.place = from_first - Vector2(a, b);
                layered.parts[static_cast<std::size_t>(parts_of[a])].push_back(part);
            }
        }
    });
}

void gather_tied_parts(const NodeConditions& conditions, LayeredDrag& layered)
{
    for (const TiedNodes& tie : conditions.tied) {
        const std::int32_t from = layered.parts_of_node[tie.node], to = layered.parts_of_node[tie.master];
        if (from < 0 || to < 0) continue;
        const std::vector<SoilPart>& added = layered.parts[static_cast<std::size_t>(from)];
        std::vector<SoilPart>& master = layered.parts[static_cast<std::size_t>(to)];
        master.insert(master.end(), added.begin(), added.end());
    }
}

/// Turn the drag to slanted layers where these lead more water.
void set_slanted_drag(const Problem& problem, const NodeConditions& conditions,
                      std::vector<TwoPhaseSums>& sums, LayeredDrag& layered)
{
    constexpr double clearly_less = 0.98;
    for_each_index(layered.candidates.size(), [&](std::size_t c) {
        const std::size_t i = layered.candidates[c];
        const std::int32_t own = layered.parts_of_node[i];
        if (own < 0 || conditions.master[i] != i) return;
        const std::optional<SlantedDrag> slanted = slanted_drag(layered.parts[static_cast<std::size_t>(own)]);
        if (!slanted) return;
        TwoPhaseSums& node = sums[i];
        const double n = node_porosity(problem, node), along = n * n * slanted->along,
                     across = n * n * slanted->across;
        if (!(along < clearly_less * std::min(node.drag_1, node.drag_2))) return;
        node.drag_1 = along;
        node.drag_2 = across;
        node.layer_x = slanted->layer.x();
        node.layer_y = slanted->layer.y();
    });
}

} // namespace

LayeredDrag make_layered_drag(const Problem& problem)
{
    constexpr double alike = 1.1; // ratio of conductivities
    LayeredDrag layered;
    std::vector<double> conductivities; // of the kinds, over the gravity they hold for
    for (const Material& material : problem.materials) {
        layered.kind_of_material.push_back(no_water);
        if (!material.saturated || !material.has_pores) continue;
        const double k = material.hydraulic_conductivity / material.conductivity_gravity;
        const auto found = std::find_if(conductivities.begin(), conductivities.end(),
                                        [&](double other) { return k < alike * other && other < alike * k; });
        layered.kind_of_material.back() = static_cast<std::int32_t>(found - conductivities.begin());
        if (found == conductivities.end()) conductivities.push_back(k);
    }
    if (conductivities.size() < 2) layered.kind_of_material.clear();
    return layered;
}

void set_drag(const Problem& problem, const Particles& particles, const CellLists& lists,
              const std::vector<StencilStore>& stencils, const NodeConditions& conditions,
              std::vector<TwoPhaseSums>& sums, LayeredDrag& layered)
{
    for_each_index(sums.size(), [&](std::size_t i) {
        sums[i].drag_1 = sums[i].drag_2 = sums[i].drag;
        sums[i].layer_x = 1.0;
        sums[i].layer_y = 0.0;
    });
    if (!layered.any()) return;
    const auto weights_of = [&](const Tile& tile) -> const StencilStore& {
        return stencils[static_cast<std::size_t>(tile.number)];
    };
    find_candidates(problem.grid, particles, lists, conditions, layered);
    for_each_tile_by_colour(lists, [&](const Tile& tile) {
        note_kinds(particles, lists, problem.grid, tile, weights_of(tile), layered);
    });
    number_strips(conditions, layered);
    for_each_tile_by_colour(lists, [&](const Tile& tile) {
        scatter_strips(problem, particles, lists, tile, weights_of(tile), layered);
    });
    gather_tied_strips(conditions, layered);
    set_aligned_drag(problem, conditions, sums, layered);
    if (layered.parts_count == 0) return;
    for_each_tile_by_colour(lists, [&](const Tile& tile) {
        list_parts(problem, particles, lists, tile, weights_of(tile), layered);
    });
    gather_tied_parts(conditions, layered);
    set_slanted_drag(problem, conditions, sums, layered);
}

} // namespace quicksand
