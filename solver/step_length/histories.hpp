// What acts on the boundaries in time.
#pragma once

#include "solver/problem/problem.hpp"

#include <variant>

namespace quicksand {

/// Call visit(history) for the histories of all boundaries.
template <class Visit>
void for_each_history(const Problem& problem, Visit&& visit)
{
    for (const Boundary& boundary : problem.boundaries) {
        const auto* free = std::get_if<FreeFace>(&boundary.soil);
        if (free != nullptr && free->load) visit(free->load->history);
        if (const auto* wall = std::get_if<MovingWall>(&boundary.soil)) visit(wall->motion.history);
        if (const auto* water = std::get_if<PrescribedWater>(&boundary.water)) visit(water->history);
    }
}

} // namespace quicksand
