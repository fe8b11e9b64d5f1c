// Soil with the strength of friction and cohesion in a scene.
#pragma once

#include "io/laws/soil_law.hpp"

namespace quicksand {

/// Report a dilation beyond the friction, a soil without strength, and a tension beyond the tip.
void check_mohr_coulomb(const LawSource& source);

} // namespace quicksand
