#include "io/reports/motion_figures.hpp"

#include "io/pictures/picture_ticks.hpp"
#include "solver/base/conventions.hpp"
#include "solver/problem/motion_processing.hpp"

#include <algorithm>
#include <functional>

namespace quicksand {

namespace {

/// What a curve takes out of a motion: its x and its y, in SI.
struct Coordinates {
    std::vector<double> x, y;
};

using Take = std::function<Coordinates(const NamedMotion&)>;

/// Curves in SI; a `unit` of "g" shows accelerations in it.
PlotPanel panel_of(const std::string& x_label, const std::string& label, const std::string& unit,
                   const std::vector<NamedMotion>& motions, const Take& take)
{
    std::vector<Coordinates> taken;
    double magnitude = 0.0;
    for (const NamedMotion& motion : motions) {
        taken.push_back(take(motion));
        magnitude = std::max(magnitude, largest_of(taken.back().y));
    }
    const DisplayUnit shown =
        unit == "g" ? DisplayUnit{standard_gravity, "g"} : display_unit(unit, magnitude);
    PlotPanel panel{x_label, label_with_unit(label, shown), {}};
    for (std::size_t k = motions.size(); k-- > 0;) // the first is drawn last
        panel.curves.push_back({motions[k].name, curve_colour(k, motions.size()), taken[k].x,
                                scaled(taken[k].y, shown), k == 0 ? CurveStyle::line : CurveStyle::dashed});
    return panel;
}

Coordinates over_time(const SampledMotion& motion, std::vector<double> values)
{
    Coordinates coordinates{{}, std::move(values)};
    for (std::size_t k = 0; k < coordinates.y.size(); ++k)
        coordinates.x.push_back(motion.interval * static_cast<double>(k));
    return coordinates;
}

template <class Value>
Coordinates over_period(const NamedMotion& motion, Value&& value)
{
    Coordinates coordinates;
    for (const OscillatorPeaks& peaks : motion.spectrum) {
        coordinates.x.push_back(peaks.period);
        coordinates.y.push_back(value(peaks));
    }
    return coordinates;
}

} // namespace

LinePlot motion_histories_plot(const std::string& title, const std::string& note,
                               const std::vector<NamedMotion>& motions)
{
    constexpr const char* time = "Time [s]";
    return {title,
            note,
            {panel_of(time, "Acceleration", "g", motions,
                      [](const NamedMotion& m) { return over_time(m.motion, m.motion.accelerations); }),
             panel_of(
                 time, "Velocity", "m/s", motions,
                 [](const NamedMotion& m) { return over_time(m.motion, histories_of(m.motion).velocities); }),
             panel_of(time, "Displacement", "m", motions, [](const NamedMotion& m) {
                 return over_time(m.motion, histories_of(m.motion).displacements);
             })}};
}

LinePlot motion_spectra_plot(const std::string& title, const std::string& note,
                             const std::vector<NamedMotion>& motions)
{
    constexpr const char* period = "Period [s]";
    const auto of_acceleration = [](const OscillatorPeaks& peaks) { return peaks.pseudo_acceleration(); };
    const auto of_velocity = [](const OscillatorPeaks& peaks) { return peaks.pseudo_velocity(); };
    const auto of_displacement = [](const OscillatorPeaks& peaks) { return peaks.displacement; };
    LinePlot plot{title,
                  note,
                  {panel_of(period, "Pseudo-acceleration", "g", motions,
                            [&](const NamedMotion& m) { return over_period(m, of_acceleration); }),
                   panel_of(period, "Pseudo-velocity", "m/s", motions,
                            [&](const NamedMotion& m) { return over_period(m, of_velocity); }),
                   panel_of(period, "Displacement", "m", motions,
                            [&](const NamedMotion& m) { return over_period(m, of_displacement); })}};
    for (PlotPanel& panel : plot.panels) panel.x_scale = AxisScale::logarithmic;
    return plot;
}

} // namespace quicksand
