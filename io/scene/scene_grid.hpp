// The background grid of a scene.
#pragma once

#include "geometry/section/section.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/tables/scene.hpp"
#include "solver/particles/background_grid.hpp"

#include <optional>
#include <string>
#include <vector>

namespace quicksand {

struct GridChoice {
    BackgroundGrid grid;
    std::vector<std::string> reasons; // what was chosen and why, lines for the user; none: all was given
};

/// The grid as the scene gives it. Where it does not: cells of choose_cell_size; lines through the first
/// vertical and the first horizontal wall, counted from the left and from below, or the section's edges; over
/// the whole section, with room above it and beyond sides that no wall closes. Nothing, and a finding, when
/// the grid would be too large.
std::optional<GridChoice> choose_grid(const Scene& scene, const Section& section, Diagnostics& findings);

} // namespace quicksand
