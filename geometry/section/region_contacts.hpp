// Where the regions of a section touch each other.
#pragma once

#include "geometry/section/section.hpp"

#include <cstddef>
#include <vector>

namespace quicksand {

/// A piece of the common edge of two regions.
struct RegionContact {
    Segment edge;
    std::size_t left = 0, right = 0; // of the edge, indices into Section::regions
};

/// All edges with a region on their left and another one on their right, each once.
std::vector<RegionContact> region_contacts(const Section& section);

} // namespace quicksand
