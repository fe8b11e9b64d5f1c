// Where the ground water stands in a scene's soil, and the state that follows: which soil is saturated, its
// pore pressures, and the effective stresses under the weight of the soil above.
#pragma once

#include "geometry/sampling/particle_sampler.hpp"
#include "geometry/section/section.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/tables/scene.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"
#include "solver/seepage/flow_field.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// y of the phreatic line at x: the scene's line, level beyond its ends, or else the water level [m].
double phreatic_elevation(const Scene& scene, double x);

/// A phreatic line needs points from left to right, none below the water level.
void check_phreatic_line(const Scene& scene, Diagnostics& findings);

/// Where the water of the soil stands at the start: at a drawn line or the level, or as it flows.
struct GroundWater {
    const Scene& scene;              // with water
    const FlowField* flow = nullptr; // none: the water is at rest below its line

    /// y up to which water would stand in a pipe that ends at the point [m].
    double head(const Vector2& point) const;

    /// y at x of the phreatic line, or of the water above the ground; where the soil at x is dry, below it
    /// [m].
    double surface(double x) const;

    /// Whether the soil at the point is below the phreatic line; `tolerance` is a length [m].
    bool saturates(const Vector2& point, double tolerance) const;
};

/// The line up to which water stands that flows, with a knee on every line of the lattice, level over the
/// cells beside free-field sides, whose columns have level rows; none where all soil is dry.
std::optional<WaterLine> line_of_flow(const FlowField& flow, const Problem& problem, int per_cell_x);

/// Soil above the phreatic line is a material of its own, not saturated: add these to the problem where a
/// domain of the sampling lies there, give them to `of_domain`, which holds the material of every domain, and
/// note whether the water of saturated soil rises above the level, or flows. Soil that an earlier flow has
/// wetted is saturated. Pre: the problem has the materials of the scene.
void divide_materials(const Scene& scene, const FlowField* flow, const std::vector<const FlowField*>& earlier,
                      const Sampling& sampling, std::vector<std::int32_t>& of_domain, Problem& problem);

/// Drained soil has no pressure that a head or pore pressure beyond a curve could balance, but for that of a
/// phreatic line above the water level: without one only still water at the level may lie beyond it.
void check_outer_water(const Scene& scene, const Problem& problem, Diagnostics& findings);

/// sigma'_v from the weight of the column above each particle, regions and water heeded; sigma'_h = K0
/// sigma'_v, none of both in neo-Hookean soil, whose stress is that of its shape; pore pressures by the depth
/// below the phreatic line or those of the flow, and the scene's excess.
void set_initial_state(const Scene& scene, const FlowField* flow, const Section& section,
                       const std::vector<std::int32_t>& of_region, const Problem& problem,
                       Particles& particles);

} // namespace quicksand
