#include "io/element/element_panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

using Coordinate = double (*)(const ElementPoint&);

constexpr Colour guide_grey{0.45, 0.45, 0.45};
constexpr std::size_t most_curves = 10; // that can be told apart in a panel

double gamma_percent(const ElementPoint& point)
{
    return 100.0 * point.gamma;
}
double vertical_strain_percent(const ElementPoint& point)
{
    return 100.0 * point.strain_y;
}
double volumetric_strain_percent(const ElementPoint& point)
{
    return 100.0 * point.volumetric_strain();
}
double tau_kpa(const ElementPoint& point)
{
    return 1e-3 * point.tau;
}
double sigma_v_kpa(const ElementPoint& point)
{
    return 1e-3 * point.sigma_y;
}
double sigma_h_kpa(const ElementPoint& point)
{
    return 1e-3 * point.sigma_x;
}
double s_kpa(const ElementPoint& point)
{
    return 0.5e-3 * (point.sigma_x + point.sigma_y);
}
double t_kpa(const ElementPoint& point)
{
    return 0.5e-3 * (point.sigma_y - point.sigma_x);
}
double deviator_kpa(const ElementPoint& point)
{
    return 1e-3 * (point.sigma_y - point.sigma_x);
}
double stress_ratio(const ElementPoint& point)
{
    return point.sigma_x / point.sigma_y;
}
double ru(const ElementPoint& point)
{
    return point.ru;
}
double cycle(const ElementPoint& point)
{
    return point.cycle;
}

PlotCurve path_curve(const ElementRun& run, const std::string& name, const Colour& colour, Coordinate x,
                     Coordinate y)
{
    PlotCurve curve{name, colour, {}, {}};
    for (const ElementPoint& point : run.result.path) {
        curve.x.push_back(x(point));
        curve.y.push_back(y(point));
    }
    return curve;
}

/// The run whose liquefaction comes nearest to 15 cycles, as laboratories show; else the longest.
const ElementRun& typical(const std::vector<const ElementRun*>& runs, const ElementOutcome& outcome)
{
    const auto distance = [&](const ElementRun* run) {
        const auto cycles = cycles_to_liquefaction(outcome, *run);
        return cycles ? std::abs(std::log((*cycles + 0.25) / 15.0)) : 1e3;
    };
    return **std::min_element(runs.begin(), runs.end(), [&](const ElementRun* a, const ElementRun* b) {
        return distance(a) < distance(b);
    });
}

std::vector<const ElementRun*> runs_of(const ElementOutcome& outcome, std::size_t specimen)
{
    std::vector<const ElementRun*> runs;
    for (const ElementRun& run : outcome.runs) {
        if (run.specimen == specimen) runs.push_back(&run);
    }
    return runs;
}

/// What is drawn over time or strain: all runs of one specimen, or one typical run of each of several.
std::vector<const ElementRun*> shown_runs(const ElementOutcome& outcome)
{
    std::vector<const ElementRun*> shown;
    const std::size_t count = outcome.test.specimens.size();
    if (count == 1) {
        shown = runs_of(outcome, 0);
    } else {
        for (std::size_t k = 0; k < count; ++k) shown.push_back(&typical(runs_of(outcome, k), outcome));
    }
    std::vector<const ElementRun*> few;
    const std::size_t stride = (shown.size() + most_curves - 1) / most_curves;
    for (std::size_t k = 0; k < shown.size(); k += stride) few.push_back(shown[k]);
    return few;
}

PlotPanel curves_of(const std::vector<const ElementRun*>& runs, const ElementOutcome& outcome, Coordinate x,
                    Coordinate y)
{
    PlotPanel panel;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        panel.curves.push_back(
            path_curve(*runs[k], run_label(outcome, *runs[k]), curve_colour(k, runs.size()), x, y));
    }
    return panel;
}

PlotPanel labelled(PlotPanel panel, const char* heading, const char* x_label, const char* y_label,
                   KeyPlace key = KeyPlace::upper_left)
{
    panel.heading = heading;
    panel.x_label = x_label;
    panel.y_label = y_label;
    panel.key = key;
    return panel;
}

/// The failure limit of each soil that has one, up and for cyclic tests down [kPa].
void add_failure(const std::vector<const ElementRun*>& runs, const ElementOutcome& outcome, double end,
                 const char* name, bool downward, PlotPanel& panel)
{
    std::vector<double> drawn;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const auto line = failure_line_of(outcome.specimen(*runs[k]).soil.law);
        if (!line || std::find(drawn.begin(), drawn.end(), line->slope) != drawn.end()) continue;
        const double slope = line->slope, at_zero = 1e-3 * line->at_zero;
        const Colour colour = drawn.empty() ? guide_grey : curve_colour(k, runs.size());
        panel.curves.push_back({drawn.empty() ? name : "",
                                colour,
                                {0.0, end},
                                {at_zero, at_zero + slope * end},
                                CurveStyle::dashed});
        if (downward) {
            panel.curves.push_back(
                {"", colour, {0.0, end}, {-at_zero, -at_zero - slope * end}, CurveStyle::dashed});
        }
        drawn.push_back(slope);
    }
}

double largest_x(const PlotPanel& panel)
{
    double largest = 0.0;
    for (const PlotCurve& curve : panel.curves)
        for (const double x : curve.x) largest = std::max(largest, x);
    return largest;
}

/// A level that is asked for, across the panel.
void add_level(double level, PlotPanel& panel)
{
    panel.curves.push_back({"", guide_grey, {0.0, largest_x(panel)}, {level, level}, CurveStyle::dashed});
}

PlotPanel shear_path(const std::vector<const ElementRun*>& runs, const ElementOutcome& outcome, bool cyclic)
{
    PlotPanel panel = labelled(curves_of(runs, outcome, sigma_v_kpa, tau_kpa), "Stress path",
                               "Vertical effective stress σ'v [kPa]", "Shear stress τ [kPa]");
    if (cyclic) panel.curves.front().name.clear(); // it is that of the loops
    double end = largest_x(panel);
    if (cyclic) { // the guides need not go far beyond the loops
        double tau = 0.0;
        for (const double y : panel.curves.front().y) tau = std::max(tau, std::abs(y));
        end = std::min(end, 2.5 * tau);
    }
    add_failure(runs, outcome, end, "failure, τ = sin φf σ'v", cyclic, panel);
    return panel;
}

/// The largest shear strain so far, which grows from cycle to cycle.
PlotPanel strain_panel(const std::vector<const ElementRun*>& shown, const ElementOutcome& outcome)
{
    PlotPanel panel =
        labelled(curves_of(shown, outcome, cycle, gamma_percent), "Shear strain", "Number of cycles N",
                 "Largest shear strain so far [%]", KeyPlace::lower_right);
    for (PlotCurve& curve : panel.curves) {
        double largest = 0.0;
        for (double& gamma : curve.y) {
            largest = std::max(largest, std::abs(gamma));
            gamma = largest > 0.0 ? largest : std::nan("");
        }
    }
    panel.y_scale = AxisScale::logarithmic;
    panel.y_range = PlotRange{0.001, 20.0};
    add_level(3.0, panel);
    return panel;
}

PlotPanel ru_panel(const std::vector<const ElementRun*>& shown, const ElementOutcome& outcome)
{
    PlotPanel panel = labelled(curves_of(shown, outcome, cycle, ru), "Pore pressure", "Number of cycles N",
                               "Excess pore pressure ratio ru", KeyPlace::lower_right);
    add_level(0.95, panel);
    return panel;
}

PlotPanel loops_panel(const ElementRun& run, const ElementOutcome& outcome)
{
    PlotPanel panel = labelled(curves_of({&run}, outcome, gamma_percent, tau_kpa), "", "Shear strain γ [%]",
                               "Shear stress τ [kPa]");
    const auto cycles = cycles_to_liquefaction(outcome, run);
    panel.heading = "Loops: " + run_label(outcome, run) +
                    (cycles ? ", liquefaction at N = " + short_text(cycles, 4) : "");
    panel.curves.front().name.clear();
    return panel;
}

PlotPanel strength_panel(const ElementOutcome& outcome)
{
    PlotPanel panel = labelled({}, "Cyclic strength", "Number of cycles N", "Cyclic stress ratio CSR",
                               KeyPlace::upper_right);
    panel.x_scale = AxisScale::logarithmic;
    const std::size_t count = outcome.test.specimens.size();
    double most = 30.0, largest = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        const std::string& label = outcome.test.specimens[k].label;
        PlotCurve curve{label.empty() ? outcome.test.soil.title : label,
                        curve_colour(k, count),
                        {},
                        {},
                        CurveStyle::line_with_points};
        for (const ElementRun* run : runs_of(outcome, k)) {
            const auto cycles = cycles_to_liquefaction(outcome, *run);
            if (!cycles || *cycles <= 0.0) continue;
            curve.x.push_back(*cycles);
            curve.y.push_back(std::get<StressCycles>(outcome.loading(*run)).csr);
            most = std::max(most, *cycles);
            largest = std::max(largest, curve.y.back());
        }
        if (!curve.x.empty()) panel.curves.push_back(std::move(curve)); // else nothing of it can be drawn
    }
    if (outcome.test.data) {
        bool named = false;
        for (const StrengthDatum& datum : outcome.test.data->points) {
            Colour colour{0.1, 0.1, 0.1};
            for (std::size_t k = 0; k < count; ++k) {
                if (datum.value && *datum.value == outcome.test.specimens[k].value)
                    colour = curve_colour(k, count);
            }
            panel.curves.push_back({named ? "" : outcome.test.data->label,
                                    colour,
                                    {datum.cycles},
                                    {datum.csr},
                                    CurveStyle::points});
            named = true;
            most = std::max(most, datum.cycles);
            largest = std::max(largest, datum.csr);
        }
    }
    panel.x_range = PlotRange{0.4, 1.3 * most};
    if (largest == 0.0) largest = std::get<StressCycles>(outcome.test.loadings.back()).csr; // no liquefaction
    panel.y_range = PlotRange{0.0, 1.15 * largest};
    return panel;
}

std::vector<NamedPanel> stress_cycle_panels(const ElementOutcome& outcome)
{
    const std::vector<const ElementRun*> shown = shown_runs(outcome);
    const std::vector<const ElementRun*> one = {&typical(shown, outcome)};
    return {{"loops", loops_panel(*one.front(), outcome)},
            {"stress_path", shear_path(one, outcome, true)},
            {"ru", ru_panel(shown, outcome)},
            {"strain", strain_panel(shown, outcome)},
            {"csr_n", strength_panel(outcome)}};
}

PlotPanel summary_panel(const ElementOutcome& outcome, double CycleSummary::*member, double factor)
{
    PlotPanel panel;
    const std::vector<const ElementRun*> shown = shown_runs(outcome);
    for (std::size_t k = 0; k < shown.size(); ++k) {
        PlotCurve curve{run_label(outcome, *shown[k]),
                        curve_colour(k, shown.size()),
                        {},
                        {},
                        CurveStyle::line_with_points};
        for (const CycleSummary& summary : summarize_cycles(shown[k]->result.path)) {
            curve.x.push_back(summary.cycle);
            curve.y.push_back(factor * (summary.*member));
        }
        panel.curves.push_back(std::move(curve));
    }
    return panel;
}

std::vector<NamedPanel> strain_cycle_panels(const ElementOutcome& outcome)
{
    const std::vector<const ElementRun*> shown = shown_runs(outcome);
    const std::vector<const ElementRun*> one = {shown[shown.size() / 2]};
    return {
        {"loops", loops_panel(*one.front(), outcome)},
        {"stress_path", shear_path(one, outcome, true)},
        {"ru", ru_panel(shown, outcome)},
        {"modulus", labelled(summary_panel(outcome, &CycleSummary::secant_modulus, 1e-6), "Secant modulus",
                             "Cycle", "Secant shear modulus [MPa]", KeyPlace::upper_right)},
        {"damping", labelled(summary_panel(outcome, &CycleSummary::damping_ratio, 100.0), "Damping", "Cycle",
                             "Damping ratio [%]", KeyPlace::upper_right)}};
}

std::vector<NamedPanel> shear_panels(const ElementOutcome& outcome, Drainage drainage)
{
    const std::vector<const ElementRun*> shown = shown_runs(outcome);
    std::vector<NamedPanel> panels = {
        {"stress_strain", labelled(curves_of(shown, outcome, gamma_percent, tau_kpa), "Stress and strain",
                                   "Shear strain γ [%]", "Shear stress τ [kPa]")}};
    if (drainage == Drainage::undrained) {
        panels.push_back({"stress_path", shear_path(shown, outcome, false)});
        panels.push_back({"ru", labelled(curves_of(shown, outcome, gamma_percent, ru), "Pore pressure",
                                         "Shear strain γ [%]", "Excess pore pressure ratio ru")});
        return panels;
    }
    panels.push_back({"volume", labelled(curves_of(shown, outcome, gamma_percent, volumetric_strain_percent),
                                         "Change of volume", "Shear strain γ [%]",
                                         "Volumetric strain, contraction positive [%]")});
    panels.push_back(
        {"lateral_stress",
         labelled(curves_of(shown, outcome, gamma_percent, sigma_h_kpa), "Lateral stress",
                  "Shear strain γ [%]", "Horizontal effective stress σ'h [kPa]", KeyPlace::lower_right)});
    return panels;
}

std::vector<NamedPanel> biaxial_panels(const ElementOutcome& outcome, Drainage drainage)
{
    const std::vector<const ElementRun*> shown = shown_runs(outcome);
    PlotPanel path = labelled(curves_of(shown, outcome, s_kpa, t_kpa), "Stress path",
                              "s' = (σ'v + σ'h)/2 [kPa]", "t = (σ'v − σ'h)/2 [kPa]");
    add_failure(shown, outcome, largest_x(path), "failure, t = sin φf s'", false, path);
    std::vector<NamedPanel> panels = {
        {"stress_strain",
         labelled(curves_of(shown, outcome, vertical_strain_percent, deviator_kpa), "Stress and strain",
                  "Vertical strain [%]", "σ'v − σ'h [kPa]", KeyPlace::lower_right)},
        {"stress_path", std::move(path)}};
    if (drainage == Drainage::undrained) {
        panels.push_back(
            {"ru", labelled(curves_of(shown, outcome, vertical_strain_percent, ru), "Pore pressure",
                            "Vertical strain [%]", "Excess pore pressure over σ'v0")});
    } else {
        panels.push_back(
            {"volume", labelled(curves_of(shown, outcome, vertical_strain_percent, volumetric_strain_percent),
                                "Change of volume", "Vertical strain [%]",
                                "Volumetric strain, contraction positive [%]")});
    }
    return panels;
}

std::vector<NamedPanel> compression_panels(const ElementOutcome& outcome, bool oedometer)
{
    const std::vector<const ElementRun*> shown = shown_runs(outcome);
    PlotPanel volume = labelled(
        curves_of(shown, outcome, oedometer ? sigma_v_kpa : s_kpa, volumetric_strain_percent), "Compression",
        oedometer ? "Vertical effective stress σ'v [kPa]" : "Mean effective stress s' [kPa]",
        "Volumetric strain, contraction positive [%]");
    volume.x_scale = AxisScale::logarithmic;
    volume.y_scale = AxisScale::downward;
    volume.key = KeyPlace::upper_right;
    if (!oedometer) return {{"compression", std::move(volume)}};
    return {
        {"compression", std::move(volume)},
        {"lateral_stress",
         labelled(curves_of(shown, outcome, sigma_v_kpa, sigma_h_kpa), "Lateral stress",
                  "Vertical effective stress σ'v [kPa]", "Horizontal effective stress σ'h [kPa]")},
        {"stress_ratio", labelled(curves_of(shown, outcome, sigma_v_kpa, stress_ratio), "Stress ratio",
                                  "Vertical effective stress σ'v [kPa]", "σ'h/σ'v", KeyPlace::upper_right)}};
}

} // namespace

std::vector<NamedPanel> element_panels(const ElementOutcome& outcome)
{
    const ElementLoading& first = outcome.test.loadings.front();
    if (std::holds_alternative<StressCycles>(first)) return stress_cycle_panels(outcome);
    if (std::holds_alternative<StrainCycles>(first)) return strain_cycle_panels(outcome);
    if (const auto* shear = std::get_if<MonotonicShear>(&first))
        return shear_panels(outcome, shear->drainage);
    if (const auto* biaxial = std::get_if<BiaxialCompression>(&first))
        return biaxial_panels(outcome, biaxial->drainage);
    return compression_panels(outcome, !std::holds_alternative<IsotropicLoading>(first));
}

} // namespace quicksand
