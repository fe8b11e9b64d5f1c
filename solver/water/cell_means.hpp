// The water of a cell as a whole.
#pragma once

#include "solver/particles/particles.hpp"

namespace quicksand {

/// Means over the particles of a cell, by slot of the cell lists; zero volume where there are none.
struct CellMeans {
    Scalars volume;           // of soil [m3/m]
    Scalars pore_pressure;    // above the level with rho_w g (y - level) besides: smooth there [Pa]
    Scalars unfelt_change;    // of the pressure in a semi-implicit step, which forces have not felt yet [Pa]
    Vectors centre;           // of the soil in the cell [m]
    Scalars tension_deficit;  // of the cell's water, none without a cavitation limit [Pa]
    Scalars least_conductive; // ln k of the soils in a cell, k in any unit; none where all materials have
    Scalars most_conductive;  // the same [-]
    Scalars of_material;      // ln k of every material, likewise [-]
};

} // namespace quicksand
