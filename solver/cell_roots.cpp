#include "solver/cell_roots.hpp"

#include "solver/pore_pressure.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

// Of a good cell: 0.25 costs a fifth of the stable step, 0.6 doubles errors at 45 degrees. A little less than
// 0.4, so that rounding does not decide about cells that are 0.4 full by their drawing.
constexpr double least_fill = 0.4 - 1e-6;
constexpr double reach_of_root =
    2.5;                       // of a badly filled cell's centre, or a node: two rings of cells [cells]
constexpr double equal = 1e-9; // of distances and fills

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

/// The good cells within `reach` of a point that are nearest to it, and of these the fullest: several where
/// they are equal, so that a mirrored drawing has mirrored roots.
std::vector<Cell> nearest_good_cells(const BackgroundGrid& grid, const CellRoots& roots, const Vector2& point,
                                     double reach)
{
    const auto low = [&](double x) { return std::max(0, static_cast<int>(std::floor(x - reach))); };
    std::vector<Cell> best;
    double least = 0.0, fullest = 0.0;
    for (int j = low(point.y()); j <= std::min(grid.all_cells_y() - 1, static_cast<int>(point.y() + reach));
         ++j) {
        for (int i = low(point.x());
             i <= std::min(grid.all_cells_x() - 1, static_cast<int>(point.x() + reach)); ++i) {
            const Cell cell{i, j};
            const Vector2 apart = cell.centre() - point;
            if (roots.good_cells[cell.index(grid)] == 0 || apart.cwiseAbs().maxCoeff() > reach + equal)
                continue;
            const double distance = apart.squaredNorm(), fill = roots.fill[cell.index(grid)];
            const bool near = best.empty() || distance < least + equal;
            const bool nearer = best.empty() || distance < least - equal;
            if (!near || (!nearer && fill < fullest - equal)) continue;
            if (nearer || fill > fullest + equal) best.clear();
            best.push_back(cell);
            least = distance;
            fullest = fill;
        }
    }
    return best;
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

void mark_nodes(const BackgroundGrid& grid, const NodeConditions& conditions, CellRoots& roots)
{
    std::fill(roots.good_nodes.begin(), roots.good_nodes.end(), std::uint8_t{0});
    for (int j = 0; j < grid.all_cells_y(); ++j) {
        for (int i = 0; i < grid.all_cells_x(); ++i) {
            const auto cell = static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.all_cells_x()) +
                              static_cast<std::size_t>(i);
            if (roots.good_cells[cell] == 0) continue;
            const std::size_t node = grid.node_index(i, j), above = grid.node_index(i, j + 1);
            for (const std::size_t corner : {node, node + 1, above, above + 1})
                roots.good_nodes[conditions.master[corner]] = 1;
        }
    }
}

} // namespace

bool has_cut_soil(const Problem& problem)
{
    return problem.cut_domains.has_pieces();
}

void find_roots(const Problem& problem, const NodeConditions& conditions, const CellLists& lists,
                const Particles& particles, CellRoots& roots)
{
    const BackgroundGrid& grid = problem.grid;
    roots.good_nodes.resize(grid.node_count());
    roots.good_cells.resize(grid.cell_count());
    roots.fill.resize(grid.cell_count());
    const double whole = grid.cell_size * grid.cell_size;
    for_each_tile(lists, [&](const Tile& tile) {
        for (std::int32_t slot = tile.first_cell; slot < tile.last_cell; ++slot) {
            const auto s = static_cast<std::size_t>(slot);
            double sum = 0.0;
            for (std::int32_t k = lists.cell_start[s]; k < lists.cell_start[s + 1]; ++k)
                sum += particles.volume[static_cast<std::size_t>(lists.order[static_cast<std::size_t>(k)])];
            const auto cell = static_cast<std::size_t>(lists.cell_of_slot[s]);
            roots.fill[cell] = sum / whole;
            roots.good_cells[cell] = sum >= least_fill * whole ? 1 : 0;
        }
    });
    mark_nodes(grid, conditions, roots);
    roots.shared.clear();
    for (std::size_t s = 0; s < lists.cell_of_slot.size(); ++s) {
        const auto cell = static_cast<std::size_t>(lists.cell_of_slot[s]);
        if (roots.fill[cell] == 0.0 || roots.good_cells[cell] != 0) continue;
        const std::vector<Cell> near =
            nearest_good_cells(grid, roots, cell_at(grid, cell).centre(), reach_of_root);
        if (near.empty()) continue;
        const Vector2 soil =
            centre_of_soil(grid, lists, particles, place_in_equations(problem, particles), s);
        const Cell root = *std::min_element(near.begin(), near.end(), [&](const Cell& a, const Cell& b) {
            return (a.centre() - soil).squaredNorm() < (b.centre() - soil).squaredNorm() - equal;
        });
        roots.shared.push_back({static_cast<std::int32_t>(s), lists.slot_of_cell[root.index(grid)]});
    }
}

std::vector<FollowedNode> follow(const BackgroundGrid& grid, const CellRoots& roots, std::size_t node)
{
    const auto row = static_cast<std::size_t>(grid.nodes_x());
    const int i = static_cast<int>(node % row), j = static_cast<int>(node / row);
    const std::vector<Cell> near = nearest_good_cells(grid, roots, Vector2(i, j), reach_of_root);
    std::vector<FollowedNode> followed;
    for (const Cell& root : near) {
        // the corner of the root that is nearest, and how many cells the node is beyond it, one at most
        const int near_i = i <= root.i ? root.i : root.i + 1, near_j = j <= root.j ? root.j : root.j + 1;
        const double dx = std::min(1, std::abs(i - near_i)), dy = std::min(1, std::abs(j - near_j));
        const auto add = [&](int column, int line, double weight) {
            if (weight != 0.0)
                followed.push_back(
                    {grid.node_index(column, line), weight / static_cast<double>(near.size())});
        };
        // the plane through the corner and its two neighbours: along a side the same as the bilinear function
        add(near_i, near_j, 1.0 + dx + dy);
        add(2 * root.i + 1 - near_i, near_j, -dx);
        add(near_i, 2 * root.j + 1 - near_j, -dy);
    }
    return followed;
}

void merge_shared_cells(const CellLists& lists, const std::vector<SharedCell>& shared, CellLists& merged)
{
    std::vector<std::int32_t> slot_of(lists.cell_of_slot.size());
    for (std::size_t s = 0; s < slot_of.size(); ++s) slot_of[s] = static_cast<std::int32_t>(s);
    for (const SharedCell& cell : shared) slot_of[static_cast<std::size_t>(cell.slot)] = cell.root;
    merged.cell_start.assign(lists.cell_start.size(), 0);
    for (std::size_t s = 0; s < slot_of.size(); ++s)
        merged.cell_start[static_cast<std::size_t>(slot_of[s]) + 1] +=
            lists.cell_start[s + 1] - lists.cell_start[s];
    for (std::size_t s = 1; s < merged.cell_start.size(); ++s)
        merged.cell_start[s] += merged.cell_start[s - 1];
    merged.scratch.assign(merged.cell_start.begin(), merged.cell_start.end() - 1);
    merged.order.resize(lists.order.size());
    for (std::size_t s = 0; s < slot_of.size(); ++s) {
        std::int32_t& next = merged.scratch[static_cast<std::size_t>(slot_of[s])];
        for (std::int32_t k = lists.cell_start[s]; k < lists.cell_start[s + 1]; ++k)
            merged.order[static_cast<std::size_t>(next++)] = lists.order[static_cast<std::size_t>(k)];
    }
}

} // namespace quicksand
