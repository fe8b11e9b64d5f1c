// Staged construction: soil that stages place and remove, as what their scenes say of regions.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_document.hpp"

namespace quicksand {

/// Check `place` and `remove` of all stages of a document with tables [stages.NAME]: names of regions, soil
/// that is placed where there is some, or removed where there is none. What is no list of texts is left to
/// the check of the keys.
void check_placement(const DocumentNode& document, Diagnostics& findings);

/// Whether a stage places or removes soil.
bool places_soil(const DocumentNode& document);

/// Let the regions that a stage places later have no soil: regions.NAME.soil = "absent", unless it is given.
void empty_unplaced_regions(DocumentNode& document);

/// Let regions have the soil that a stage places, and none where it removes it.
void place_regions(const DocumentNode& stage, DocumentNode& document);

/// The document of one stage as its results keep it: what it places is there already.
DocumentNode without_placement(DocumentNode document);

} // namespace quicksand
