// A drawing is a program of gmsh's, and may ask for others to be started. Reading its text first finds most
// such wishes; this lets none come true.
#pragma once

namespace quicksand {

/// From here on this process and its children can start no other program: the system refuses. Where a system
/// cannot do that, nothing changes.
void forbid_other_programs();

} // namespace quicksand
