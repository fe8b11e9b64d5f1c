// A scene and its drawn section side by side: names, boundary curves, tied sides, the water level.
#pragma once

#include "geometry/section/section.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/tables/scene.hpp"
#include "solver/problem/problem.hpp"

#include <optional>
#include <vector>

namespace quicksand {

/// Check that regions, boundaries and probes of the scene and the physical groups of the section match.
void check_names(const Scene& scene, const Section& section, Diagnostics& findings);

/// The boundary conditions on every physical curve; those the scene does not name are free and drained.
std::vector<Boundary> find_boundaries(const Scene& scene, const Section& section, Diagnostics& findings);

/// The tied sides of the scene, if any; they must be vertical, on grid lines and of equal height.
std::optional<TiedSides> find_tied_sides(const Scene& scene, const Section& section,
                                         const BackgroundGrid& grid, Diagnostics& findings);

} // namespace quicksand
