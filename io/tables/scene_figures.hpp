// The figures that a scene asks for.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_check.hpp"
#include "io/tables/scene.hpp"
#include "solver/measure/quantities.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// What a figure of probes can show: a number of a quantity at probes.
struct FigureQuantity {
    std::string name;                   // in the scene
    const Quantity* quantity = nullptr; // of the table
    std::size_t component = 0;
    double sign = 1.0; // of the number in the figure [-]
    std::string label;

    std::string column() const { return probe_column(*quantity, component); } // in probes/*.csv
};

/// All of them: scalars by their names, horizontal and vertical parts of vectors, the settlement.
const std::vector<FigureQuantity>& figure_quantities();

/// None where there is no such quantity.
const FigureQuantity* find_figure_quantity(std::string_view name);

enum class FigureKind { history, isochrones, field };

struct SceneFigure {
    std::string name;
    FigureKind kind = FigureKind::history;
    std::string title;
    std::vector<std::string> probes;
    const FigureQuantity* quantity = nullptr; // of the probes
    double scale = 1.0;                       // full scale over the model's [-]
    std::vector<double> times;                // of isochrones; empty: even ones [s]
    std::string field;
    std::optional<double> time; // of the field; none: the last frame [s]
    std::vector<double> range;  // of its colours: low and high, or nothing
};

/// The figures in the order of the scene. What is wrong with them is added to `findings`.
std::vector<SceneFigure> read_figures(const SceneValues& values, Diagnostics& findings);

} // namespace quicksand
