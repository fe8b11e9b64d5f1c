// The outline of the soil that particle domains cover together.
#pragma once

#include "solver/base/conventions.hpp"

#include <vector>

namespace quicksand {

/// Corners of one particle domain, counter-clockwise [m].
using DomainCorners = std::vector<Vector2>;

/// Lines along the edges beyond which no other domain lies, with soil on their left. Neighbours need not
/// share whole edges, and gaps narrower than `gap` [m] are closed.
std::vector<std::vector<Vector2>> outline_of(const std::vector<DomainCorners>& domains, double gap);

} // namespace quicksand
