// Errors on a series of grids: the measured order and whether they stay within their limits.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace quicksand {

/// One quantity of a problem on a series of grids, coarse to fine; the lists are of equal length.
struct Convergence {
    std::string problem, quantity, norm, reference;
    std::string title;           // of the problem, as people say it
    double length = 0.0;         // the reference length [m]
    std::vector<int> cells;      // along it [-]
    std::vector<double> errors;  // infinite where the run failed [-]
    std::vector<double> limits;  // largest error accepted on each grid; infinite: none [-]
    std::vector<double> seconds; // wall time of each run [s]
    double least_order = -std::numeric_limits<double>::infinity(); // accepted [-]
};

/// Slope of log(error) over log(1/cells) by least squares; NaN for fewer than two grids, errors of zero, or
/// infinite ones.
double measured_order(const Convergence& convergence);

/// Whether every error is within its limit, and the order at least the least one where there are two grids;
/// an infinite error has no order.
bool meets_requirements(const Convergence& convergence);

} // namespace quicksand
