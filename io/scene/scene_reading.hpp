// A scene as read, with its keys and what is to be said of it.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_check.hpp"
#include "io/tables/scene.hpp"

#include <vector>

namespace quicksand {

struct SceneReading {
    Scene scene;
    /// The stages from the last that settled soil on, up to the one before, where their water flows: soil
    /// that it has wetted stays wet.
    std::vector<Scene> wetting;
    std::vector<ResolvedKey> keys;
    Diagnostics warnings;
};

} // namespace quicksand
