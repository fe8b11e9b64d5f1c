// The materials of UBCSAND in a scene.
#pragma once

#include "io/keys/scene_check.hpp"
#include "io/tables/scene.hpp"

namespace quicksand {

/// Make the laws of the materials with model = "ubcsand"; the resolved keys get the numbers of the generic
/// set. What is wrong is added to `findings`, also an initial stress beyond the failure limit.
void read_ubcsand_materials(SceneValues& values, Scene& scene, Diagnostics& findings);

} // namespace quicksand
