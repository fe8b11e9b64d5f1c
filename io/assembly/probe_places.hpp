// Where probes look: particles, points and the surface of the soil.
#pragma once

#include "io/tables/scene.hpp"
#include "solver/particles/particles.hpp"
#include "solver/problem/problem.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// The particle whose position at the start of shaking was nearest to the point.
std::size_t nearest_particle(const Particles& particles, const Vector2& point);

/// What is wrong with a point more than two cells from any soil: "lies outside the soil: the nearest particle
/// is at ...".
std::optional<std::string> outside_soil(const Problem& problem, const Particles& particles,
                                        const Vector2& point);

/// Where a probe looks: one point, or those of a profile. It must have its place.
std::vector<Vector2> points_of(const SceneProbe& probe);

/// The particle whose domain is highest at x, and that height. Between tied sides soil goes on periodically.
struct SurfacePoint {
    bool found = false; // false where there is no soil at x
    std::size_t particle = 0;
    double height = 0.0; // [m]
    double shift = 0.0;  // of x to where the particle is: a period, where it is beyond a tied side [m]
};
SurfacePoint surface_point(const Problem& problem, const Particles& particles, double x);

} // namespace quicksand
