// What of the particles' state decides the time step: the stiffest, the densest and the loosest cells.
//
// Particles of a cell move with the same nodes, so that one that is far stiffer than its neighbours stiffens
// their cell by its share of the volume only. Where soil fills a cell in part, a node may have most of its
// mass from one particle: there the stiffest particle counts with the share that is empty.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <vector>

namespace quicksand {

/// Of the cells of one material; without particles of it min_porosity > max_porosity.
struct MaterialExtremes {
    double min_porosity = 1.0, max_porosity = 0.0; // [-]
    double stiffest_modulus = 0.0;                 // of a P wave of the skeleton [Pa]
    double stiffest_cut_modulus = 0.0;             // the same of cells that an outline cuts [Pa]
};

struct CellExtremes {
    double max_speed = 0.0;                  // of the particles [m/s]
    std::vector<MaterialExtremes> materials; // as Problem::materials
};

/// Cells are found as particles that follow each other in memory and share a cell and a material: where they
/// are not in order, a part of a cell counts as one that is not full. Does not depend on the threads.
CellExtremes find_extremes(const Problem& problem, const Particles& particles);

} // namespace quicksand
