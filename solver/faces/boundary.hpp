// A named curve of the drawing, with what it is to the grains and to the water.
#pragma once

#include "solver/faces/boundary_piece.hpp"
#include "solver/faces/segment.hpp"
#include "solver/faces/soil_condition.hpp"
#include "solver/faces/water_condition.hpp"

#include <string>
#include <vector>

namespace quicksand {

struct Boundary {
    std::string name;
    SoilCondition soil = {};
    WaterCondition water = {};
    std::vector<Segment> segments = {};
    std::vector<BoundaryPiece> pieces = {};  // none where nothing acts on the curve
    std::vector<BoundaryPiece> holders = {}; // points of domains near a curve that lets go; they carry what
                                             // its pieces cannot of the forces that held it
};

/// What a curve holds of the grains and of the water.
struct WallHold {
    GrainHold grains = GrainHold::none;
    WaterHold water = WaterHold::none;

    bool operator==(const WallHold&) const = default;
    bool any() const { return grains != GrainHold::none || water != WaterHold::none; }
};

/// What a segment of a boundary holds in a stage.
WallHold hold_of(const Boundary& boundary, const Segment& segment, Stage stage);

/// Whether something acts on the soil along the curve: loads, water beyond it, a half-space, held reactions.
/// The curve then has pieces.
bool acts_on_soil(const Boundary& boundary);

} // namespace quicksand
