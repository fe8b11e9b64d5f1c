// From a section to material-point domains.
#pragma once

#include "geometry/section.hpp"
#include "solver/background_grid.hpp"

#include <cstddef>
#include <vector>

namespace quicksand {

/// One domain as sampled: a parallelogram, or a quadrilateral with a twist as in solver/cpdi2.hpp.
struct ParticleDomain {
    Vector2 centre = Vector2::Zero();      // centroid [m]
    Vector2 half_edge_1 = Vector2::Zero(); // [m]
    Vector2 half_edge_2 = Vector2::Zero(); // [m]
    Vector2 twist = Vector2::Zero();       // [m]
    double volume = 0.0;                   // corrected: the region's areas add up exactly [m2]
    std::size_t region = 0;                // index into Section::regions
};

/// What the sampling of one region cost and how good it is.
struct RegionSampling {
    std::size_t particles = 0;
    double area = 0.0;            // exact, of the region's polygons [m2]
    double area_error = 0.0;      // of the domains before the correction, (theirs - area) / area [-]
    double volume_factor = 1.0;   // the correction: area / area of the domains before it [-]
    double smallest_volume = 0.0; // [m2]
    double largest_volume = 0.0;  // [m2]
};

struct Sampling {
    std::vector<ParticleDomain> domains;
    std::vector<RegionSampling> regions; // as Section::regions
    double particles_per_cell = 0.0;     // mean over the cells that hold any [-]
    std::size_t occupied_cells = 0;      // cells that hold a domain's centre [-]
};

/// A regular lattice of per_cell_x x per_cell_y domains in every cell, kept where the centre lies inside.
/// Domains cut by the outline are split boundary_refinement times each way (1: not at all) and their parts
/// kept by the same test, so that slopes are finer stairs.
Sampling sample_lattice(const Section& section, const BackgroundGrid& grid, int per_cell_x, int per_cell_y,
                        int boundary_refinement);

/// One domain per quadrilateral of the section's mesh, corners included. Throws InputError where one is
/// folded or not convex.
Sampling sample_mesh(const Section& section, const BackgroundGrid& grid);

} // namespace quicksand
