// One number of an element test's file that takes several values.
#pragma once

#include "io/keys/scene_check.hpp"

#include <optional>
#include <string>
#include <vector>

namespace quicksand {

struct VariedValue {
    std::string label; // as written, "10" or "50 kPa"
    DocumentNode node; // of the value in the list, so that messages point at it
};

struct Variation {
    KeyPath path; // of the key
    std::vector<VariedValue> values;
};

/// What `vary` and `values` of the test say. What is wrong is added to `findings`; then the result is empty.
std::optional<Variation> find_variation(const DocumentNode& document, const SceneValues& values,
                                        const NamedTable& material, const NamedTable& test,
                                        Diagnostics& findings);

/// The document with this value at the path.
DocumentNode put_value(DocumentNode document, const KeyPath& path, const DocumentNode& value);

} // namespace quicksand
