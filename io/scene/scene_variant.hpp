// A document that changes another one: variants of a scene, its stages and the values of --set.
#pragma once

#include "io/keys/scene_document.hpp"

namespace quicksand {

/// Put the values of a variant in place of those of its base. Where it gives a word that decides which other
/// keys of a table are of use, as the soil of a boundary, those of the base that are of no use any more go.
/// So do those that say in another way what a key of the variant says, as two strengths of an interface.
void merge_variant(DocumentNode&& variant, DocumentNode& base);

} // namespace quicksand
