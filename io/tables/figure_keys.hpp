// The keys of the figures that `quicksand figures` draws from a finished run.
#pragma once

#include "io/keys/scene_schema.hpp"

#include <vector>

namespace quicksand {

std::vector<SceneKey> figure_keys();

} // namespace quicksand
