// The stress of a step, with what the particles of a cell have in common.
#pragma once

#include "solver/cell_strain/shared_means.hpp"
#include "solver/cell_strain/soil_layers.hpp"
#include "solver/cell_strain/volumetric_average.hpp"

namespace quicksand {

/// Data of the strains that stresses follow, which last from step to step.
struct CellStrain {
    VolumetricAverage averaged;  // empty: no material asks for it
    SharedSoils shared;          // that can share cells
    CellsWithMeans with_means;   // of the step
    Gradients own;               // of the particles while their stress is updated [1/s]
    SymmetricTensors own_stress; // while they act on nodes, in the plane [Pa]
};

CellStrain make_cell_strain(const Problem& problem, Stage stage);

/// While it lives, particles have the stress with which they act on the nodes, which works on the strains
/// that they have in common.
class StressOnNodes {
public:
    StressOnNodes(const Problem& problem, const CellLists& lists, CellStrain& strain, Particles& particles);
    ~StressOnNodes();
    StressOnNodes(const StressOnNodes&) = delete;
    StressOnNodes& operator=(const StressOnNodes&) = delete;

private:
    CellStrain& strain_;
    Particles& particles_;
};

/// update_effective_stress with the cells' rates of volume change for materials that ask for them, strains of
/// their own for soils that share a cell, and with what laws let the particles of a cell share. The velocity
/// gradients stay.
void update_stress_of_cells(const Problem& problem, double dt, const CellLists& lists, Particles& particles,
                            CellStrain& strain);

} // namespace quicksand
