#include "app/stress/scenes/designed_set.hpp"
#include "app/stress/scenes/section_draft.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace quicksand {

namespace {

constexpr std::array boundary_kinds = {"free", "fixed", "roller", "viscous", "moving", "moving_normal"};

/// Of soil some metres high that has settled until 1e-5 of its weight is unbalanced [m/s].
constexpr double restless = 1e-4;

/// Moving walls stand: what moves is wrong.
void set_boundary(const std::string& curve, const std::string& kind, SceneDraft& scene)
{
    const std::string table = "boundaries." + curve;
    scene.remove(table);
    scene.set(table + ".soil", kind.starts_with("moving") ? "moving" : kind);
    if (kind == "moving") scene.set(table + ".velocity", 0.0, 0.0);
    if (kind == "moving_normal") scene.set(table + ".normal_velocity", 0.0);
}

/// 10 m of base, and a side that rises by 4.3 m from its right end at an angle inside the soil.
SectionDraft corner_section(double degrees)
{
    constexpr double length = 10.0, height = 4.3;
    const double right = length - height / std::tan(degrees * std::acos(-1.0) / 180.0);
    SectionDraft section;
    section.add_region("soil", {{{0.0, 0.0}, "base"},
                                {{length, 0.0}, "right"},
                                {{degrees == 90.0 ? length : right, height}, "surface"},
                                {{0.0, height}, "left"}});
    return section;
}

/// 10 m of base whose right part is the side: the two meet on one line.
SectionDraft straight_section()
{
    constexpr double length = 10.0, height = 4.3, meeting = 6.3;
    SectionDraft section;
    section.add_region("soil", {{{0.0, 0.0}, "base"},
                                {{meeting, 0.0}, "right"},
                                {{length, 0.0}, "roller"},
                                {{length, height}, "surface"},
                                {{0.0, height}, "left"}});
    return section;
}

/// The soil settles first, so that it is in equilibrium with whatever its boundaries are.
SceneDraft scene_at_rest(const std::string& scheme)
{
    SceneDraft scene = block_scene(scheme);
    scene.remove("motion").set("run.end_time", 0.2).set("output.frame_interval", 0.1);
    scene.set("relaxation.tolerance", 1e-5).set("relaxation.max_steps", 100000.0);
    return scene;
}

void add_pairs(const std::string& scheme, StressRows& rows)
{
    for (const std::string base : boundary_kinds) {
        if (base == "free") continue; // something must bear the soil
        for (const std::string side : boundary_kinds) {
            SceneDraft scene = scene_at_rest(scheme);
            set_boundary("base", base, scene);
            set_boundary("right", side, scene);
            const auto add = [&](double degrees, const SectionDraft& section) {
                const std::string name = fmt::format("{}-{}-{}-{:g}", scheme, base, side, degrees);
                rows.push_back(drawn_row("corners", name, section.text(), scene));
                rows.back().most_velocity = restless;
                rows.back().measures_step = true;
            };
            for (const double degrees : {30.0, 60.0, 90.0, 120.0, 150.0})
                add(degrees, corner_section(degrees));
            if (side == base || side == "free") continue;
            scene.set("boundaries.roller.soil", "roller");
            add(180.0, straight_section());
        }
    }
}

/// A surface that lies this part of a cell above a grid line, and walls that lie so beside one.
void add_slivers(const std::string& scheme, StressRows& rows)
{
    for (const double part : {0.02, 0.05, 0.1, 0.25, 0.5, 0.75, 0.98}) {
        StressRow surface = drawn_row("slivers", fmt::format("{}-surface-{:g}", scheme, part),
                                      draft_rectangle(0.0, 0.0, 8.0, 8.0 + part).text(), block_scene(scheme));
        surface.measures_step = true;
        rows.push_back(std::move(surface));
        SceneDraft scene = block_scene(scheme);
        scene.set("grid.origin", part - 1.0, part - 1.0).set_whole("grid.cells", 10, 12);
        StressRow walls = block_row("slivers", fmt::format("{}-walls-{:g}", scheme, part), scene);
        walls.measures_step = true;
        rows.push_back(std::move(walls));
    }
    for (const double rise : {0.02, 0.3, 2.0}) { // of a surface that crosses the grid lines
        SectionDraft section;
        section.add_region("soil", {{{0.0, 0.0}, "base"},
                                    {{8.0, 0.0}, "right"},
                                    {{8.0, 6.0}, "surface"},
                                    {{0.0, 6.0 + rise}, "left"}});
        SceneDraft scene = scene_at_rest(scheme);
        rows.push_back(
            drawn_row("slivers", fmt::format("{}-slope-{:g}", scheme, rise), section.text(), scene));
        rows.back().most_velocity = restless;
        rows.back().measures_step = true;
    }
}

} // namespace

void add_corner_rows(StressRows& rows)
{
    for (const char* scheme : {explicit_scheme, semi_implicit_scheme}) add_pairs(scheme, rows);
    for (const char* scheme : {explicit_scheme, semi_implicit_scheme, dry_scheme}) add_slivers(scheme, rows);
}

} // namespace quicksand
