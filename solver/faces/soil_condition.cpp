#include "solver/faces/soil_condition.hpp"

namespace quicksand {

GrainHold grains_held_by(const SoilCondition& soil, const Segment& segment, Stage stage)
{
    return std::visit([&](const auto& any) { return hold_of(any, segment, stage); }, soil);
}

bool lies_in_soil(const SoilCondition& soil)
{
    return std::visit([](const auto& any) { return lies_in_soil(any); }, soil);
}

bool lets_go(const SoilCondition& soil)
{
    return std::visit([](const auto& any) { return lets_go(any); }, soil);
}

bool moves(const SoilCondition& soil)
{
    return std::visit([](const auto& any) { return moves(any); }, soil);
}

Vector2 displacement_of(const SoilCondition& soil, const Segment& segment, double time)
{
    return std::visit([&](const auto& any) { return displacement_of(any, segment, time); }, soil);
}

bool presses(const SoilCondition& soil)
{
    return std::visit([](const auto& any) { return presses(any); }, soil);
}

Vector2 force_on(const SoilCondition& soil, const CarriedPiece& carried, double time)
{
    return std::visit([&](const auto& any) { return force_on(any, carried, time); }, soil);
}

bool absorbs_waves(const SoilCondition& soil)
{
    return std::visit([](const auto& any) { return absorbs_waves(any); }, soil);
}

std::optional<Impedance> impedance_beyond(const SoilCondition& soil)
{
    return std::visit([](const auto& any) { return impedance_beyond(any); }, soil);
}

Vector2 velocity_of(const SoilCondition& soil, const Segment& segment, double time, double dt)
{
    return (displacement_of(soil, segment, time + dt) - displacement_of(soil, segment, time)) / dt;
}

void hold(SoilCondition& soil)
{
    if (auto* face = std::get_if<ViscousFace>(&soil)) face->held = FaceHold::always;
    if (auto* side = std::get_if<FreeFieldSide>(&soil)) side->held = FaceHold::always;
}

bool is_standing_wall(const SoilCondition& soil)
{
    return std::holds_alternative<FixedWall>(soil) || std::holds_alternative<RollerWall>(soil);
}

const SurfaceLoad* load_of(const SoilCondition& soil)
{
    const auto* face = std::get_if<FreeFace>(&soil);
    return face != nullptr && face->load ? &*face->load : nullptr;
}

} // namespace quicksand
