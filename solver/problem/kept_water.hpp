// Whether the pores of soil keep their water.
#pragma once

#include "solver/base/stage.hpp"
#include "solver/problem/problem.hpp"

namespace quicksand {

/// In a stage the pressure of the water follows from the change of volume alone.
inline bool keeps_water(const Problem& problem, Stage stage)
{
    return stage == Stage::shaking ? water_flow(problem) == WaterFlow::undrained : settles_undrained(problem);
}

} // namespace quicksand
