// Where the soil of a section ends.
#pragma once

#include "geometry/section/section.hpp"

#include <vector>

namespace quicksand {

/// The edges of the regions with soil on their left and none on their right.
std::vector<Segment> rim_of(const Section& section);

} // namespace quicksand
