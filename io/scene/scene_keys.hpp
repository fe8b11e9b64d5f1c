// The keys of a scene's copy in a results folder, whose drawing lies elsewhere.
#pragma once

#include "io/keys/scene_check.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// The resolved keys of the copy; `overrides` are those of its run, which the copy of a stage holds already.
/// Throws InputError.
std::vector<ResolvedKey> read_scene_keys(const std::filesystem::path& copy,
                                         const std::vector<std::string>& overrides);

} // namespace quicksand
