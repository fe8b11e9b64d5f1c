// The keys of the shaking.
#pragma once

#include "io/keys/scene_schema.hpp"

#include <vector>

namespace quicksand {

std::vector<SceneKey> motion_keys();

} // namespace quicksand
