// Volume-weighted nodal averages of particle quantities, A_i = sum_p phi_ip V_p A_p / sum_p phi_ip V_p:
// the connected picture of the state for output and for probes at fixed points.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <vector>

namespace quicksand {

/// One entry per node of the grid with its rim; zero where `volume` is zero. Arrays of water are empty in a
/// dry scene, its velocity in all but coupled flow.
struct NodalFields {
    Scalars volume;               // V_i, soil volume carried by the node [m3/m]
    Vectors displacement;         // since the reference [m]
    Vectors velocity_solid;       // [m/s]
    Vectors velocity_fluid;       // [m/s]
    Scalars pore_pressure;        // total: static plus excess [Pa]
    Scalars excess_pore_pressure; // [Pa]
    Scalars ru; // excess pore pressure / initial vertical effective stress, at least ru_stress_threshold [-]
    Scalars mean_effective_stress;     // compression positive, (xx + yy + zz)/3 [Pa]
    Scalars vertical_effective_stress; // compression positive [Pa]
    Scalars shear_stress_xy;           // [Pa]
    Scalars porosity;                  // [-]
};

NodalFields nodal_fields(const Problem& problem, const Particles& particles);

/// The same, to the same bits, at the nodes of the cells that hold the points; zero at all others, whose
/// particles are passed over.
NodalFields nodal_fields_at(const Problem& problem, const Particles& particles,
                            const std::vector<Vector2>& points);

/// Bilinear weights of the four nodes around a point: the value of a nodal field there is
/// sum weight[k] field[node[k]]. `inside` is false where the cell does not touch soil at all four nodes.
struct PointWeights {
    std::size_t node[4] = {0, 0, 0, 0};
    double weight[4] = {0.0, 0.0, 0.0, 0.0};
    bool inside = false;
};

PointWeights point_weights(const BackgroundGrid& grid, const NodalFields& fields, const Vector2& point);

} // namespace quicksand
