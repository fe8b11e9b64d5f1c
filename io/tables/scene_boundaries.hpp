// The conditions and loads on the boundary curves of a scene.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_check.hpp"
#include "io/tables/scene.hpp"

#include <filesystem>
#include <vector>

namespace quicksand {

/// The tables [boundaries.NAME]; file names are relative to `folder`. Keys that contradict each other and
/// tables of histories that cannot be read are added to `findings`.
std::vector<SceneBoundary> read_boundaries(const SceneValues& values, const std::filesystem::path& folder,
                                           Diagnostics& findings);

/// The boundary of a physical curve; null where the scene has no table for it.
const SceneBoundary* find_boundary(const Scene& scene, const std::string& curve);

} // namespace quicksand
