// What can be wrong between a scene and its drawing before a particle exists.
#pragma once

#include "io/assembly/assembled_case.hpp"

#include <vector>

namespace quicksand {

void throw_errors(const Diagnostics& findings, const Scene& scene);

/// Read the drawing of a scene. Throws InputError with what gmsh finds in it.
Section read_section(const Scene& scene);

/// The case of a scene with its problem, as far as the scene, the section as drawn and the soil that is
/// present tell it. Throws InputError with all errors at once.
AssembledCase begin_case(Scene scene, Diagnostics warnings, Section present, const Section& drawn);

/// Throws InputError where a stage cannot begin for what its scene and the drawing are, before hours of
/// earlier stages.
void require_sound(const std::vector<SceneReading>& stages);

} // namespace quicksand
