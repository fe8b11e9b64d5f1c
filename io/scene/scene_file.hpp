// Reading a scene: TOML text to a checked Scene, by the key table of scene_schema.hpp.
#pragma once

#include "io/scene/scene_reading.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// Read a scene file; every `--set path=value` of `overrides` replaces a key first. Of a scene with stages
/// this is the first one. Throws InputError with all errors at once.
SceneReading read_scene_file(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// The same for every stage, in their order; a scene without stages is the only one.
std::vector<SceneReading> read_scene_stages(const std::filesystem::path& file,
                                            const std::vector<std::string>& overrides);

} // namespace quicksand
