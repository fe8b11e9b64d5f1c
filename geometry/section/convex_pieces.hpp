// Division of small areas into convex pieces.
#pragma once

#include "geometry/section/section.hpp"

#include <vector>

namespace quicksand {

/// Area inside a ring, negative where the ring runs clockwise [as the coordinates, squared].
double signed_area(const Ring& ring);

/// Join vertices nearer to each other than `tolerance`, and leave out those as near to the line through their
/// neighbours; empty where less than a triangle is left.
Ring without_needless_vertices(Ring ring, double tolerance);

/// Convex pieces of the area that rings bound, which lies to their left: cut at reflex corners along x or y,
/// whichever is closer to halving the corner. The sharpest corner is cut first, so that neither the order of
/// the vertices nor a mirror changes the pieces. Pieces smaller than `least_area` are left out.
std::vector<Ring> convex_pieces(const std::vector<Ring>& rings, double tolerance, double least_area);

} // namespace quicksand
