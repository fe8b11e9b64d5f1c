// The table of keys of a file of element tests, read by the same machinery as a scene.
#pragma once

#include "io/keys/scene_schema.hpp"

namespace quicksand {

const KeyTable& element_key_table();

} // namespace quicksand
