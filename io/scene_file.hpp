// Reading a scene: TOML text to a checked Scene, by the key table of scene_schema.hpp.
#pragma once

#include "io/diagnostics.hpp"
#include "io/scene.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// One resolved key for `check`: what is used and where it comes from.
struct ResolvedKey {
    std::string path;   // "materials.sand.porosity"
    std::string value;  // in SI, as text
    std::string unit;   // "" when dimensionless
    bool given = false; // false: the default
};

struct SceneReading {
    Scene scene;
    std::vector<ResolvedKey> keys;
    Diagnostics warnings;
};

/// Read a scene file; every `--set path=value` of `overrides` replaces a key first.
/// Throws InputError with all errors at once.
SceneReading read_scene_file(const std::filesystem::path& file, const std::vector<std::string>& overrides);

} // namespace quicksand
