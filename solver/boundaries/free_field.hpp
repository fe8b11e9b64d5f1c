// The ground beyond free-field sides acts on the soil (Zienkiewicz, Bicanic and Shen 1989).
//
//   traction on the side   sigma_ff . n + rho V (v_ff - v),    V = V_p along n, V_s along the side
//
// sigma_ff is the total stress and v_ff the velocity of a column of its own (FreeField), which goes ahead
// with the same steps. Nothing of the body acts on the column: the level ground beyond a side has no end. The
// forces of its stress are summed by rows of nodes from the column's own particles and weights
// (free_field_rows.hpp), and go to the nodes of the body that carry the side at this height, in proportion to
// their part of it. In level ground every node of the side thus has the acceleration of the column, and the
// dashpots are at rest. Water passes the side: the pore pressure of the column acts on both phases by their
// parts of the volume, as that of any water beyond a curve, so that the water of level ground moves
// relative to its grains as in the column, and seepage goes on.
//
// The part of the dashpots with v is that of viscous boundaries, with the impedance of the soil beside the
// side (viscous_boundary.hpp). The part with v_ff, the mean of the step as there, is known before the step,
// a force like others.
#pragma once

#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace quicksand {

/// The free field beyond a part of a free-field side: the place in Problem::free_fields of the nearest one;
/// none where there is none.
std::optional<std::size_t> free_field_beyond(const Problem& problem, const Segment& part);

/// Add the forces of the ground beyond free-field sides, from the rows of the state's free fields: on the
/// grains those of the effective stress and of the dashpots.
void add_free_fields(const Problem& problem, const State& state, ParticlePlaces& places,
                     std::vector<NodalForce>& forces);

} // namespace quicksand
