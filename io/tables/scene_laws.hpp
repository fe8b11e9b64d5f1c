// The laws of the grain skeleton out of the tables [materials.NAME].
#pragma once

#include "io/keys/scene_check.hpp"
#include "solver/problem/skeleton_law.hpp"

namespace quicksand {

/// The law of a material; with keys that are missing or wrong, which has been reported, it is not to be used.
SkeletonLaw read_skeleton_law(const SceneValues& values, const NamedTable& material);

/// Report what the keys of a law say against each other, each of them being in its range.
void check_skeleton_laws(const SceneValues& values, Diagnostics& findings);

} // namespace quicksand
