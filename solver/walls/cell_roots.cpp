#include "solver/walls/cell_roots.hpp"

#include "solver/interpolation/node_weights.hpp"
#include "solver/problem/problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quicksand {

namespace {

// Of a good cell: 0.25 costs a fifth of the stable step, 0.5 keeps less of a constant pressure in sharp
// corners. A little less than 0.4, so that rounding does not decide about cells that are 0.4 full by their
// drawing.
constexpr double least_fill = 0.4 - 1e-6;
// Of torn soil, in volumes as sampled: sand from its densest to its loosest takes 1.2.
constexpr double torn_volume = 1.2;
constexpr double reach_of_root =
    2.5;                        // of a badly filled cell's centre, or a node: two rings of cells [cells]
constexpr double equal = 1e-9;  // of distances
constexpr int longest_way = 12; // from a cell to a good one through thin soil: a wedge of 1:30 [cells]
// Of fills: cells that soil fills at rest differ by some per mille from step to step, and a root that changes
// with every step would jump.
constexpr double equally_full = 0.05;

/// A cell by its column and row.
struct Cell {
    int i = 0, j = 0;

    Vector2 centre() const { return {i + 0.5, j + 0.5}; } // from the rim [cells]
    std::size_t index(const BackgroundGrid& grid) const
    {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.all_cells_x()) +
               static_cast<std::size_t>(i);
    }
};

Cell cell_at(const BackgroundGrid& grid, std::size_t index)
{
    const auto columns = static_cast<std::size_t>(grid.all_cells_x());
    return {static_cast<int>(index % columns), static_cast<int>(index / columns)};
}

/// The good cells that are nearest to a point, and of these the fullest: several where they are equal, so
/// that a mirrored drawing has mirrored roots and none jumps between cells that take turns.
struct NearCells {
    std::array<Cell, 8> cells; // no more are equally far within two rings
    std::size_t count = 0;

    Cell* begin() { return cells.data(); }
    Cell* end() { return cells.data() + count; }
    const Cell* begin() const { return cells.data(); }
    const Cell* end() const { return cells.data() + count; }
};

/// Cells around a point by their distance, those of one distance row by row.
struct CellsByDistance {
    struct Step {
        int i, j;
        double distance; // its square [cells^2]
    };
    Vector2 point; // centre of a cell or a node, counted from the lower left corner of the cell (0, 0)
    std::vector<Step> steps;

    explicit CellsByDistance(const Vector2& place) : point(place)
    {
        for (int j = -3; j <= 3; ++j) {
            for (int i = -3; i <= 3; ++i) {
                const Vector2 apart = Cell{i, j}.centre() - point;
                if (apart.cwiseAbs().maxCoeff() <= reach_of_root)
                    steps.push_back({i, j, apart.squaredNorm()});
            }
        }
        std::stable_sort(steps.begin(), steps.end(),
                         [](const Step& a, const Step& b) { return a.distance < b.distance; });
    }
};

/// Of equally near cells those that are nearly as full as the fullest.
void keep_the_fullest(const BackgroundGrid& grid, const CellRoots& roots, NearCells& near)
{
    double fullest = 0.0;
    for (const Cell& cell : near) fullest = std::max(fullest, roots.fill[cell.index(grid)]);
    const auto end = std::remove_if(near.begin(), near.end(), [&](const Cell& cell) {
        return roots.fill[cell.index(grid)] < fullest - equally_full;
    });
    near.count = static_cast<std::size_t>(end - near.begin());
}

NearCells nearest_good_cells(const BackgroundGrid& grid, const CellRoots& roots, const Cell& around,
                             const CellsByDistance& ring)
{
    NearCells near;
    double least = 0.0;
    for (const CellsByDistance::Step& step : ring.steps) {
        if (near.count > 0 && step.distance > least) break;
        const Cell cell{around.i + step.i, around.j + step.j};
        if (cell.i < 0 || cell.j < 0 || cell.i >= grid.all_cells_x() || cell.j >= grid.all_cells_y())
            continue;
        if (roots.filling[cell.index(grid)] != Filling::good) continue;
        near.cells[near.count++] = cell;
        least = step.distance;
    }
    keep_the_fullest(grid, roots, near);
    return near;
}

/// Good cells at the end of the way through badly filled ones that touch each other: of those at the end of
/// the shortest way the nearest. In a wedge of 1:7 three cells at the tip are badly filled, and nodes there
/// that followed none would have almost no mass. Soil that lies apart has none.
NearCells good_cells_through_soil(const BackgroundGrid& grid, const CellRoots& roots, const Cell& around,
                                  const CellsByDistance& ring)
{
    constexpr int reach = longest_way + 3, side = 2 * reach + 1; // the way begins within two rings
    std::array<bool, side * side> seen{};
    std::vector<Cell> reached, next;
    NearCells near;
    double least = 0.0;
    const auto reach_cell = [&](const Cell& cell) {
        if (cell.i < 0 || cell.j < 0 || cell.i >= grid.all_cells_x() || cell.j >= grid.all_cells_y()) return;
        bool& known =
            seen[static_cast<std::size_t>((cell.j - around.j + reach) * side + (cell.i - around.i + reach))];
        if (known) return;
        known = true;
        const Filling filling = roots.filling[cell.index(grid)];
        if (filling == Filling::bad) next.push_back(cell);
        if (filling != Filling::good) return;
        const double distance = (cell.centre() - ring.point - Vector2(around.i, around.j)).squaredNorm();
        if (near.count > 0 && distance > least + equal) return;
        if (near.count > 0 && distance < least - equal) near.count = 0;
        least = distance;
        if (near.count < near.cells.size()) near.cells[near.count++] = cell;
    };
    double nearest = -1.0;
    for (const CellsByDistance::Step& step : ring.steps) {
        if (nearest >= 0.0 && step.distance > nearest) break;
        reach_cell({around.i + step.i, around.j + step.j});
        if (!next.empty()) nearest = step.distance;
    }
    for (int way = 0; way < longest_way && near.count == 0 && !next.empty(); ++way) {
        reached.swap(next);
        next.clear();
        for (const Cell& cell : reached)
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i) reach_cell({cell.i + i, cell.j + j});
    }
    keep_the_fullest(grid, roots, near);
    return near;
}

/// The good cells that serve a cell or a node; none are sought through soil for what is torn.
NearCells good_cells_for(const BackgroundGrid& grid, const CellRoots& roots, const Cell& around,
                         const CellsByDistance& ring, bool torn)
{
    const NearCells near = nearest_good_cells(grid, roots, around, ring);
    return near.count > 0 || torn ? near : good_cells_through_soil(grid, roots, around, ring);
}

/// The centre of the soil in a cell, from the rim [cells].
Vector2 centre_of_soil(const BackgroundGrid& grid, const CellLists& lists, const Particles& particles,
                       const Vectors& place, std::size_t slot)
{
    double volume = 0.0;
    Vector2 moment = Vector2::Zero();
    for (std::int32_t k = lists.cell_start[slot]; k < lists.cell_start[slot + 1]; ++k) {
        const auto p = static_cast<std::size_t>(lists.order[static_cast<std::size_t>(k)]);
        volume += particles.volume[p];
        moment += particles.volume[p] * place[p];
    }
    return grid.cells_from_rim(moment / volume);
}

/// The cell that is nearest to a point, of two equally near the fuller one.
Cell nearest_to(const Vector2& point, const BackgroundGrid& grid, const CellRoots& roots,
                const NearCells& near)
{
    return *std::min_element(near.begin(), near.end(), [&](const Cell& a, const Cell& b) {
        const double farther = (a.centre() - point).squaredNorm() - (b.centre() - point).squaredNorm();
        if (std::abs(farther) > equal) return farther < 0.0;
        return roots.fill[a.index(grid)] > roots.fill[b.index(grid)] + equal;
    });
}

/// Call visit(column, row) for the cells that are filled at least so well.
template <class Visit>
void for_each_cell(const BackgroundGrid& grid, const CellRoots& roots, Filling least, Visit&& visit)
{
    std::size_t cell = 0;
    for (int j = 0; j < grid.all_cells_y(); ++j)
        for (int i = 0; i < grid.all_cells_x(); ++i, ++cell)
            if (roots.filling[cell] >= least) visit(i, j);
}

/// The nodes that soil may reach and no good cell lies beside.
void find_followers(const BackgroundGrid& grid, const NodeConditions& conditions, CellRoots& roots)
{
    constexpr int reach = NodeStencil::max_width / 2 - 1; // of a particle in a cell, beyond the cell [cells]
    enum : std::uint8_t { untouched, touched, beside_good };
    std::vector<std::uint8_t> nodes(grid.node_count(), untouched);
    for_each_cell(grid, roots, Filling::torn, [&](int i, int j) {
        for (int b = std::max(0, j - reach); b <= std::min(j + 1 + reach, grid.all_cells_y()); ++b)
            for (int a = std::max(0, i - reach); a <= std::min(i + 1 + reach, grid.all_cells_x()); ++a)
                nodes[conditions.master[grid.node_index(a, b)]] = touched;
    });
    for_each_cell(grid, roots, Filling::good, [&](int i, int j) {
        const std::size_t node = grid.node_index(i, j), above = grid.node_index(i, j + 1);
        for (const std::size_t corner : {node, node + 1, above, above + 1})
            nodes[conditions.master[corner]] = beside_good;
    });
    roots.followers.clear();
    for (std::size_t k = 0; k < nodes.size(); ++k)
        if (nodes[k] == touched) roots.followers.push_back(k);
}

/// Volume of the particles in a cell [m3/m].
double volume_in(const CellLists& lists, const Particles& particles, std::size_t slot)
{
    const std::int32_t* first = lists.order.data() + lists.cell_start[slot];
    const std::int32_t count = lists.cell_start[slot + 1] - lists.cell_start[slot];
    const double* volume = particles.volume.data();
    double sum = 0.0;
    // as a rule they follow each other in memory
    if (count > 0 && first[count - 1] - first[0] == count - 1) {
        volume += first[0];
        for (std::int32_t k = 0; k < count; ++k) sum += volume[k];
    } else {
        for (std::int32_t k = 0; k < count; ++k) sum += volume[first[k]];
    }
    return sum;
}

/// Whether the soil in a cell is torn; elastic soil never is.
bool is_torn(const Problem& problem, const CellLists& lists, const Particles& particles, std::size_t slot)
{
    double present = 0.0, sampled = 0.0; // [m3/m]
    for (std::int32_t k = lists.cell_start[slot]; k < lists.cell_start[slot + 1]; ++k) {
        const auto p = static_cast<std::size_t>(lists.order[static_cast<std::size_t>(k)]);
        const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
        if (!yields(material.law)) return false;
        present += particles.volume[p];
        sampled += particles.mass_solid[p] / ((1.0 - material.porosity) * material.grain_density);
    }
    return present > torn_volume * sampled;
}

/// Volumes in the cells, and how well they are filled.
void fill_cells(const Problem& problem, const CellLists& lists, const Particles& particles,
                const std::vector<std::uint8_t>& spoilt, CellRoots& roots)
{
    const BackgroundGrid& grid = problem.grid;
    roots.fill.resize(grid.cell_count());
    roots.filling.assign(grid.cell_count(), Filling::none);
    const double whole = grid.cell_size * grid.cell_size;
    for_each_tile(lists, [&](const Tile& tile) {
        if (lists.first_entry(tile) == lists.last_entry(tile)) return;
        for (auto s = static_cast<std::size_t>(tile.first_cell); s < static_cast<std::size_t>(tile.last_cell);
             ++s) {
            const double sum = volume_in(lists, particles, s);
            if (sum == 0.0) continue;
            const auto cell = static_cast<std::size_t>(lists.cell_of_slot[s]);
            roots.fill[cell] = sum / whole;
            if (!spoilt.empty() && spoilt[s] != 0) {
                roots.filling[cell] = Filling::bad;
            } else if (sum >= least_fill * whole) {
                roots.filling[cell] = Filling::good;
            } else {
                roots.filling[cell] = is_torn(problem, lists, particles, s) ? Filling::torn : Filling::bad;
            }
        }
    });
}

/// Whether all soil in the cells beside a node is torn.
bool is_torn_beside(const BackgroundGrid& grid, const CellRoots& roots, int i, int j)
{
    bool torn = false;
    for (int b = std::max(0, j - 1); b <= std::min(j, grid.all_cells_y() - 1); ++b) {
        for (int a = std::max(0, i - 1); a <= std::min(i, grid.all_cells_x() - 1); ++a) {
            const Filling filling = roots.filling[Cell{a, b}.index(grid)];
            if (filling == Filling::bad) return false;
            torn = torn || filling == Filling::torn;
        }
    }
    return torn;
}

} // namespace

bool has_cut_soil(const Problem& problem)
{
    return problem.cut_domains.has_pieces();
}

std::vector<std::uint8_t> slots_with_solids(const Problem& problem, const CellLists& lists,
                                            const Particles& particles)
{
    std::vector<std::uint8_t> slots;
    if (!has_soil_and_solids(problem)) return slots;
    slots.assign(lists.cell_of_slot.size(), 0);
    for (std::size_t p = 0; p < particles.size(); ++p)
        if (!has_pores(problem, particles, p)) slots[static_cast<std::size_t>(lists.cell_of_particle[p])] = 1;
    return slots;
}

void find_roots(const Problem& problem, const NodeConditions& conditions, const CellLists& lists,
                const Particles& particles, const std::vector<std::uint8_t>& spoilt, CellRoots& roots)
{
    static const CellsByDistance ring({0.5, 0.5});
    const BackgroundGrid& grid = problem.grid;
    fill_cells(problem, lists, particles, spoilt, roots);
    if (roots.filling != roots.marked) {
        find_followers(grid, conditions, roots);
        roots.marked = roots.filling;
    }
    roots.aggregated.clear();
    const auto aggregate = [&](std::size_t s) {
        const auto cell = static_cast<std::size_t>(lists.cell_of_slot[s]);
        if (roots.filling[cell] == Filling::none || roots.filling[cell] == Filling::good) return;
        const NearCells near =
            good_cells_for(grid, roots, cell_at(grid, cell), ring, roots.filling[cell] == Filling::torn);
        if (near.count == 0) return;
        const Cell root = near.count == 1
                              ? *near.begin()
                              : nearest_to(centre_of_soil(grid, lists, particles,
                                                          place_in_equations(problem, particles), s),
                                           grid, roots, near);
        roots.aggregated.push_back({static_cast<std::int32_t>(s), lists.slot_of_cell[root.index(grid)]});
    };
    for (const Tile& tile : lists.tiles) {
        if (lists.first_entry(tile) == lists.last_entry(tile)) continue;
        for (std::int32_t s = tile.first_cell; s < tile.last_cell; ++s)
            aggregate(static_cast<std::size_t>(s));
    }
}

void follow(const BackgroundGrid& grid, const CellRoots& roots, std::size_t node,
            std::vector<FollowedNode>& followed)
{
    static const CellsByDistance ring({0.0, 0.0});
    const auto row = static_cast<std::size_t>(grid.nodes_x());
    const int i = static_cast<int>(node % row), j = static_cast<int>(node / row);
    const bool torn = is_torn_beside(grid, roots, i, j);
    const NearCells near = good_cells_for(grid, roots, {i, j}, ring, torn);
    const int farthest = torn ? 0 : 1; // cells to continue over
    followed.clear();
    for (const Cell& root : near) {
        // the corner of the root that is nearest, and how many cells the node is beyond it, one at most
        const int near_i = i <= root.i ? root.i : root.i + 1, near_j = j <= root.j ? root.j : root.j + 1;
        const double dx = std::min(farthest, std::abs(i - near_i)),
                     dy = std::min(farthest, std::abs(j - near_j));
        const auto add = [&](int column, int line, double weight) {
            if (weight != 0.0)
                followed.push_back({grid.node_index(column, line), weight / static_cast<double>(near.count)});
        };
        // the plane through the corner and its two neighbours: along a side the same as the bilinear function
        add(near_i, near_j, 1.0 + dx + dy);
        add(2 * root.i + 1 - near_i, near_j, -dx);
        add(near_i, 2 * root.j + 1 - near_j, -dy);
    }
}

void aggregate_cells(const CellLists& lists, const std::vector<AggregatedCell>& aggregated,
                     AggregatedLists& merged)
{
    if (merged.changes == lists.changes && merged.aggregated == aggregated) return;
    merged.changes = lists.changes;
    merged.aggregated = aggregated;
    if (merged.lists.tiles.empty()) merged.lists = lists;
    CellLists& result = merged.lists;
    std::vector<std::int32_t> slot_of(lists.cell_of_slot.size());
    for (std::size_t s = 0; s < slot_of.size(); ++s) slot_of[s] = static_cast<std::int32_t>(s);
    result.takes_others.assign(aggregated.empty() ? 0 : slot_of.size(), 0);
    for (const AggregatedCell& cell : aggregated) {
        slot_of[static_cast<std::size_t>(cell.slot)] = cell.root;
        result.takes_others[static_cast<std::size_t>(cell.root)] = 1;
    }
    result.cell_start.assign(lists.cell_start.size(), 0);
    for (std::size_t s = 0; s < slot_of.size(); ++s)
        result.cell_start[static_cast<std::size_t>(slot_of[s]) + 1] +=
            lists.cell_start[s + 1] - lists.cell_start[s];
    for (std::size_t s = 1; s < result.cell_start.size(); ++s)
        result.cell_start[s] += result.cell_start[s - 1];
    result.scratch.assign(result.cell_start.begin(), result.cell_start.end() - 1);
    result.order.resize(lists.order.size());
    for (std::size_t s = 0; s < slot_of.size(); ++s) {
        std::int32_t& next = result.scratch[static_cast<std::size_t>(slot_of[s])];
        for (std::int32_t k = lists.cell_start[s]; k < lists.cell_start[s + 1]; ++k)
            result.order[static_cast<std::size_t>(next++)] = lists.order[static_cast<std::size_t>(k)];
    }
}

} // namespace quicksand
