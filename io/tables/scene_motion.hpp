// The base motion of a scene, from its keys and from records in files.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_check.hpp"
#include "solver/problem/base_motion.hpp"

#include <filesystem>

namespace quicksand {

/// The motion that the keys of [motion] describe; file names are relative to `folder`. What is wrong with a
/// record is added to `findings`; then there is no motion.
BaseMotion read_motion(const SceneValues& values, const std::filesystem::path& folder, Diagnostics& findings);

} // namespace quicksand
