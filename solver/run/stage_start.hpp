// The state with which a stage begins that goes on from the end of another one.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <vector>

namespace quicksand {

/// What of the stage before goes on, and what begins anew.
struct StageStart {
    bool settles = false;            // under the still water of the problem: pores have its pressure,
                                     // or keep theirs where it settles undrained
    bool zero_displacements = false; // displacements count from here; after settling they do in any case
    bool zero_pressures = false;     // ru and excess pore pressures count from here
    std::vector<bool> changed_soils =
        {}; // by region: its law begins its memory anew, its grains may be others
};

/// `initial` is the state as drawn of the problem of the stage that begins, `reached` the end of a stage with
/// the same particles; a stage that settles may place and remove those of whole regions
/// (motion/soil_placement.hpp). Stresses, shapes, velocities, pore pressures and memories go on; time and
/// balances begin anew. Throws InputError where the particles differ otherwise.
State begin_stage(const Problem& problem, const State& initial, State reached, const StageStart& start);

} // namespace quicksand
