// The water that a stage begins with, as the stages before have left it.
#pragma once

#include "io/scene/scene_reading.hpp"

#include <vector>

namespace quicksand {

/// Soil that the water of a stage has wetted stays wet until soil settles anew: fills `wetting` of the
/// stages. A head with a ramp_time rises or falls from where the stage before has left it.
void carry_water_on(std::vector<SceneReading>& stages);

/// Let the particles of all stages be parted at the lines of still water of each of them, so that they are
/// the same particles: fills `water_lines`.
void share_water_lines(std::vector<SceneReading>& stages);

} // namespace quicksand
