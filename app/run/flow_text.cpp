#include "app/run/flow_text.hpp"

#include "app/run/number_format.hpp"
#include "io/keys/scene_units.hpp"

#include <fmt/format.h>

#include <cmath>

namespace quicksand {

namespace {

constexpr int line_points = 9; // of the phreatic line that are written [-]

std::string text(const Vector2& point)
{
    return fmt::format("[{}, {}]", coordinate_text(point.x()), coordinate_text(point.y()));
}

std::string curve_name(const FaceFlow& face)
{
    return face.name.empty() ? "edges without a name" : face.name;
}

/// Where the water of a curve stands and leaves.
std::string describe_face(const FaceFlow& face)
{
    std::string line = fmt::format("{} {} m3/s per m", face.inflow > 0.0 ? "takes in" : "gives off",
                                   short_number(std::abs(face.inflow), 4));
    if (face.entry) line += ", under water up to " + text(*face.entry);
    if (face.exit) line += ", water leaves into the air up to " + text(*face.exit);
    return line;
}

/// The phreatic line in the soil at equal distances.
std::string describe_line(const AssembledCase& assembled, const FlowField& field)
{
    std::string line;
    const double left = assembled.section.lower.x(), right = assembled.section.upper.x();
    for (int k = 0; k < line_points; ++k) {
        const double x = left + (right - left) * k / (line_points - 1);
        const auto surface = field.surface(x);
        line +=
            (line.empty() ? "" : ", ") + (surface ? text({x, *surface}) : "dry at x = " + coordinate_text(x));
    }
    return line;
}

/// What the search for the line has cost, and what has flowed.
std::string describe_search(const InitialFlow& flow)
{
    std::string text =
        fmt::format("  {} triangles with edges up to {} m; the phreatic line is found in {} iterations",
                    grouped(static_cast<long long>(flow.field.mesh().triangles.size())),
                    short_number(flow.triangle_size), flow.iterations);
    if (!flow.flowed)
        return text + fmt::format(", the flow balanced to {} of it\n", short_number(flow.imbalance, 2));
    const FlowedWater& flowed = *flow.flowed;
    text += fmt::format(", the water balanced to {} of what has passed the faces\n",
                        short_number(flowed.imbalance, 2));
    return text + fmt::format("  the soil {} {} m3 per m of water in that time\n",
                              flowed.stored > 0.0 ? "takes up" : "loses",
                              short_number(std::abs(flowed.stored), 4));
}

} // namespace

std::string describe_initial_flow(const AssembledCase& assembled)
{
    if (!assembled.scene.starts_seeping) return "";
    const bool in_time = assembled.initial_flow && assembled.initial_flow->flowed;
    std::string text = in_time
                           ? "Flow after " + duration_text(assembled.initial_flow->flowed->duration) + '\n'
                           : "Steady flow at the start\n";
    if (!assembled.initial_flow)
        return text + fmt::format("  none: no water stands above the level, {} m\n",
                                  short_number(assembled.problem.water->level));
    const InitialFlow& flow = *assembled.initial_flow;
    text += describe_search(flow);
    text += fmt::format("  discharge {} m3/s per m, {} m3 a day\n", short_number(flow.discharge, 4),
                        short_number(86400.0 * flow.discharge, 4));
    for (const FaceFlow& face : flow.faces)
        text += fmt::format("  {:<16}{}\n", curve_name(face), describe_face(face));
    return text + "  phreatic line   " + describe_line(assembled, flow.field) + '\n';
}

std::string summarise_initial_flow(const AssembledCase& assembled)
{
    if (!assembled.scene.starts_seeping) return "";
    if (!assembled.initial_flow)
        return fmt::format("The water does not flow at the start: none stands above the level, {} m",
                           short_number(assembled.problem.water->level));
    const InitialFlow& flow = *assembled.initial_flow;
    std::string line = flow.flowed ? fmt::format("The water has flowed for {}: the soil {} {} m3 per m",
                                                 duration_text(flow.flowed->duration),
                                                 flow.flowed->stored > 0.0 ? "has taken up" : "has lost",
                                                 short_number(std::abs(flow.flowed->stored), 4))
                                   : fmt::format("The water flows steadily at the start, {} m3/s per m",
                                                 short_number(flow.discharge, 4));
    for (const FaceFlow& face : flow.faces)
        if (face.exit) line += fmt::format("; it leaves {} up to {}", curve_name(face), text(*face.exit));
    return line;
}

} // namespace quicksand
