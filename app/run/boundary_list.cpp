#include "app/run/number_format.hpp"
#include "app/run/plan.hpp"
#include "io/assembly/face_water.hpp"
#include "io/faces/boundary_kinds.hpp"
#include "io/tables/scene_boundaries.hpp"
#include "solver/base/overload.hpp"
#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/boundaries/free_field.hpp"
#include "solver/boundaries/surface_loads.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "solver/run/patch_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <set>

namespace quicksand {

namespace {

std::string_view water_name(const WaterCondition& water)
{
    return std::visit(Overload{[](const Drained&) { return "drained"; },
                               [](const Impervious&) { return "impervious"; },
                               [](const PrescribedWater&) { return "with a prescribed pressure"; }},
                      water);
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
    const auto* table = std::get_if<SampledHistory>(&history.shape);
    if (table != nullptr &&
        (varies(history) || history_value(history, 0.0) != 1.0)) // one that ended at 1 is over
        text += fmt::format(", times a table of {} factors, up to {}", table->times.size(),
                            short_number(peak_value(history)));
    return text;
}

struct Range {
    double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();

    void include(double value)
    {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    /// One number where both ends look the same.
    std::string text() const
    {
        const std::string lower = short_number(least), upper = short_number(most);
        return lower == upper ? lower : lower + " to " + upper;
    }
};

/// Impedances along a curve, beside soil of one material [Pa s/m].
struct ImpedanceRange {
    Range normal, shear;

    std::string text() const
    {
        return fmt::format("rho Vp {}, rho Vs {} Pa s/m", normal.text(), shear.text());
    }
};

/// The rock's impedances, or those of every soil beside the curve in its initial state.
std::string describe_impedance(const AssembledCase& assembled, const Boundary& boundary)
{
    const Problem& problem = assembled.problem;
    const Particles& particles = assembled.state.particles;
    std::map<std::int32_t, ImpedanceRange> of_material;
    ParticlePlaces places;
    for (const BoundaryPiece& piece : boundary.pieces) {
        const std::size_t p = places.find(particles, piece.identifier);
        const Impedance beyond = impedance(problem, boundary, particles, p);
        ImpedanceRange& range = of_material[particles.material[p]];
        range.normal.include(beyond.normal);
        range.shear.include(beyond.shear);
    }
    std::string text;
    for (const auto& [material, range] : of_material) {
        if (impedance_beyond(boundary.soil)) return "rock beyond: " + range.text();
        text += fmt::format("{}as {} goes on beyond: {}", text.empty() ? "" : "; ",
                            problem.materials[static_cast<std::size_t>(material)].name, range.text());
    }
    return text;
}

// What `check` says of a kind of boundary, beside its word; "" where that is all.
template <SoilKind Kind>
std::string describe(const Kind&, const AssembledCase&, const Boundary&)
{
    return "";
}

std::string describe(const FreeFace& face, const AssembledCase& assembled, const Boundary& boundary)
{
    if (!face.load) return "";
    const Vector2 force = full_load(assembled.problem, assembled.state, boundary);
    return fmt::format("load ({}, {}) N per metre of thickness in all{}", short_number(force.x(), 6),
                       short_number(force.y(), 6), describe_history(face.load->history));
}

std::string describe(const MovingWall& wall, const AssembledCase&, const Boundary&)
{
    const WallMotion& motion = wall.motion;
    const bool velocity = motion.quantity == MotionQuantity::velocity;
    const char* unit = velocity ? "m/s" : "m";
    const std::string value =
        motion.grip == WallGrip::rough
            ? fmt::format("({}, {}) {}", short_number(motion.value.x(), 6), short_number(motion.value.y(), 6),
                          unit)
            : fmt::format("{} {} into the soil, free along the curve", short_number(motion.inward, 6), unit);
    return fmt::format("{} {}{}", velocity ? "velocity" : "displacement", value,
                       describe_history(motion.history));
}

std::string describe(const ViscousFace&, const AssembledCase& assembled, const Boundary& boundary)
{
    return describe_impedance(assembled, boundary);
}

std::string describe(const FreeFieldSide&, const AssembledCase& assembled, const Boundary& boundary)
{
    std::set<std::size_t> fields;
    for (const Segment& segment : boundary.segments)
        fields.insert(free_field_beyond(assembled.problem, segment).value());
    std::string text;
    for (const std::size_t k : fields)
        text += fmt::format("a column of {} material points of its own at x = {} m; ",
                            assembled.state.free_fields[k].column.particles.size(),
                            short_number(assembled.problem.free_fields[k].x, 6));
    return text + describe_impedance(assembled, boundary);
}

/// The excess pressure of the water beyond, with the history that it has.
std::string describe_outer_water(const Problem& problem, const Boundary& boundary)
{
    Range excess; // [Pa]
    for (const Segment& segment : boundary.segments) {
        for (const Vector2& point : {segment.start, segment.end})
            excess.include(outer_excess_pressure(problem, boundary, point));
    }
    const auto* given = std::get_if<PrescribedWater>(&boundary.water);
    return fmt::format("excess pore pressure {} to {} Pa{}", short_number(excess.least, 6),
                       short_number(excess.most, 6), given ? describe_history(given->history) : "");
}

std::string describe_heads(const std::pair<double, double>& heads)
{
    Range range;
    range.include(heads.first);
    range.include(heads.second);
    return fmt::format("below the phreatic line, so with its head, {} m", range.text());
}

/// What the curve leaves unbalanced of pressures that it should bear.
std::string describe_patch_test(const PatchTest& test)
{
    const auto percent = [](double fraction) {
        return fraction < 1e-8 ? std::string("0") : short_number(100.0 * fraction, 2);
    };
    return fmt::format("patch tests: {} % of a constant pressure left unbalanced, {} % of a geostatic one",
                       percent(test.constant_pressure), percent(test.geostatic));
}

} // namespace

void refuse_failed_patches(const AssembledCase& assembled, const std::vector<PatchTest>& tests)
{
    constexpr double most = 0.02;
    const Problem& problem = assembled.problem;
    Diagnostics findings;
    for (std::size_t b = 0; b < problem.boundaries.size(); ++b) {
        const Boundary& boundary = problem.boundaries[b];
        const bool acts = !std::holds_alternative<FreeFace>(boundary.soil) || acts_on_soil(boundary);
        const double worst = std::max(tests[b].constant_pressure, tests[b].geostatic);
        if (!acts || worst <= most) continue;
        const SceneBoundary* written = find_boundary(assembled.scene, boundary.name);
        if (written == nullptr) continue;
        findings.add(error_at(
            written->place, "patch-test",
            fmt::format("the nodal forces at the curve \"{}\" leave {} % of a pressure on it unbalanced",
                        boundary.name, short_number(100.0 * worst, 2)),
            "at most 2 %", "use interpolation = \"cpdi\", or smaller cells"));
    }
    if (findings.has_errors()) throw_findings(findings, assembled.scene.text);
}

std::string describe_boundaries(const AssembledCase& assembled, const std::vector<PatchTest>& tests)
{
    const Problem& problem = assembled.problem;
    std::string text = "Boundaries\n";
    const auto add = [&](const std::string& line) { text += fmt::format("  {:<16}{}\n", "", line); };
    for (std::size_t b = 0; b < problem.boundaries.size(); ++b) {
        const Boundary& boundary = problem.boundaries[b];
        if (boundary.segments.empty()) {
            text += fmt::format("  {:<16}no soil beside it here\n", boundary.name);
            continue;
        }
        text += fmt::format("  {:<16}{:.4g} m, {}{}{}\n", boundary.name, length_of(boundary),
                            kind_of(boundary.soil).word, problem.water ? ", water " : "",
                            problem.water ? water_name(boundary.water) : "");
        const std::string of_kind =
            std::visit([&](const auto& kind) { return describe(kind, assembled, boundary); }, boundary.soil);
        if (!of_kind.empty()) add(of_kind);
        if (const auto heads = heads_of_line(assembled.scene, problem.grid, boundary)) {
            add(describe_heads(*heads));
        } else if (has_outer_water(boundary.water)) {
            add(describe_outer_water(problem, boundary));
        }
        add(describe_patch_test(tests[b]));
    }
    if (tests.size() > problem.boundaries.size()) {
        text += "  edges without a name\n";
        add(describe_patch_test(tests.back()));
    }
    return text;
}

} // namespace quicksand
