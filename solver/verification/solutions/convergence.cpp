#include "solver/verification/solutions/convergence.hpp"

#include "solver/base/failure.hpp"

#include <cmath>

namespace quicksand {

double measured_order(const Convergence& convergence)
{
    const std::size_t count = convergence.cells.size();
    ENSURE(convergence.errors.size() == count);
    if (count < 2) return std::numeric_limits<double>::quiet_NaN();
    double mean_x = 0.0, mean_y = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        if (!(convergence.errors[k] > 0.0) || !std::isfinite(convergence.errors[k]))
            return std::numeric_limits<double>::quiet_NaN();
        mean_x += std::log(1.0 / convergence.cells[k]) / static_cast<double>(count);
        mean_y += std::log(convergence.errors[k]) / static_cast<double>(count);
    }
    double xx = 0.0, xy = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        const double x = std::log(1.0 / convergence.cells[k]) - mean_x;
        xx += x * x;
        xy += x * (std::log(convergence.errors[k]) - mean_y);
    }
    return xy / xx;
}

bool meets_requirements(const Convergence& convergence)
{
    ENSURE(convergence.limits.size() == convergence.errors.size());
    for (std::size_t k = 0; k < convergence.errors.size(); ++k) {
        if (!(convergence.errors[k] <= convergence.limits[k])) return false;
        if (std::isfinite(convergence.least_order) && !std::isfinite(convergence.errors[k])) return false;
    }
    const double order = measured_order(convergence);
    return std::isnan(order) || order >= convergence.least_order;
}

} // namespace quicksand
