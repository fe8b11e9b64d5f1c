// A scene and its drawn section side by side: names, boundary curves, tied sides, the water level.
#pragma once

#include "geometry/section/section.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/tables/scene.hpp"
#include "solver/problem/problem.hpp"

#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// Check that regions, boundaries and probes of the scene and the physical groups of the section match.
void check_names(const Scene& scene, const Section& section, Diagnostics& findings);

/// The boundary conditions on every physical curve; those the scene does not name are free and drained.
std::vector<Boundary> find_boundaries(const Scene& scene, const Section& section, Diagnostics& findings);

/// A curve that is one vertical line on a grid line.
struct UprightSide {
    double x = 0.0;                  // [m]
    double lower = 0.0, upper = 0.0; // y of its ends [m]
};

/// The curve of a boundary as such a line; a finding when it is none. `kind` is its word in messages, "tied".
std::optional<UprightSide> find_upright_side(const SceneBoundary& boundary, const NamedCurve& curve,
                                             const BackgroundGrid& grid, const std::string& kind,
                                             Diagnostics& findings);

/// Free-field sides must be such lines, without water of their own, and not beside tied ones.
void check_free_field_sides(const Scene& scene, const Section& section, const BackgroundGrid& grid,
                            Diagnostics& findings);

/// The tied sides of the scene, if any; they must be vertical, on grid lines and of equal height.
std::optional<TiedSides> find_tied_sides(const Scene& scene, const Section& section,
                                         const BackgroundGrid& grid, Diagnostics& findings);

} // namespace quicksand
