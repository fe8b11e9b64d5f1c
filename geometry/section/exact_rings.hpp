// Areas bounded by rings in exact numbers, and their division along lines parallel to the axes.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <vector>

namespace quicksand {

using ExactNumber = CGAL::Exact_predicates_exact_constructions_kernel::FT;
using ExactPoint = std::array<ExactNumber, 2>;

/// Rings that together bound an area, which lies to their left: outer ones and holes, in any order.
using ExactRings = std::vector<std::vector<ExactPoint>>;

/// The part of an area below and above the line on which the coordinate `axis` (0: x, 1: y) is `at`. Decided
/// without rounding; the part may have collinear and repeated vertices, and rings without area.
ExactRings part_below(const ExactRings& rings, std::size_t axis, const ExactNumber& at);
ExactRings part_above(const ExactRings& rings, std::size_t axis, const ExactNumber& at);

} // namespace quicksand
