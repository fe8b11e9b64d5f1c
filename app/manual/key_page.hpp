// The manual page of a table of keys: quicksand-scene(5) and quicksand-element(5).
#pragma once

#include "io/keys/scene_schema.hpp"

#include <string>

namespace quicksand {

/// The page `name` in troff: how such a file is written, the units, and every key of the table.
std::string key_page(const std::string& name, const KeyTable& table);

} // namespace quicksand
