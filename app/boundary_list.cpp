#include "app/number_format.hpp"
#include "app/plan.hpp"
#include "solver/surface_loads.hpp"

#include <fmt/format.h>

namespace quicksand {

namespace {

const char* name_of(SoilCondition soil)
{
    switch (soil) {
    case SoilCondition::free:
        return "free";
    case SoilCondition::fixed:
        return "fixed";
    case SoilCondition::roller:
        return "roller";
    case SoilCondition::tied:
        return "tied";
    }
    return "";
}

const char* name_of(WaterCondition water)
{
    return water == WaterCondition::drained ? "drained" : "impervious";
}

double length_of(const Boundary& boundary)
{
    double length = 0.0;
    for (const Segment& segment : boundary.segments) length += (segment.end - segment.start).norm();
    return length;
}

std::string describe_history(const History& history)
{
    std::string text;
    if (history.ramp_time > 0.0) text += fmt::format(", rising over {} s", short_number(history.ramp_time));
    if (const auto* sine = std::get_if<SineHistory>(&history.shape))
        text += fmt::format(", a sine wave of {} Hz", short_number(sine->frequency));
    if (const auto* table = std::get_if<SampledHistory>(&history.shape))
        text += fmt::format(", times a table of {} factors, up to {}", table->times.size(),
                            short_number(peak_value(history)));
    return text;
}

} // namespace

std::string describe_boundaries(const AssembledCase& assembled)
{
    const Problem& problem = assembled.problem;
    std::string text = "Boundaries\n";
    for (const Boundary& boundary : problem.boundaries) {
        text += fmt::format("  {:<16}{:.4g} m, {}{}{}\n", boundary.name, length_of(boundary),
                            name_of(boundary.soil), problem.water ? ", water " : "",
                            problem.water ? name_of(boundary.water) : "");
        if (!boundary.load) continue;
        const Vector2 force = full_load(problem, assembled.state, boundary);
        text += fmt::format("  {:<16}load ({}, {}) N per metre of thickness in all{}\n", "",
                            short_number(force.x(), 6), short_number(force.y(), 6),
                            describe_history(boundary.load->history));
    }
    return text;
}

} // namespace quicksand
