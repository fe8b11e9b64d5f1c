// How far the probes of one run are from those of another.
#pragma once

#include <filesystem>

namespace quicksand {

/// Largest over the probes, their excess pore pressures and displacements: the root of the mean square
/// difference over the range of the reference [-]. Both are results folders of the same scene with the same
/// probe times. Profiles are left out, and quantities that hardly change: by less than 1 % of what the same
/// quantity does at the probe where it changes most. Throws FileError.
double history_error(const std::filesystem::path& results, const std::filesystem::path& reference);

} // namespace quicksand
