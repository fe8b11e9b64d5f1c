#include "solver/problem/buoyancy.hpp"

#include <cmath>

namespace quicksand {

double submerged_part(const Problem& problem, const Particles& particles, std::size_t p)
{
    constexpr double little = 1e-9; // of the height: domains that end at the level
    const auto [r_1, r_2] = half_edges_in_equations(problem, particles);
    const double half = std::abs(r_1.y[p]) + std::abs(r_2.y[p]);
    const double below = problem.water->level - place_in_equations(problem, particles).y[p];
    const double part = 0.5 + 0.5 * below / half;
    if (!(part > little)) return 0.0;
    return part < 1.0 - little && problem.water->rises_above_level ? part : 1.0;
}

} // namespace quicksand
