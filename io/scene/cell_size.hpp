// The size of the cells where the scene gives none: from the soil's layers, the waves and the walls.
#pragma once

#include "geometry/section/section.hpp"
#include "io/tables/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace quicksand {

inline constexpr double cells_through_layer = 4.0; // that are chosen

/// A place this close to a grid line lies on it [cells].
inline constexpr double on_grid_line = 1e-6;

/// The curve of a name with what the scene says of the soil at it; unnamed edges and curves are free.
const SoilCondition& soil_at(const Scene& scene, const NamedCurve& curve);

/// Coordinates of straight walls and flat edges along the grid, and where grid lines are counted from.
struct LineUp {
    struct Place {
        double coordinate = 0.0; // [m]
        double weight = 0.0;     // how much it matters that it lies on a line [-]
    };
    std::vector<Place> places;
    double anchor = 0.0; // a grid line: the first wall, or else the section's edge [m]
};

/// The vertical (axis 0, counted from the left) or horizontal (axis 1, from below) lines of a section.
LineUp lines_across(int axis, const Scene& scene, const Section& section);

struct CellSize {
    double size = 0.0;                // h [m]
    std::vector<std::string> reasons; // lines for the user
    bool is_bounded = false;          // by the number of particles
};

/// Four cells through the thinnest layer, 16 through the body, ten along the shortest shear wave, whichever
/// is least; not so small that there are more than 100 000 particles; then up to 15 % larger or 20 % smaller
/// for walls, and then flat edges, to lie on grid lines.
CellSize choose_cell_size(const Scene& scene, const Section& section);

} // namespace quicksand
