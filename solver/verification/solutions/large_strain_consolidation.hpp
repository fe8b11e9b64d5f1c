// Consolidation at large strain of a layer drained at its top, after Xie and Leo (2004), for the rate law
// d sigma' = M D with constant M, conductivity k = k_0 J^2 and incompressible water and grains. Depth ratio
// Z = z_0/H is the material coordinate, 0 at the drained top; T = c_v t / H^2 with c_v = k_0 M / gamma_w and
// the initial height H.
#pragma once

namespace quicksand {

struct LargeStrainConsolidation {
    double constrained_modulus = 1.0; // M [Pa]
    double load = 1.0;                // q, the total stress added at T = 0 [Pa]
};

/// Excess pore pressure [Pa]: M ln[1 + (e^{q/M} - 1) theta], theta being Terzaghi's series.
double pore_pressure(const LargeStrainConsolidation& layer, double depth_ratio, double time_factor);

/// Volume ratio J of a point against the start [-].
double volume_ratio(const LargeStrainConsolidation& layer, double depth_ratio, double time_factor);

/// Settlement of the point at a depth over the initial height H [-]; positive downward.
double settlement_ratio(const LargeStrainConsolidation& layer, double depth_ratio, double time_factor);

} // namespace quicksand
