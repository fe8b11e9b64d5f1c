// What a boundary curve is to the pore water, and which water stands beyond it.
#pragma once

#include "solver/base/conventions.hpp"
#include "solver/base/history.hpp"
#include "solver/faces/face_interface.hpp"

#include <optional>
#include <variant>
#include <vector>

namespace quicksand {

/// What a curve holds of the water, normal to itself.
enum class WaterHold {
    none,
    sealed,      // the water has the wall's velocity
    with_grains, // a seal, impervious but free to move: the water has the grains' velocity
};

/// Still water up to a line, level beyond its ends; at every x as deep as the line is high there.
struct WaterLine {
    std::vector<Vector2> points; // from left to right, at least one [m]
};

/// y at x of a line from left to right, level beyond its ends [m].
double elevation(const std::vector<Vector2>& line, double x);

/// Water passes: no excess pressure but that of the water beyond.
struct Drained {
    std::optional<WaterLine> beyond = {}; // none: the still water at the level
};

/// Water moves with the grains normal to the curve; on a free face it presses from beyond.
struct Impervious {
    std::optional<WaterLine> beyond = {}; // none: the still water at the level
};

/// Still water beyond a curve, standing up to a height.
struct WaterHead {
    double head = 0.0; // y of its surface [m]

    bool operator==(const WaterHead&) const = default;
};

/// Pore pressure along a curve.
struct PorePressure {
    double pressure = 0.0; // with its static part, compression positive [Pa]

    bool operator==(const PorePressure&) const = default;
};

/// Water passes, and has a given head or pressure at the curve; the history is a factor on the height of the
/// head above the surface of the water at rest, or on the pressure beyond that of this water.
struct PrescribedWater {
    std::variant<WaterHead, PorePressure> value;
    History history = {};
    std::optional<WaterLine> at_rest = {}; // none: the still water at the level
};

using WaterCondition = std::variant<Drained, Impervious, PrescribedWater>;

/// What the curve holds of the water where it holds this of the grains.
WaterHold water_held_by(const WaterCondition& water, GrainHold grains);

/// Whether the water beyond is other than the still water at the level.
bool has_outer_water(const WaterCondition& water);

/// The history of the water beyond at a time: a factor [-].
double outer_factor(const WaterCondition& water, double time);

/// Keep the water beyond as it is at a time.
void hold_water(WaterCondition& water, double time);

/// The still water that excess pressures count from.
struct StillWater {
    double unit_weight = 0.0; // rho_w g [N/m3]
    double level = 0.0;       // y of its surface [m]
};

/// Static pressure of water that stands up to a height, at height y, zero above [Pa].
double pressure_below(const StillWater& still, double surface, double y);

/// Excess over the still water that the water beyond a curve has at a point, its history having the value
/// `factor`; zero where it is the still water [Pa].
double outer_excess(const WaterCondition& water, const StillWater& still, const Vector2& point,
                    double factor);

} // namespace quicksand
