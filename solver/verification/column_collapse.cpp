#include "solver/verification/column_collapse.hpp"

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

double ritter_front(double depth, double time, double gravity)
{
    return 2.0 * std::sqrt(gravity * depth) * time;
}

double ritter_depth(double depth, double x, double time, double gravity)
{
    const double wave = std::sqrt(gravity * depth) * time; // the drop has run this far into the reservoir
    if (x <= -wave) return depth;
    if (x >= 2.0 * wave) return 0.0;
    const double celerity = (2.0 * wave - x) / (3.0 * time); // sqrt(g h)
    return celerity * celerity / gravity;
}

} // namespace quicksand
