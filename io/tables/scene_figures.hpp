// The figures that a scene asks for.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_check.hpp"
#include "io/tables/scene.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// A quantity of probes: its column in their files and how figures name it.
struct ProbeQuantity {
    std::string_view name;   // in the scene
    std::string_view column; // in probes/*.csv
    double sign;             // of the column in the figure
    std::string_view label;
    std::string_view unit; // SI
    int length_power;      // a figure in full scale is larger by scale to this power
};

inline constexpr std::array<ProbeQuantity, 13> probe_quantities = {{
    {"excess_pore_pressure", "excess_pore_pressure_Pa", 1.0, "Excess pore pressure", "Pa", 0},
    {"pore_pressure", "pore_pressure_Pa", 1.0, "Pore pressure", "Pa", 0},
    {"ru", "ru", 1.0, "Excess pore pressure ratio ru", "", 0},
    {"mean_effective_stress", "mean_effective_stress_Pa", 1.0, "Mean effective stress", "Pa", 0},
    {"vertical_effective_stress", "vertical_effective_stress_Pa", 1.0, "Vertical effective stress", "Pa", 0},
    {"shear_stress_xy", "shear_stress_xy_Pa", 1.0, "Shear stress", "Pa", 0},
    {"shear_strain_xy", "shear_strain_xy", 1.0, "Shear strain", "%", 0},
    {"horizontal_displacement", "ux_m", 1.0, "Horizontal displacement", "m", 1},
    {"vertical_displacement", "uy_m", 1.0, "Vertical displacement", "m", 1},
    {"settlement", "uy_m", -1.0, "Settlement", "m", 1},
    {"horizontal_velocity", "vx_m_s", 1.0, "Horizontal velocity", "m/s", 0},
    {"horizontal_acceleration", "ax_m_s2", 1.0, "Horizontal acceleration", "m/s²", -1},
    {"vertical_acceleration", "ay_m_s2", 1.0, "Vertical acceleration", "m/s²", -1},
}};

enum class FigureKind { history, isochrones, field };

struct SceneFigure {
    std::string name;
    FigureKind kind = FigureKind::history;
    std::string title;
    std::vector<std::string> probes;
    const ProbeQuantity* quantity = nullptr; // of the probes
    double scale = 1.0;                      // full scale over the model's [-]
    std::vector<double> times;               // of isochrones; empty: even ones [s]
    std::string field;
    std::optional<double> time; // of the field; none: the last frame [s]
    std::vector<double> range;  // of its colours: low and high, or nothing
};

/// The figures in the order of the scene. What is wrong with them is added to `findings`.
std::vector<SceneFigure> read_figures(const SceneValues& values, Diagnostics& findings);

} // namespace quicksand
