// Keys of the physical curves: how grains and water meet them, what acts on them.
#pragma once

#include "io/keys/scene_schema.hpp"

#include <vector>

namespace quicksand {

std::vector<SceneKey> boundary_keys();

} // namespace quicksand
