// Reading a scene: TOML text to a checked Scene, by the key table of scene_schema.hpp.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_check.hpp"
#include "io/tables/scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

struct SceneReading {
    Scene scene;
    std::vector<ResolvedKey> keys;
    Diagnostics warnings;
};

/// Read a scene file; every `--set path=value` of `overrides` replaces a key first.
/// Throws InputError with all errors at once.
SceneReading read_scene_file(const std::filesystem::path& file, const std::vector<std::string>& overrides);

} // namespace quicksand
