// Strength along a plane on which two bodies slide, and the soil of a layer that gives it to them.
//
// A thin layer that shears along itself without change of volume has, once it flows, the axes of its stress
// at 45 degrees to it: with soil that does not dilate, the normal stress is then the centre of Mohr's circle
// and the shear stress its radius, tau = c cos(phi) + sigma' sin(phi) (Davis 1968). So a layer slides with
// c_d + sigma' tan(delta) when sin(phi) = tan(delta) and c cos(phi) = c_d. For the same reason soil without
// dilation bears sin(phi), not tan(phi), along any plane.
#pragma once

#include "solver/problem/skeleton_law.hpp"

#include <optional>

namespace quicksand {

/// Shear stress at which a plane slides: c + sigma' tan(delta).
struct SlipStrength {
    double friction = 0.0; // tan(delta) [-]
    double cohesion = 0.0; // c [Pa]
};

/// Cohesion and tan(phi) of a soil: of sand that has a friction of its peak and one of constant volume, the
/// larger at one atmosphere. None: the law has no strength.
std::optional<SlipStrength> coulomb_strength(const SkeletonLaw& law);

/// What the soil bears along a plane of slip as its law is, with its dilation; none: no strength.
std::optional<SlipStrength> slip_strength(const SkeletonLaw& law);

/// The soil of a layer that slides at the strength, or at that of the soil itself where it is smaller: moduli
/// are kept, friction and cohesion lowered, and slip is at constant volume. Sand that liquefies does so in
/// the layer, too: it contracts below its friction and does not dilate at it. The law has a strength.
SkeletonLaw slipping(const SkeletonLaw& law, const SlipStrength& strength);

} // namespace quicksand
