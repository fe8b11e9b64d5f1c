#include "solver/problem.hpp"

#include <algorithm>

namespace quicksand {

double static_water_pressure(const Problem& problem, double y)
{
    if (!problem.water) return 0.0;
    return problem.water->density * problem.gravity * std::max(0.0, problem.water->level - y);
}

} // namespace quicksand
