// Terzaghi's layer with the inertia of grains and water: a uniform excess pressure p_0 that a load on the top
// holds in balance, at rest until the top is drained at t = 0. A series of the standing waves of the coupled
// equations (column_mode.hpp); what it differs from Terzaghi's series by is what that leaves out.
#pragma once

#include "solver/verification/solutions/saturated_soil.hpp"

#include <vector>

namespace quicksand {

/// The layer at one time. Depth ratio Z = z/H: 0 at the drained top, 1 at the fixed impervious base.
class InertialConsolidation {
public:
    /// Height H [m], time t > 0 [s].
    InertialConsolidation(const SaturatedSoil& soil, double height, double time);

    double pressure_ratio(double depth_ratio) const;    // p / p_0 [-]
    double settlement_degree(double depth_ratio) const; // over the final settlement p_0 H / M [-]

private:
    struct Term {
        double wave_number; // xi H [-]
        double stress;      // of the grains beyond the state without pressure, over p_0 [-]
        double pressure;    // over p_0 [-]
    };
    std::vector<Term> terms_;
};

} // namespace quicksand
