// What is said of the steady flow that a scene begins with.
#pragma once

#include "io/assembly/case_assembly.hpp"

#include <string>

namespace quicksand {

/// For `check`: triangles and iterations, discharge, what passes every curve, and the phreatic line; nothing
/// where the scene asks for still water.
std::string describe_initial_flow(const AssembledCase& assembled);

/// For the journal of a run, one line: the discharge and where water leaves, or that none flows; "" where the
/// scene asks for still water.
std::string summarise_initial_flow(const AssembledCase& assembled);

} // namespace quicksand
