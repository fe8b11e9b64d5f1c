// What of the particles' state decides the time step: the stiffest nodes, the densest and the loosest cells.
//
// Particles of a cell move with the same nodes, so that one that is far stiffer than its neighbours stiffens
// their cell by its share of the volume only. Cells that meet at a node share its mass. Of a sum of elements,
// whose masses may be parted among them at will, no frequency is above the highest of any element alone
// [Irons and Treharne 1971]: parted by their stiffness, a node counts as stiff as its cells in the mean.
// Where soil fills a cell in part, a node may have most of its mass from one particle or from one cell: there
// the stiffest counts with the share that is empty.
#pragma once

#include "solver/problem.hpp"
#include "solver/state.hpp"

#include <vector>

namespace quicksand {

/// Of the cells of one material; without particles of it min_porosity > max_porosity.
struct MaterialExtremes {
    double min_porosity = 1.0, max_porosity = 0.0; // [-]
    double stiffest_modulus = 0.0;                 // at a node, of a P wave of the skeleton [Pa]
};

struct CellExtremes {
    double max_speed = 0.0;                  // of the particles [m/s]
    std::vector<MaterialExtremes> materials; // as Problem::materials
};

/// Materials that share a cell count each for itself, as in cells that are not full. Does not depend on the
/// threads.
CellExtremes find_extremes(const Problem& problem, const Particles& particles);

} // namespace quicksand
