// The figures that a scene asks for, drawn from the results of its run.
#pragma once

#include "io/pictures/line_plot.hpp"
#include "io/pictures/picture_table.hpp"
#include "io/tables/scene_figures.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// The figures of a scene file, or of the copy of a scene in a results folder. Throws InputError.
std::vector<SceneFigure> figures_of_scene(const std::filesystem::path& scene);

/// A probe's name and its rows.
struct FigureProbe {
    std::string name;
    PictureTable table;
};

/// The curves of the probes over time, for excess pore pressure with their initial vertical effective
/// stresses, which it reaches where ru = 1. None where the tables have no values.
std::optional<LinePlot> history_figure(const SceneFigure& figure, const std::vector<FigureProbe>& probes);

/// The quantity along the profile, one curve a time, those nearest to the times of the figure.
std::optional<LinePlot> isochrone_figure(const SceneFigure& figure, const FigureProbe& profile);

/// Draw all into `folder`; the files made. `notify` is told of figures that the results cannot give. Throws
/// InputError and FileError.
std::vector<std::filesystem::path> draw_figures(const std::filesystem::path& results,
                                                const std::vector<SceneFigure>& figures,
                                                const std::filesystem::path& folder,
                                                const std::function<void(const std::string&)>& notify);

} // namespace quicksand
