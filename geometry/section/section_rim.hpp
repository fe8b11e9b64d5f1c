// The edges of a section's regions, and where its soil ends.
#pragma once

#include "geometry/section/section.hpp"

#include <vector>

namespace quicksand {

/// The edges of all regions, which lie on their left, divided where a neighbour has a vertex.
std::vector<Segment> divided_edges(const Section& section);

/// Those of them with soil on their left and none on their right.
std::vector<Segment> rim_of(const Section& section);

} // namespace quicksand
