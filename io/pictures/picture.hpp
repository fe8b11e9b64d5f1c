// One field over the deformed section as a PNG: axes in metres, a colour bar, the initial outline, the time.
#pragma once

#include "io/pictures/colour_map.hpp"
#include "io/pictures/picture_gnuplot.hpp"
#include "io/pictures/picture_outline.hpp"
#include "io/pictures/picture_ticks.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// What is drawn.
struct FieldPicture {
    std::vector<DomainCorners> domains;         // as drawn, any exaggeration included [m]
    std::vector<double> values;                 // one a domain, in `unit`; NaN where undefined
    std::vector<DomainCorners> initial_domains; // for the outline; may be empty [m]
    std::string quantity;                       // "Excess pore pressure"
    std::string unit;                           // SI; "" when dimensionless, "%" to show a ratio in per cent
    std::string title;                          // of the scene; may be empty
    std::string note;                           // e.g. "displacements × 20"; may be empty
    double time = 0.0;                          // [s]
    ColourMap colours = ColourMap::sequential;
    std::optional<PlotRange> range; // of the colours, in `unit`; none: round limits around the values
    int classes = 0;                // values are numbers of so many classes, from 0 on; 0: a quantity [-]
};

/// Where things stand on the sheet.
struct PictureLayout {
    double width = 0.0, height = 0.0; // of the sheet [pixel]
    PixelBox axes;                    // the frame of the section
    PlotRange x, y;                   // visible section, equally many pixels a metre [m]
};

/// Limits of the colours and whether values lie beyond them.
struct ColourRange {
    PlotRange limits; // in the field's unit
    bool beyond_low = false, beyond_high = false;
};

/// At most 1600 x 900 pixels, narrower or lower where the section is.
PictureLayout lay_out_picture(const FieldPicture& picture);

/// The given range, or round limits around the values: from zero for values without a sign that come near
/// it, symmetric for diverging colours. A few stray values do not stretch it.
ColourRange choose_colour_range(const FieldPicture& picture);

/// The picture for draw_pictures().
Drawing field_drawing(const FieldPicture& picture, const std::filesystem::path& file);

/// The corners moved away from where they were initially by `factor` times their displacement.
std::vector<DomainCorners> exaggerate(const std::vector<DomainCorners>& initial,
                                      const std::vector<DomainCorners>& present, double factor);

} // namespace quicksand
