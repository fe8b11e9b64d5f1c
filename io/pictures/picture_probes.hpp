// The plots of a run's probes and of its history.
#pragma once

#include "io/pictures/line_plot.hpp"
#include "io/pictures/picture_table.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// A column and what its curve is called where a panel has several.
struct PanelColumn {
    std::string column; // with its unit, as in the CSV
    std::string name;
};

/// What goes together into one pair of axes.
struct PanelPlan {
    std::string label;
    std::string unit; // SI unit of the columns
    std::vector<PanelColumn> columns;
};

/// The panels of a probe's plot, and of the history's.
std::vector<PanelPlan> probe_plan();
std::vector<PanelPlan> history_plan();

/// Pressures, displacement, velocity and acceleration over time; a profile becomes isochrones, the values
/// over height at about eight times. None where the table has no values.
std::optional<LinePlot> probe_plot(const PictureTable& table, const std::string& name);

/// Excess pore pressure of all material probes in one plot; none where there are fewer than two.
struct ProbeTable {
    std::string name;
    PictureTable table;
};
/// Those of a folder's CSV files, in the order of their names. Throws FileError.
std::vector<ProbeTable> read_probes(const std::filesystem::path& folder);
std::optional<LinePlot> comparison_plot(const std::vector<ProbeTable>& probes);

/// Crest settlement, kinetic energy, largest excess pore pressure and base motion over time.
std::optional<LinePlot> history_plot(const PictureTable& table);

/// The plots of probes/*.csv and history.csv of the results, as far as they are there, for files in `folder`.
/// Throws FileError.
std::vector<Drawing> probe_drawings(const std::filesystem::path& results,
                                    const std::filesystem::path& folder);

} // namespace quicksand
