// The saturated column under a periodic load of Zienkiewicz, Chang and Bettess (1980): base fixed and
// impervious, top drained and loaded by q cos(omega t).
#pragma once

#include "solver/verification/solutions/column_response.hpp"

namespace quicksand {

struct PeriodicColumn {
    SaturatedSoil soil;
    double height = 10.0;   // L [m]
    double frequency = 1.0; // [Hz]

    double angular_frequency() const; // omega [1/s]
};

/// Complex amplitudes at a height x above the base for a load of unit amplitude; the field is
/// Re(amplitude e^{i omega t}).
ColumnAmplitude periodic_amplitude(const PeriodicColumn& column, double x);

} // namespace quicksand
