// Mandel's slab (Mandel 1953; series as in Cheng and Detournay 1988): |x| <= a between two rigid, smooth,
// impervious plates that a constant force presses together from T = 0; drained and stress-free at x = +-a,
// plane strain, no inertia. Time factor T = c_v t / a^2.
#pragma once

#include "solver/verification/solutions/saturated_soil.hpp"

#include <vector>

namespace quicksand {

struct MandelSlab {
    SaturatedSoil soil;
    double half_width = 1.0; // a [m]
    double force = 1.0;      // F on the half 0 <= x <= a, per metre of thickness [N/m]

    double poisson_ratio() const;           // nu of the skeleton [-]
    double undrained_poisson_ratio() const; // nu_u [-]
    double initial_pressure() const;        // p_0 = F B (1 + nu_u) / (3 a), uniform over the slab [Pa]
};

/// The slab at one time; x from its middle plane, y from its middle height [m].
class MandelState {
public:
    /// T > 0; the number of terms grows as 1/sqrt(T).
    MandelState(const MandelSlab& slab, double time_factor);

    double pore_pressure(double x) const;   // [Pa]
    double vertical_stress(double x) const; // total, tension positive [Pa]
    double displacement_x(double x) const;  // [m]
    double displacement_y(double y) const;  // [m]

private:
    struct Term {
        double root;      // alpha_i of tan(alpha) = alpha (1 - nu) / (nu_u - nu)
        double amplitude; // e^{-alpha_i^2 T} / (alpha_i - sin alpha_i cos alpha_i)
    };
    MandelSlab slab_;
    std::vector<Term> terms_;
};

} // namespace quicksand
