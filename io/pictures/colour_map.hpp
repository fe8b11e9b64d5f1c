// Colours for fields: maps whose lightness changes evenly, so that equal differences look equal, in print
// too.
#pragma once

#include <string>

namespace quicksand {

/// sRGB, each part from 0 to 1.
struct Colour {
    double red = 0.0, green = 0.0, blue = 0.0;
};

enum class ColourMap {
    sequential, // viridis, dark to light: for quantities that grow from a lower limit
    diverging,  // blue over light grey to red: for quantities with a sign, zero in the middle
};

/// Where a field has no value.
inline constexpr Colour undefined_colour{0.76, 0.76, 0.76};

/// The colour at `fraction` of the range; clamped to the ends, NaN gives `undefined_colour`.
Colour map_colour(ColourMap map, double fraction);

/// "#rrggbb".
std::string hex_code(const Colour& colour);

} // namespace quicksand
