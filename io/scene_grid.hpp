// The background grid of a scene.
#pragma once

#include "geometry/section.hpp"
#include "io/diagnostics.hpp"
#include "io/scene.hpp"
#include "solver/background_grid.hpp"

#include <optional>

namespace quicksand {

/// The grid as the scene gives it. Where it does not: from the section's lower left corner, over the whole
/// section, with room of 15 % of its height, at least two cells, above it. Nothing, and a finding, when the
/// grid would be too large.
std::optional<BackgroundGrid> choose_grid(const Scene& scene, const Section& section, Diagnostics& findings);

} // namespace quicksand
