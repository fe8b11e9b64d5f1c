// What a stage begins with, as the stages before have left it: its water, its loads and its moving walls.
#pragma once

#include "io/scene/scene_reading.hpp"

#include <vector>

namespace quicksand {

/// Loads, motions of walls and pore pressures at curves that a stage leaves as they were go on from where the
/// stage before left them; another load with a ramp_time rises or falls from what acted at its end.
void carry_courses_on(std::vector<SceneReading>& stages);

/// Let loads, walls and outer water of a scene begin with what acts in it at a time [s].
void begin_later(double time, Scene& scene);

/// Soil that the water of a stage has wetted stays wet until soil settles anew: fills `wetting` of the
/// stages. A head with a ramp_time rises or falls from where the stage before has left it.
void carry_water_on(std::vector<SceneReading>& stages);

/// Let the particles of all stages be parted at the lines of still water and of steady flow of each of them,
/// so that they are the same particles: fills `water_lines` and `seeping`.
void share_water_lines(std::vector<SceneReading>& stages);

} // namespace quicksand
