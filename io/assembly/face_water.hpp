// Water before the soil's faces where a phreatic line is drawn: what stands beyond curves that were given no
// head, and heads that contradict the line.
#pragma once

#include "geometry/section/section.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/tables/scene.hpp"
#include "solver/problem/problem.hpp"

#include <optional>
#include <utility>

namespace quicksand {

/// Whether one of the segments goes along the middle of another.
bool any_along(const std::vector<Segment>& segments, const Segment& other);

/// Curves that lie below the phreatic line and were given no head take that of the line; heads with a history
/// begin at it. Pressures count from the lowest height of the line in the section, whatever lower level the
/// scene names: where the line is level it is still water like any other, and nothing is left to balance at
/// the faces. Wants the boundaries, the rim and the grid of the problem.
/// Nothing is done where the line is computed, see initial_flow.hpp.
void set_face_water(const Scene& scene, const Section& section, Problem& problem, Diagnostics& findings);

/// Lowest and highest head that a curve takes from the phreatic line; none where it lies above or has a head
/// of its own [m].
std::optional<std::pair<double, double>> heads_of_line(const Scene& scene, const BackgroundGrid& grid,
                                                       const Boundary& boundary);

} // namespace quicksand
