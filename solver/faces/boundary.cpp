#include "solver/faces/boundary.hpp"

namespace quicksand {

WallHold hold_of(const Boundary& boundary, const Segment& segment, Stage stage)
{
    WallHold hold;
    hold.grains = grains_held_by(boundary.soil, segment, stage);
    if (!lies_in_soil(boundary.soil) && !segment.is_dry)
        hold.water = water_held_by(boundary.water, hold.grains);
    return hold;
}

bool acts_on_soil(const Boundary& boundary)
{
    const SoilCondition& soil = boundary.soil;
    return presses(soil) || absorbs_waves(soil) || lets_go(soil) || has_outer_water(boundary.water);
}

} // namespace quicksand
