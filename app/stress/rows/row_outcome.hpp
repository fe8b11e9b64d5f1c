// What became of a row, from its exit code and its files.
#pragma once

#include "app/stress/rows/row_files.hpp"

#include <cmath>
#include <string>

namespace quicksand {

/// How a row ended. The first three reached the end time.
enum class RowEnd { good, usable, bad, refused, stopped, crashed, overtime };

const char* name_of(RowEnd end);

struct RowOutcome {
    StressRow row;
    RowEnd end = RowEnd::crashed;
    std::string reason; // one line with the place; empty where it ended well
    // largest amounts over the run; NaN where there is no history
    double energy_error = NAN;      // as the verdict counts it [-]
    double last_energy_error = NAN; // at the end, as it stands [-]
    double loss = NAN;              // numerical loss of energy over what was put in [-]
    double water_error = NAN;       // [-]
    double momentum_error = NAN;    // over momenta and impulses [-]
    double checkerboard = NAN;      // of either pressure [-]
    double velocity = NAN;          // [m/s]
    double displacement = NAN;      // at the end [m]
    double margin = NAN;            // largest stable step over the own one; NaN: not measured [-]
    double disagreement = NAN;      // of the displacement from the twin's; NaN without one [-]
    double halvings = NAN;          // of the step by the watchdog; NaN: not told [-]
    double seconds = 0.0;           // wall time of the run [s]
    std::string bad_file;           // the first that holds what is no number; "" without any
};

/// How the process of a row ended.
struct ProcessEnd {
    int code = 0;          // exit code; of a signal, its negative number
    bool was_late = false; // ended because it took too long
    double seconds = 0.0;  // wall time
};

/// Read a row's files. Throws FileError.
RowOutcome read_outcome(const StressRow& row, const RowFiles& files, const ProcessEnd& process);

} // namespace quicksand
