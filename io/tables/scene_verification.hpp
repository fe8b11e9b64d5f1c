// What a scene asks of `verify`, from its keys.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_check.hpp"
#include "io/tables/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// The table [verification], if the scene has one. What is wrong with it is added to `findings`.
std::optional<SceneVerification> read_verification(const SceneValues& values, Diagnostics& findings);

/// Replacements of keys, as `--set` takes them, that give the scene `cells` cells along its length.
std::vector<std::string> resolution_overrides(const SceneVerification& verification, int cells);

} // namespace quicksand
