// The difference of two runs of one drawing, drawn as a field.
#pragma once

#include "io/pictures/picture_gnuplot.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// Two results folders, the fields of the second less those of the first.
struct FrameDifference {
    std::filesystem::path first, second;
    std::string names;               // "second less first", under the heading
    std::vector<std::string> fields; // as `picture` names them
    std::optional<double> time = {}; // the nearest frames [s]; none: the last ones
};

/// One picture a field that both frames have, over the soil as the first run has moved it, for files in
/// `folder`. Particles belong together by their lasting numbers. Empty, with the reason in `why`, where the
/// particles did not start at the same places. Throws InputError where the only field is none or there
/// are no frames, and FileError.
std::vector<Drawing> difference_drawings(const FrameDifference& difference,
                                         const std::filesystem::path& folder, std::string& why);

} // namespace quicksand
