// The mean strain of cells that unlike soils share.
//
// The strains of a cell have five patterns. Where a face parts it at an angle, every particle of a stiff or
// strong soil would hold three of them, and the cell could neither shear along the face nor be pressed across
// it, however soft the other soil is. So all particles of such a cell, before its soils part as layers
// (soil_layers.hpp), take the mean strain of the cell, and act on the nodes with the mean of their stresses,
// by volume: one point of integration. A tenth of what their own differ from the mean stays, in the strain
// and in the stress: a hundredth of the stiffness against patterns that have no mean (hourglass patterns).
//
// Not where one soil keeps its water and the other has none, nor where a layer thinner than a cell is the
// stiffer or stronger one: it bends and bears by itself. Soils that are equally stiff and strong have
// their own strains, and slivers, whose stress is that of another place.
#pragma once

#include "solver/cell_strain/soil_layers.hpp"

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace quicksand {

/// Whether the particles of cells have their mean strain, by slot; empty where no soils can share cells.
using CellsWithMeans = std::vector<std::uint8_t>;

void find_cells_with_means(const Problem& problem, const CellLists& lists, const SharedSoils& shared,
                           const Particles& particles, CellsWithMeans& cells);

/// Let the values of the particles of these cells approach their mean.
void approach_means(const CellLists& lists, const SharedSoils& shared, const CellsWithMeans& cells,
                    const Particles& particles, std::initializer_list<Scalars*> values);

} // namespace quicksand
