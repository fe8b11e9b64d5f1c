// A field of the particles made ready to be drawn: values, label, unit and colours.
#pragma once

#include "io/pictures/colour_map.hpp"
#include "io/results/result_reader.hpp"

#include <optional>
#include <string>
#include <vector>

namespace quicksand {

struct DrawnField {
    std::string label; // "Excess pore pressure"
    std::string unit;  // as FieldPicture has it
    ColourMap colours = ColourMap::sequential;
    std::vector<double> values; // one a particle
};

/// None where the frame has no such field. "displacement" is the magnitude of the vector, "velocity" stands
/// for the grains' velocity. Colours diverge where a field with a sign takes both.
std::optional<DrawnField> drawn_field(const ParticleFrame& frame, const std::string& name);

} // namespace quicksand
