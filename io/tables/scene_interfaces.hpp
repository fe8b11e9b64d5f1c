// [interfaces.NAME]: how two regions slide on each other.
#pragma once

#include "io/keys/scene_check.hpp"
#include "io/tables/scene.hpp"

#include <vector>

namespace quicksand {

/// The rows of the key table.
std::vector<SceneKey> interface_keys();

/// The interfaces as written; what is wrong with them without the drawing is added to `findings`.
std::vector<SceneInterface> read_interfaces(const SceneValues& values, Diagnostics& findings);

} // namespace quicksand
