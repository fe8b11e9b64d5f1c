// State of the particles that limits the time step: the stiffest, the densest and the loosest cells.
//
// The particles of a cell move with the same nodes. A particle that is much stiffer than the others therefore
// counts by its fraction of the cell's volume only. In a partly filled cell one particle may give a node most
// of its mass; there the stiffest particle also counts by the empty fraction of the cell.
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
    double max_speed = 0.0;   // of the particles [m/s]
    double shear_speed = 0.0; // of shear waves in soil: root of the mean of G / density by volume; solids do
                              // not count beside soil [m/s]
    double shear_slowness = 0.0;             // mean of 1 / speed of the same, by volume [s/m]
    std::vector<MaterialExtremes> materials; // as Problem::materials
};

/// Mass of soil and of the water in it over their volume [kg/m3].
double mixture_density(const Problem& problem, const Material& material, double porosity);

/// A cell is taken as a run of successive particles in memory with the same cell and material; where
/// particles are not in order, a part of a cell counts as a cell that is not full. Does not depend on the
/// threads.
CellExtremes find_extremes(const Problem& problem, const Particles& particles);

} // namespace quicksand
