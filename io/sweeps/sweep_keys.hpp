// The keys of a sweep's file.
#pragma once

#include "io/keys/scene_schema.hpp"

namespace quicksand {

const KeyTable& sweep_key_table();

} // namespace quicksand
