// The strains of two soils that share a cell.
//
// A cell has one strain. Where the face between two soils lies within it, soft soil would strain as little as
// the stiff one beside it, and a layer would be too stiff by a part of its cells. Both soils take strains of
// their own instead, as layers that touch along a plane of normal n (a laminate of rank one): they jump by a
// vector j across it,
//   eps_a = eps + f_b (j n + n j)/2,   eps_b = eps - f_a (j n + n j)/2,
// with f their parts of the volume, so that the mean strain stays that of the cell:
//   j_n = -w r_n / (f_b M_a + f_a M_b),   j_t = -r_t / (f_b G_a + f_a G_b).
// r is by how much the tractions on the plane, of total stresses, would change apart in an elastic step with
// one strain; and what is left between them (by yielding, particles that change their cells), which decays in
// the time of five waves through a cell: in twenty, yielding soil that dilates drove a stiff tip out. What
// the tractions differ between the centres of both soils at rest, where stresses grow with depth, is left:
// equal soils of two names strain as one. a is the soil with most volume in the cell, b all others; n:
// soil_faces.hpp. Slivers, whose stress is that of another place, have no part in it. The nodal forces work
// on the mean strain; what they miss is V f_a f_b (r j).
//
// (The slope of the tractions over the cells around would tell what they differ by weight and waves, too. It
// follows the stiffness of soils far off: vibrations grew.)
//
// Water that both soils have in common must flow from one to the other when they change their volumes in
// unlike ways: w = dt / (dt + h^2/c_v) of the less permeable one, 0 where pores keep their water, 1 without.
//
// A stiff or strong layer that is nowhere as thick as a cell beside soil that is has j_t = 0: it bends and
// bears by its shear, which it would pass on to the soil around.
#pragma once

#include "solver/base/stage.hpp"
#include "solver/cell_strain/soil_contrasts.hpp"
#include "solver/cell_strain/soil_faces.hpp"

namespace quicksand {

/// What the volume of pores that soils share does while they strain.
enum class SharedWater : std::uint8_t {
    none,  // it has no pressure, or one that is held
    flows, // it flows from one soil to the other
    kept,
};

/// The soils of a problem that can share cells.
struct SharedSoils {
    SoilOfMaterial of_material;        // empty: none can; soils that differ by name and weight alone are one
    std::vector<std::uint8_t> slivers; // by lasting number: 1 for one, whose stress is that of its carrier
    SharedWater water = SharedWater::none;
    std::vector<Contrast> contrasts; // by two materials

    Contrast contrast(std::int32_t first, std::int32_t second) const
    {
        return contrasts[static_cast<std::size_t>(first) * of_material.size() +
                         static_cast<std::size_t>(second)];
    }
};

SharedSoils make_shared_soils(const Problem& problem, Stage stage);

/// Give the soils of shared cells their own strains in a step of dt, in the velocity gradients of the
/// particles. Cells with solids keep one strain.
void part_strains_of_soils(const Problem& problem, double dt, const CellLists& lists,
                           const SharedSoils& shared, Particles& particles);

} // namespace quicksand
