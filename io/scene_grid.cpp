#include "io/scene_grid.hpp"

#include "io/scene_units.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

constexpr double room_above = 0.15; // of the section's height [-]
constexpr double most_cells = 2e8;  // far beyond any machine that runs this program [-]
constexpr double on_line =
    1e-6; // a section that ends this close to a grid line needs no further cell [cells]

} // namespace

std::optional<BackgroundGrid> choose_grid(const Scene& scene, const Section& section, Diagnostics& findings)
{
    const double h = scene.cell_size;
    const Vector2 origin = scene.grid_origin.value_or(section.lower);
    const Vector2 extent = section.upper - origin;
    const double room =
        std::max(2.0, std::ceil(room_above * (section.upper.y() - section.lower.y()) / h - on_line));
    double cells_x = std::max(1.0, std::ceil(extent.x() / h - on_line));
    double cells_y = std::max(1.0, std::ceil(extent.y() / h - on_line)) + room;
    if (scene.grid_cells) {
        cells_x = scene.grid_cells->first;
        cells_y = scene.grid_cells->second;
    }
    if (!(cells_x * cells_y <= most_cells)) {
        findings.add(
            error_at(scene.grid_place, "range",
                     "the grid has " + number_text(cells_x) + " x " + number_text(cells_y) + " cells",
                     "at most " + number_text(most_cells) + " cells",
                     "are cell_size and the drawing both in metres?"));
        return std::nullopt;
    }
    return BackgroundGrid{origin, h, static_cast<int>(cells_x), static_cast<int>(cells_y)};
}

} // namespace quicksand
