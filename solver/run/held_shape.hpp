// Damped relaxation of a body on a fixed shape: stresses and velocities change, positions do not. For
// questions of small displacement, such as whether a slope of this shape is stable; a slope that deforms
// would come to rest in another shape.
//
// The velocities live on the nodes, whose weights are those of the body's interpolation, evaluated once.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/nodes.hpp"
#include "solver/cell_strain/cell_stress.hpp"
#include "solver/interpolation/node_weights.hpp"
#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/walls/wall_rows.hpp"

#include <vector>

namespace quicksand {

struct HeldShape {
    CellLists lists;
    NodeConditions conditions;
    WallRows walls;
    AggregatedLists aggregated_lists;   // where soil ends within cells
    std::vector<StencilStore> stencils; // per tile
    std::vector<SinglePhaseSums> rest;  // masses and weights of the nodes, with the loads and no stress
    std::vector<SinglePhaseSums> sums;  // with the forces and momenta of the last step
    std::vector<SinglePhaseMotion> motion;
    CellStrain strain;
    Vectors displacement; // of the nodes since the shape was taken [m]
};

/// Take the shape of a state, with the loads at its time; its particles may be put in the order of the cells.
HeldShape hold_shape(const Problem& problem, State& state);

/// One damped step: forces, velocities of the nodes, displacement, stress of the particles. The excess pore
/// pressure is held. `damping` is the local damping factor [-], `acceleration` that of the base, in x [m/s2].
/// Pre: dt <= stable_relaxation_step(...).dt.
void advance_held_shape(const Problem& problem, double dt, double damping, double acceleration,
                        Particles& particles, HeldShape& shape);

/// Velocities zero.
void set_at_rest(HeldShape& shape);

/// Displacements zero.
void reset_displacement(HeldShape& shape);

/// Sum of the unbalanced forces over the sum of the weights in the last step [-].
double out_of_balance(const Problem& problem, double acceleration, const HeldShape& shape);

/// Largest displacement of a particle [m]. Nodes with almost no soil move farther, without meaning.
double largest_displacement(const Problem& problem, const HeldShape& shape);

/// Give particles of the shape the displacement of the nodes: position and edges, for pictures.
void displace(const Problem& problem, const HeldShape& shape, Particles& particles);

} // namespace quicksand
