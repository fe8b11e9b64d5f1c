// The soil beside the common edge of two regions that slides, as materials of its own.
#pragma once

#include "geometry/sampling/particle_sampler.hpp"
#include "geometry/section/section.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/tables/scene.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/slip_strength.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace quicksand {

/// What has become of an interface of the scene.
struct InterfaceLayer {
    std::string name, sliding, beside; // the interface, the region whose soil slides, the other one
    double least_thickness = 0.0, thickness = 0.0; // along the edge, least and largest [m]
    SlipStrength strength;                         // with which it slides
    bool is_that_of_soil = false; // the soil itself slides with less than the interface would
    std::size_t particles = 0;
};

/// Give every domain its material: that of its region, or a copy of lower strength beside an interface,
/// which is added to the scene and the problem as "sand|caisson". Of several interfaces the nearest counts.
/// What is wrong, as regions that do not touch, is added to `findings`.
std::vector<std::int32_t> lay_interfaces(const Section& section, const Sampling& sampling,
                                         const std::vector<std::int32_t>& of_region, Scene& scene,
                                         Problem& problem, std::vector<InterfaceLayer>& layers,
                                         Diagnostics& findings);

} // namespace quicksand
