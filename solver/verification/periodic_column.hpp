// The saturated column under a periodic load of Zienkiewicz, Chang and Bettess (1980): base fixed and
// impervious, top drained and loaded by q cos(omega t).
#pragma once

#include "solver/verification/column_response.hpp"

namespace quicksand {

struct PeriodicColumn {
    SaturatedSoil soil;
    double height = 10.0;              // L [m]
    double frequency = 1.0;            // [Hz]
    double gravity = standard_gravity; // g of the first parameter [m/s2]

    double angular_frequency() const; // omega [1/s]
};

/// Complex amplitudes at a height x above the base for a load of unit amplitude; the field is
/// Re(amplitude e^{i omega t}).
ColumnAmplitude periodic_amplitude(const PeriodicColumn& column, double x,
                                   InertiaTheory theory = InertiaTheory::full);

/// The two parameters of the paper's map, with V_c^2 = (M + K_w/n)/rho and beta = rho_w/rho [-].
struct PeriodicColumnParameters {
    double pi_1; // k V_c^2 / (g beta omega L^2): drainage in one period
    double pi_2; // (omega L / V_c)^2: periods of the compression wave
};
PeriodicColumnParameters map_parameters(const PeriodicColumn& column);

/// The map's zones by the simplest theory that suffices: I consolidation, II u-p, III the full equations.
enum class InertiaZone { I, II, III };

/// The zone, computed rather than read off the map: the simplest theory whose complex pressure differs from
/// the full theory's by at most `tolerance` times the largest pressure, over the whole height.
InertiaZone inertia_zone(const PeriodicColumn& column, double tolerance = 0.03);

} // namespace quicksand
