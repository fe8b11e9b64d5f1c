// What a stage of a scene changes of the one before: what it may not, and what its soil begins anew with.
#pragma once

#include "io/scene/scene_reading.hpp"

#include <functional>
#include <string>
#include <vector>

namespace quicksand {

/// Check that no stage changes what all stages of a scene have in common.
void check_stages(const std::vector<SceneReading>& stages, Diagnostics& findings);

/// Let the soils of all stages remember what those of any ask for.
void keep_histories(std::vector<SceneReading>& stages);

/// Leave the damping of elastic soil out of stages that do not shake: loads that last would find the soil
/// softer by it.
void end_damping(std::vector<SceneReading>& stages);

/// Names of the keys that a run and the one that it goes on from have to share and do not: drawing's numbers,
/// grid, sampling, gravity, and unless it settles the still water.
std::vector<std::string> uncommon_keys(const std::vector<ResolvedKey>& before,
                                       const std::vector<ResolvedKey>& now, bool settles);

/// Keys whose values differ from those of another scene, as "water.level: 4 -> 6 m"; with is_told(path) those
/// alone for which it is true.
std::vector<std::string> changed_keys(const std::vector<ResolvedKey>& before,
                                      const std::vector<ResolvedKey>& now,
                                      const std::function<bool(const std::string&)>& is_told = {});

/// For each of the regions whether its soil is another one than in another scene, by any key but those of its
/// water, its settlement after shaking and the accuracy of its law.
std::vector<bool> changed_soils(const std::vector<ResolvedKey>& before, const std::vector<ResolvedKey>& now,
                                const std::vector<std::string>& regions);

/// For each of the regions whether it has no soil.
std::vector<bool> absent_soils(const std::vector<ResolvedKey>& keys, const std::vector<std::string>& regions);

} // namespace quicksand
