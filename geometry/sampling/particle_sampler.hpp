// From a section to material-point domains.
#pragma once

#include "geometry/section/section.hpp"
#include "solver/faces/water_condition.hpp"
#include "solver/interpolation/cut_domains.hpp"
#include "solver/particles/background_grid.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quicksand {

/// One domain as sampled: a parallelogram, a quadrilateral with a twist as in solver/interpolation/cpdi2.hpp,
/// or the rectangle that goes with a polygon as in solver/interpolation/cut_domains.hpp. 4 r_1 x r_2 is its
/// area.
struct ParticleDomain {
    Vector2 centre = Vector2::Zero();      // centroid [m]
    Vector2 half_edge_1 = Vector2::Zero(); // [m]
    Vector2 half_edge_2 = Vector2::Zero(); // [m]
    Vector2 twist = Vector2::Zero();       // [m]
    double volume = 0.0;                   // [m2]
    std::size_t region = 0;                // index into Section::regions
    bool is_piece = false;                 // of a box that an outline or a water line cuts
    std::int32_t shape = -1;               // index into Sampling::shapes; -1 where it is its half edges'
};

/// What the sampling of one region cost and how good it is.
struct RegionSampling {
    std::size_t particles = 0;
    std::size_t cut = 0;          // of the particles: pieces of boxes that an outline or a water line cuts
    double area = 0.0;            // exact, of the region's polygons [m2]
    double area_error = 0.0;      // of the domains, (theirs - area) / area [-]
    double smallest_volume = 0.0; // [m2]
    double largest_volume = 0.0;  // [m2]
};

struct Sampling {
    std::vector<ParticleDomain> domains;
    std::vector<CutDomain> shapes;       // of those domains that are neither boxes nor quadrilaterals
    std::vector<RegionSampling> regions; // as Section::regions
    double particles_per_cell = 0.0;     // mean over the cells that hold any [-]
    std::size_t occupied_cells = 0;      // cells that hold a domain's centre [-]
};

/// A regular lattice of per_cell_x x per_cell_y domains in every cell. Those that outlines cut become exact
/// convex pieces, one domain each, in the order of the lattice; those that water lines run through are parted
/// there.
Sampling sample_lattice(const Section& section, const BackgroundGrid& grid, int per_cell_x, int per_cell_y,
                        const std::vector<WaterLine>& water_lines = {});

/// One domain per quadrilateral of the section's mesh, corners included. Throws InputError where one is
/// folded or not convex.
Sampling sample_mesh(const Section& section, const BackgroundGrid& grid);

} // namespace quicksand
