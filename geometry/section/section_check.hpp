// CGAL's checks of a drawn section before anything is sampled.
#pragma once

#include "geometry/section/section.hpp"
#include "solver/particles/background_grid.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// The findings about the regions' outlines alone: self-intersections, overlaps and gaps.
std::vector<std::string> check_outlines(const Section& section);

/// Everything wrong with the section, one complete sentence each, naming the physical group and coordinates:
/// self-intersections, regions that overlap, gaps between regions, curves not on any region, a grid
/// that does not cover the soil. Empty when the section is sound.
std::vector<std::string> check_section(const Section& section, const BackgroundGrid& grid);

} // namespace quicksand
