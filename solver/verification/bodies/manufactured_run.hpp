// Running a manufactured solution and measuring its error.
#pragma once

#include "solver/interpolation/interpolation.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/verification/solutions/manufactured_solution.hpp"

#include <cstdint>

namespace quicksand {

struct ManufacturedRun {
    ManufacturedMotion motion;
    Interpolation interpolation = Interpolation::cpdi;
    int cells = 16;        // across the body: 1 m (axis-aligned) or 3 m (vortex) [-]
    int per_cell = 2;      // particles per cell and direction [-]
    double end_time = 2.0; // one period of both motions [s]
    double courant_number =
        0.4; // dt c_p / h with the small-strain P wave; the stable step may be shorter [-]
};

struct ManufacturedError {
    double displacement_error = 0.0; // largest root mean square over time of |u - u_exact|, over A [-]
    std::int64_t scaled_domains = 0; // most domains scaled down in a step [-]
};

/// Run a dry body of the state's particles through the motion; cells and per_cell are those of the problem
/// and the state. Throws NumericalError.
ManufacturedError run_manufactured(const ManufacturedRun& run, const ManufacturedBody& body, Problem problem,
                                   State state);

/// Run the body through the motion with the single-phase step. The vortex body fills a square of 3 m between
/// fixed walls, the axis-aligned one a square of 1 m between rollers. Throws NumericalError.
ManufacturedError run_manufactured(const ManufacturedRun& run);

} // namespace quicksand
