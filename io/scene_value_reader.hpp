// One value of the scene: its type, unit, range and plausibility, by its row of the key table.
#pragma once

#include "io/diagnostics.hpp"
#include "io/scene_document.hpp"
#include "io/scene_schema.hpp"

#include <optional>
#include <string>

namespace quicksand {

/// Read the value of the key at `path`. What is wrong with it is added to `findings`; then the result is
/// empty.
std::optional<SceneValue> read_value(const SceneKey& key, const std::string& path, const DocumentNode& node,
                                     Diagnostics& findings);

/// "text", "a table", ...: what a node is, in words.
std::string describe_kind(DocumentNode::Kind kind);

/// "one of a, b, c", or "a" where there is no choice.
std::string one_of(const std::vector<std::string>& words);

} // namespace quicksand
