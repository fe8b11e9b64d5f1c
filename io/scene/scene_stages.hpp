// The stages of a scene as documents of their own: what is common to all of them, with what the stages so far
// change put in place.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_document.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// Turn the list [[stages]] of a document into tables [stages.NAME], so that a variant and --set can name
/// them; a stage without a name has that of its kind.
void name_stages(DocumentNode& document, Diagnostics& findings);

/// The name of every stage, in their order; none in a document without stages.
std::vector<std::string> stage_names(const DocumentNode& document);

/// The document of one stage, with what it and the stages before it change; its table [stages.NAME] keeps the
/// keys of the stage alone.
DocumentNode document_of_stage(const DocumentNode& document, const std::string& name);

} // namespace quicksand
