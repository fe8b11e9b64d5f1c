// Scenes that are variants of another one: they name it as their base and give only what differs.
#pragma once

#include "io/keys/scene_document.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace quicksand {

/// Put the keys of a scene into the scene beside it that it names as its base, if any, which may have a base
/// itself; the result has the keys of all but those that the scene goes without. What is wrong with a base is
/// added to `findings`; then the result is empty.
std::optional<DocumentNode> merge_with_base(const std::filesystem::path& file, DocumentNode&& document,
                                            Diagnostics& findings);

/// The document as TOML that names no base, without comments.
std::string document_text(const DocumentNode& document);

} // namespace quicksand
