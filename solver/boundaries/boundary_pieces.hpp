// Boundary curves carried by the particles beside them.
//
// Loads on the surface of the soil have to follow it. At the set-up a curve is cut into pieces, each
// beside one particle; the ends of a piece keep their places in the particle's domain (local coordinates), so
// that it moves, turns and stretches with the domain. The load on a piece is distributed to the corners of
// the domain by the bilinear functions of the local coordinates and goes from there to the nodes, as CPDI
// does with everything else (Sadeghirad, Brannon and Burghardt 2011). Nodes that a piece loads thus carry
// mass of the piece's particle, the total is exact, and so is the moment. A piece of a cut domain lies on an
// edge of its polygon, whose two corners take the load: with the trapezoid rule of the polygon's gradient,
// equal pressures on both sides of the edge balance.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// Cut the curves along which something acts on the soil into pieces of the particles beside them: fills
/// Boundary::pieces. Returns the names of curves with segments that have no soil beside them. The lengths of
/// a curve's pieces add up to its own. Marks segments beside dry soil.
std::vector<std::string> attach_boundaries(Problem& problem, const Particles& particles);

/// Present places of particles by their lasting number, as long as the arrays are not reordered.
class ParticlePlaces {
public:
    /// Index of the particle in the arrays; the particle must be there.
    std::size_t find(const Particles& particles, std::int32_t identifier);

private:
    std::vector<std::int32_t> index_of_identifier_;
};

/// Where a piece is now; `p` is the particle that carries it.
PresentPiece present_piece(const Problem& problem, const Particles& particles, const BoundaryPiece& piece,
                           std::size_t p);

/// What lies beyond a curve does this to a node; a node can have several.
struct NodalForce {
    std::size_t node = 0;
    Vector2 grains = Vector2::Zero();  // of loads, held reactions, the ground beyond [N/m]
    Vector2 mixture = Vector2::Zero(); // of the water beyond: (1 - n) on the grains, n on the water [N/m]
};

/// Call add(node, fraction) for the nodes that a piece's load acts on; the fractions add up to 1.
template <class Add>
void for_each_loaded_node(const BackgroundGrid& grid, const PresentPiece& piece, Add&& add);

template <class Add>
void for_each_loaded_node(const BackgroundGrid& grid, const PresentPiece& piece, Add&& add)
{
    for (std::size_t c = 0; c < 4; ++c) {
        const auto [i, j, xi, eta] = place_in_cell(grid.cells_from_rim(piece.corners[c]), piece.tolerance);
        const std::size_t node = grid.node_index(i, j), above = grid.node_index(i, j + 1);
        add(node, piece.fractions[c] * (1.0 - xi) * (1.0 - eta));
        add(node + 1, piece.fractions[c] * xi * (1.0 - eta));
        add(above, piece.fractions[c] * (1.0 - xi) * eta);
        add(above + 1, piece.fractions[c] * xi * eta);
    }
}

} // namespace quicksand
