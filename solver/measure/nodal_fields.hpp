// Volume-weighted nodal averages of particle quantities, A_i = sum_p phi_ip V_p A_p / sum_p phi_ip V_p, at
// the rim of the soil brought from the mean place of those particles to the node:
// the connected picture of the state for output and for probes at fixed points.
#pragma once

#include "solver/measure/quantities.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <string_view>
#include <vector>

namespace quicksand {

/// A quantity at the nodes, component by component; one entry per node of the grid with its rim, zero where
/// the volume is zero.
struct NodalField {
    const Quantity* quantity = nullptr;
    std::vector<Scalars> components;
};

struct NodalFields {
    Scalars volume;                 // V_i, soil volume carried by the node [m3/m]
    std::vector<NodalField> fields; // of what the particles have of the quantities on nodes

    /// None where there is no such field, as of the water in a dry scene.
    const NodalField* find(std::string_view name) const;
    NodalField* find(std::string_view name);
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
