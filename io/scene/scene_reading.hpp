// A scene as read, with its keys and what is to be said of it.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_check.hpp"
#include "io/tables/scene.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace quicksand {

/// A stage that begins with the steady flow between its heads, and what has soil in it.
struct SeepingStage {
    Scene scene;
    std::vector<ResolvedKey> keys;
};

struct SceneReading {
    Scene scene;
    /// Earlier stages whose water flows, and the one before that begins with still water, in their order:
    /// what a flow in time begins with.
    std::vector<Scene> flows;
    /// How many of the last of them have wetted soil since soil settled: it stays wet.
    std::size_t wetting = 0;
    /// Whether the stage has the flow of the last of them: one in time, which no heads tell.
    bool keeps_flow = false;
    /// Lines up to which still water stands in this and the other stages: particles are parted there.
    std::vector<WaterLine> water_lines;
    /// The stages, this one among them, at whose line of the flow particles are parted as well.
    std::vector<SeepingStage> seeping;
    /// The lines at which those of the run were parted that the scene goes on from; none: it begins anew.
    std::optional<std::vector<WaterLine>> parted_before;
    std::vector<ResolvedKey> keys;
    Diagnostics warnings;
};

} // namespace quicksand
