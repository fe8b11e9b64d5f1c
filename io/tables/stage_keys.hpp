// The keys of a scene's stages.
#pragma once

#include "io/keys/scene_check.hpp"
#include "io/keys/scene_schema.hpp"
#include "io/tables/scene_stage.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace quicksand {

std::vector<SceneKey> stage_keys();

/// The stage that the values hold; none in a scene without stages.
std::optional<SceneStage> read_stage(const SceneValues& values);

/// The kind of a word; none where it is no kind.
std::optional<StageKind> stage_kind(std::string_view word);

/// The word of a kind.
std::string_view word_of_kind(StageKind kind);

} // namespace quicksand
