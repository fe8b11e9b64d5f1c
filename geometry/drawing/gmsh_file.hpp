// Reading .geo, .geo_unrolled and .msh (2.2 and 4.1) files through gmsh.
//
// gmsh runs in a child process, the program quicksand-gmsh: a file that crashes, hangs or aborts gmsh comes
// back as an InputError, and no other command pays for loading the library.
#pragma once

#include "geometry/section/section.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace quicksand {

/// Names a folder that keeps what gmsh made of drawings, for other runs of the same drawing. `sweep` sets it
/// for its runs.
constexpr const char* drawing_store_variable = "QUICKSAND_DRAWINGS";

struct GmshRequest {
    std::filesystem::path file;
    std::map<std::string, double> parameters; // values that replace those of the .geo file's DefineConstant
    std::optional<double> quad_size; // edge length of a recombined quad mesh [m]; none: outlines only
    double curve_tolerance = 0.0;    // greatest distance of a curved line from its chords [m]
    double time_limit = 120.0;       // wall time before gmsh is stopped [s]
};

/// Throws InputError with gmsh's own file and line, or with what is missing in the model; FileError where the
/// helper program or its scratch file fails.
Section read_gmsh_file(const GmshRequest& request);

/// The helper program: beside the running executable or in the installed libexec folder. Throws FileError.
std::filesystem::path find_gmsh_helper();

} // namespace quicksand
