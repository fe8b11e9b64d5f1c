// What is left of a scene where some of its regions have no soil.
#pragma once

#include "geometry/sampling/particle_sampler.hpp"
#include "geometry/section/section.hpp"
#include "io/keys/scene_check.hpp"
#include "io/tables/scene.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// For every region of the section whether its keys say that it has no soil.
std::vector<bool> absent_regions(const std::vector<ResolvedKey>& keys, const Section& section);

/// Take away the probes that would ride with soil that is not there.
void leave_out_probes(const Section& section, const std::vector<bool>& absent, Scene& scene);

/// Take away the domains of absent regions. Returns the lasting numbers of those that are left: each domain
/// has the same one whatever else is there.
std::vector<std::int32_t> keep_present(const std::vector<bool>& absent, const BackgroundGrid& grid,
                                       Sampling& sampling);

} // namespace quicksand
