// The strains of two soils that share a cell.
//
// A cell has one strain. Where the face between two soils lies within it, soft soil would strain as little as
// the stiff one beside it, and a layer would be too stiff by a part of its cells. Both soils take strains of
// their own instead, as layers that touch along a plane of normal n (a laminate of rank one): they jump by a
// vector j across it,
//   eps_a = eps + f_b (j n + n j)/2,   eps_b = eps - f_a (j n + n j)/2,
// with f their parts of the volume, so that the mean strain stays that of the cell. The step's j evens out
// the difference r of the tractions on the plane, total stresses, as far as the elastic part of the step
// tells it:
//   j_n = -r_n / (f_b M_a + f_a M_b),   j_t = -r_t / (f_b G_a + f_a G_b).
// The nodal forces work on the mean strain; what they miss is V f_a f_b (r j), none of equal tractions.
//
// n is the direction in which f_a changes most around the cell: the eigenvector of the sum of g g^T over the
// four quarters of its surroundings, g the slope of f_a there. It is also that of a thin layer within one row
// of cells, on both sides of which f_a is the same. a is the soil with most volume in the cell, b all others.
#pragma once

#include "solver/particles/cell_lists.hpp"
#include "solver/problem/problem.hpp"

#include <cstdint>
#include <vector>

namespace quicksand {

/// The soil of every material, by the first one of its kind; below zero of solids, whose cells strain as one.
/// Empty where no two soils can share a cell.
using SoilOfMaterial = std::vector<std::int32_t>;

SoilOfMaterial soils_that_share_cells(const Problem& problem);

/// Give the soils of shared cells their own strains in a step of dt, in the velocity gradients of the
/// particles. Cells with solids keep one strain: a wall within a row of cells resists bending by its shear
/// alone.
void part_strains_of_soils(const Problem& problem, double dt, const CellLists& lists,
                           const SoilOfMaterial& soil_of, Particles& particles);

} // namespace quicksand
