// The pictures of a results folder: which there are by default, and the one a user asks for.
#pragma once

#include "io/pictures/picture_gnuplot.hpp"
#include "io/pictures/picture_ticks.hpp"
#include "io/results/result_reader.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

struct PictureRequest {
    std::filesystem::path output;   // a .png file or a folder; empty: RESULTS/pictures
    std::string field;              // empty: the default set and the plots of probes and history
    std::optional<double> time;     // the nearest frame is drawn [s]; none: the last one
    std::optional<PlotRange> range; // of the colours, in the field's SI unit; none: automatic
    double exaggeration = 1.0;      // of the displacements drawn [-]
    std::string title;              // empty: that of the scene
    std::function<void(const std::string&)> notify; // told what differs from the request; may be empty
};

/// The title in the scene's copy; "" where there is none. Throws FileError.
std::string scene_title(const std::filesystem::path& results);

/// "0:9e3" as an interval. Throws InputError.
PlotRange parse_range(std::string_view text);

/// Fields of a frame that can be drawn: scalars, and vectors by their magnitude.
std::vector<std::string> drawable_fields(const ParticleFrame& frame);

/// What is asked for, with its folder made. By default, at the last frame: excess pore pressure (in a dry
/// scene mean effective stress), displacement and shear strain, and the plots of probes and history.
/// Throws InputError for a field that is not there or a request that makes no sense, and FileError.
std::vector<Drawing> result_drawings(const std::filesystem::path& results, const PictureRequest& request);

/// Draw it; the files made. Throws as result_drawings() and draw_pictures() do.
std::vector<std::filesystem::path> draw_results(const std::filesystem::path& results,
                                                const PictureRequest& request);

} // namespace quicksand
