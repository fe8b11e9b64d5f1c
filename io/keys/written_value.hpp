// Values that are kept as they were written, for a key that is not known here says what they mean.
#pragma once

#include "io/keys/scene_document.hpp"
#include "io/keys/scene_schema.hpp"

#include <optional>
#include <string>

namespace quicksand {

/// The number with a decimal point or an exponent, as TOML tells it from a whole one.
std::string decimal_text(double number);

/// A value of the type `quantity` or `value_list`; none where the node is not one.
std::optional<SceneValue> as_written(ValueType type, const DocumentNode& node);

/// What such a value looks like, for messages.
std::string form_as_written(ValueType type);

} // namespace quicksand
