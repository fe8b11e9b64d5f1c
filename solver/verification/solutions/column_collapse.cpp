#include "solver/verification/solutions/column_collapse.hpp"

#include <cmath>

namespace quicksand {

std::optional<double> lube_runout_ratio(double a)
{
    if (a < 1.8) return 1.2 * a;
    if (a > 2.8) return 1.9 * std::pow(a, 2.0 / 3.0);
    return std::nullopt;
}

double lube_final_height_ratio(double a)
{
    return a < 1.15 ? a : 0.65 * std::pow(a, 0.4);
}

} // namespace quicksand
