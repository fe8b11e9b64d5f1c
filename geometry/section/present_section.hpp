// A section of which some regions have no soil: not placed yet, or excavated.
#pragma once

#include "geometry/section/section.hpp"

#include <vector>

namespace quicksand {

/// The section without the soil of the regions whose entry is true: they keep their names and their places in
/// the list and have no polygons. Of curves those parts are left that have soil beside them, with the soil on
/// their left where it lies on one side alone. Points, quadrilaterals and the bounding box stay.
Section without_soil_of(const std::vector<bool>& absent, const Section& section);

} // namespace quicksand
