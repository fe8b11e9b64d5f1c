#include "solver/boundaries/wall_hold.hpp"

#include "solver/boundaries/wall_nodes.hpp"

#include <cmath>

namespace quicksand {

WallHold hold_of(const Boundary& boundary, const Segment& segment, Stage stage)
{
    WallHold hold;
    const bool sealed = boundary.water == WaterCondition::impervious;
    switch (boundary.soil) {
    case SoilCondition::fixed:
        hold.grains = GrainHold::all;
        break;
    case SoilCondition::roller:
        hold.grains = GrainHold::normal;
        break;
    case SoilCondition::moving:
        hold.grains = boundary.motion->grip == WallGrip::rough ? GrainHold::all : GrainHold::normal;
        break;
    case SoilCondition::viscous:
        if (stage == Stage::relaxation) {
            const Vector2 normal = outward_normal(segment);
            hold.grains = std::abs(normal.y()) >= std::abs(normal.x()) ? GrainHold::all : GrainHold::normal;
        }
        break;
    case SoilCondition::free:
    case SoilCondition::tied:
        break;
    }
    if (sealed && boundary.soil != SoilCondition::tied)
        hold.water = hold.grains == GrainHold::none ? WaterHold::with_grains : WaterHold::sealed;
    return hold;
}

bool holds_nodes(const Problem& problem, const Boundary& boundary, const Segment& segment)
{
    if (boundary.soil == SoilCondition::moving) return false;
    const int axis = normal_axis(segment);
    if (axis < 0) return false;
    const double cells = (segment.start[axis] - problem.grid.rim_origin()[axis]) / problem.grid.cell_size;
    return std::abs(cells - std::round(cells)) <= on_wall;
}

} // namespace quicksand
