// What the parts of a scene say of each other: names that are referred to, tied sides, probes, accepted keys.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_check.hpp"

namespace quicksand {

/// Check the references between the tables of the scene.
void check_references(const SceneValues& values, Diagnostics& findings);

} // namespace quicksand
