// From a checked scene to the problem and the state that a run starts from.
#pragma once

#include "io/assembly/assembled_case.hpp"

namespace quicksand {

/// Read the drawing, choose the grid, sample the section and set the K0 state. Throws InputError with all
/// errors at once; what gmsh finds in the drawing comes first.
AssembledCase assemble_case(SceneReading reading);

/// The same for a section that is already there.
AssembledCase assemble_case(SceneReading reading, Section section);

} // namespace quicksand
