// A document that changes another one: variants of a scene, and its stages.
#pragma once

#include "io/keys/scene_document.hpp"

namespace quicksand {

/// Put the values of a variant in place of those of its base. Where it gives a word that decides which other
/// keys of a table are of use, as the soil of a boundary, those of the base that are of no use any more go.
void merge_variant(DocumentNode&& variant, DocumentNode& base);

} // namespace quicksand
