// The flows of water that a stage needs: its own, and those of other stages that it follows or whose lines
// part its particles.
#pragma once

#include "geometry/section/section.hpp"
#include "io/assembly/assembled_case.hpp"
#include "io/assembly/initial_flow.hpp"
#include "io/scene/scene_reading.hpp"
#include "solver/seepage/flow_field.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace quicksand {

/// For every region of the section, the index of its material.
std::vector<std::int32_t> materials_of_regions(const Scene& scene, const Section& section);

/// The earlier stages whose flows the stage of `scene` needs: all for one in time, else those that have
/// wetted its soil.
std::vector<Scene> needed_flows(const SceneReading& reading, const Scene& scene);

/// The flows of these stages in the soil of a section, one after the other; none of those whose water is
/// still. What is wrong with them was told there.
std::vector<std::optional<InitialFlow>> flows_before(const std::vector<Scene>& stages, const Section& drawn,
                                                     const Section& section);

/// The flow that the stage begins with; after one in time heads no longer change until it has ended.
void find_flow(const SceneReading& reading, const std::vector<std::int32_t>& of_region,
               std::vector<std::optional<InitialFlow>>& flows, AssembledCase& assembled);

/// The lines at which the particles are parted: those of still and of steadily flowing water, of all stages,
/// which have the same particles.
std::vector<WaterLine> lines_of_parting(const SceneReading& reading, const Section& drawn,
                                        const AssembledCase& assembled);

/// Where water has wetted the soil since it settled.
std::vector<const FlowField*> wetting_fields(const SceneReading& reading,
                                             const std::vector<std::optional<InitialFlow>>& flows);

} // namespace quicksand
