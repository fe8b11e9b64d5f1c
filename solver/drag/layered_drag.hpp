// The drag between grains and water at nodes that soils of unlike conductivity share.
//
// Along a layer every thickness of soil leads water by itself: conductivities add. Across layers the same
// water passes all of them: resistances add. The sum C = sum phi V n^2 rho_w g_k / k over the particles adds
// resistances only, so that clay beside sand stops the water of their common node also along the sand. Here
// the support of such a node, from -h to h, is cut into strips s of an eighth of a cell. With the volumes
// W_s = sum phi V and the resistances R_s = sum phi V rho_w g_k / k of the strips along x, and the porosity
// n_i of the node, whose flux against the grains is n_i (v_w - v_s), the drag of a flow along x is
//   C_x = n_i^2 (sum W_s)^2 / sum_s (W_s^2 / R_s),
// resistances added within a strip, conductivities over the strips; C_y likewise by the strips along y. Both
// are C where all soil is alike. Where strips along another direction lead more water, as along slanted
// layers, the drag has their axes (slanted_layers.hpp).
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/nodes.hpp"
#include "solver/drag/node_strips.hpp"
#include "solver/drag/slanted_layers.hpp"
#include "solver/interpolation/node_weights.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quicksand {

/// Work space.
struct LayeredDrag {
    std::vector<std::int32_t> kind_of_material; // by conductivity, -1: without water that flows
    std::vector<std::size_t> candidates;        // nodes with unlike soils within two cells
    std::vector<std::uint8_t> is_near;          // by cell of the grid: has candidates within two cells
    std::int64_t found_for = -1;                // CellLists::changes for which both were found

    std::vector<std::uint64_t> kinds_at_node; // bits of the kinds that have weight there, of candidates
    std::vector<std::int32_t> strips_of_node; // index into `strips`, -1: one kind alone
    std::vector<NodeStrips> strips;
    std::vector<std::int32_t> parts_of_node;  // index into `parts`, -1: strips along the grid do
    std::vector<std::vector<SoilPart>> parts; // the first `parts_count` of them
    std::size_t parts_count = 0;

    bool any() const { return !kind_of_material.empty(); }
};

/// For the materials of a scene; nothing to do where their conductivities differ by less than a tenth.
LayeredDrag make_layered_drag(const Problem& problem);

/// Set the drags along their axes from the sums, with tied nodes gathered, and from the particles where
/// unlike soils share a node. The conditions are those of the step, with the seals of solids.
void set_drag(const Problem& problem, const Particles& particles, const CellLists& lists,
              const std::vector<StencilStore>& stencils, const NodeConditions& conditions,
              std::vector<TwoPhaseSums>& sums, LayeredDrag& layered);

} // namespace quicksand
