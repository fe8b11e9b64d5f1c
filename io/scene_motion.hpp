// The base motion of a scene, from its keys and from records in files.
#pragma once

#include "io/diagnostics.hpp"
#include "io/scene_check.hpp"
#include "solver/base_motion.hpp"

#include <filesystem>
#include <optional>

namespace quicksand {

/// Read two columns, time [s] and acceleration times `factor` [m/s2]. What is wrong with the record is added
/// to `findings` at `place`; then the result is empty.
std::optional<SampledMotion> read_motion_record(const std::filesystem::path& file, double factor,
                                                const SourcePlace& place, Diagnostics& findings);

/// The motion that the keys of [motion] describe; file names are relative to `folder`.
BaseMotion read_motion(const SceneValues& values, const std::filesystem::path& folder, Diagnostics& findings);

} // namespace quicksand
