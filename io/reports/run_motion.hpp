// The motion of the base that a run was given.
#pragma once

#include "io/pictures/picture_gnuplot.hpp"
#include "solver/problem/base_motion.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace quicksand {

struct RunMotion {
    SampledMotion motion;                           // empty without shaking
    std::string origin;                             // where it was read from
    std::vector<std::vector<std::string>> measures; // a table: names and values
};

/// The motion of the scene that was run, where its file still stands as it was; else, told to `notify`, the
/// base acceleration of history.csv. A sine is taken at its resolving step. Throws FileError.
RunMotion motion_of_run(const std::filesystem::path& results,
                        const std::function<void(const std::string&)>& notify);

/// Histories and 5 %-damped spectra, for files in `folder`.
std::vector<Drawing> motion_drawings(const RunMotion& motion, const std::filesystem::path& folder);

} // namespace quicksand
