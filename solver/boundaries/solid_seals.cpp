#include "solver/boundaries/solid_seals.hpp"

#include <cstddef>

namespace quicksand {

namespace {

void seal_node(std::size_t node, NodeConditions& conditions)
{
    constexpr unsigned water_held = fluid_x_fixed | fluid_y_fixed, seals = seal_x | seal_y;
    std::uint8_t& held = conditions.of_node[conditions.master[node]];
    held = static_cast<std::uint8_t>((held & ~water_held) | seals);
}

} // namespace

void seal_by_solids(const Problem& problem, const Particles& particles, const CellLists& lists,
                    const std::vector<TwoPhaseSums>& sums, const std::vector<std::uint8_t>& drawn,
                    NodeConditions& conditions)
{
    const auto row = static_cast<std::size_t>(problem.grid.all_cells_x()),
               nodes = static_cast<std::size_t>(problem.grid.nodes_x());
    conditions.of_node = drawn;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
        if (material.has_pores || !material.saturated) continue;
        const auto slot = static_cast<std::size_t>(lists.cell_of_particle[p]);
        const auto cell = static_cast<std::size_t>(lists.cell_of_slot[slot]);
        const std::size_t first = cell / row * nodes + cell % row;
        for (const std::size_t node : {first, first + 1, first + nodes, first + nodes + 1})
            seal_node(node, conditions);
    }
    for (std::size_t i = 0; i < sums.size(); ++i) // drag is that of soil alone
        if (sums[i].mass_fluid > 0.0 && sums[i].drag == 0.0) seal_node(i, conditions);
}

} // namespace quicksand
