#include "solver/boundaries/solid_seals.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace quicksand {

namespace {

void seal_node(std::size_t node, NodeConditions& conditions)
{
    constexpr unsigned water_held = fluid_x_fixed | fluid_y_fixed, seals = seal_x | seal_y;
    std::uint8_t& held = conditions.of_node[conditions.master[node]];
    held = static_cast<std::uint8_t>((held & ~water_held) | seals);
}

/// Call work(material, nodes) for every particle, with the corners of its cell.
template <class Work>
void for_each_corners(const Problem& problem, const Particles& particles, const CellLists& lists, Work&& work)
{
    const auto row = static_cast<std::size_t>(problem.grid.all_cells_x()),
               nodes = static_cast<std::size_t>(problem.grid.nodes_x());
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto slot = static_cast<std::size_t>(lists.cell_of_particle[p]);
        const auto cell = static_cast<std::size_t>(lists.cell_of_slot[slot]);
        const std::size_t first = cell / row * nodes + cell % row;
        work(problem.materials[static_cast<std::size_t>(particles.material[p])],
             std::array{first, first + 1, first + nodes, first + nodes + 1});
    }
}

/// The nodes to which water can rise into dry soil; empty where all soil is saturated.
std::vector<std::uint8_t> nodes_of_dry_soil(const Problem& problem, const Particles& particles,
                                            const CellLists& lists, std::size_t nodes)
{
    std::vector<std::uint8_t> open;
    const auto is_dry_soil = [](const Material& material) {
        return material.has_pores && !material.saturated;
    };
    if (std::none_of(problem.materials.begin(), problem.materials.end(), is_dry_soil)) return open;
    open.assign(nodes, 0);
    for_each_corners(problem, particles, lists, [&](const Material& material, const auto& corners) {
        if (!is_dry_soil(material)) return;
        for (const std::size_t node : corners) open[node] = 1;
    });
    return open;
}

} // namespace

void seal_by_solids(const Problem& problem, const Particles& particles, const CellLists& lists,
                    const std::vector<TwoPhaseSums>& sums, const std::vector<std::uint8_t>& drawn,
                    NodeConditions& conditions)
{
    conditions.of_node = drawn;
    const std::vector<std::uint8_t> open = nodes_of_dry_soil(problem, particles, lists, sums.size());
    for_each_corners(problem, particles, lists, [&](const Material& material, const auto& corners) {
        if (material.has_pores) return;
        for (const std::size_t node : corners)
            if (material.saturated || open.empty() || open[node] == 0) seal_node(node, conditions);
    });
    for (std::size_t i = 0; i < sums.size(); ++i) // drag is that of soil alone
        if (sums[i].mass_fluid > 0.0 && sums[i].drag == 0.0) seal_node(i, conditions);
}

} // namespace quicksand
