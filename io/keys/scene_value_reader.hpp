// One value of the scene: its type, unit, range and plausibility, by its row of the key table.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_document.hpp"
#include "io/keys/scene_schema.hpp"

#include <optional>
#include <string>

namespace quicksand {

/// Read the value of the key at `path`. What is wrong with it is added to `findings`; then the result is
/// empty.
std::optional<SceneValue> read_value(const SceneKey& key, const std::string& path, const DocumentNode& node,
                                     Diagnostics& findings);

/// "text", "a table", ...: what a node is, in words.
std::string describe_kind(DocumentNode::Kind kind);

} // namespace quicksand
