#include "app/stress/scenes/designed_set.hpp"
#include "app/stress/scenes/section_draft.hpp"

#include <fmt/format.h>

#include <array>

namespace quicksand {

namespace {

constexpr std::array all_schemes = {explicit_scheme, semi_implicit_scheme, dry_scheme};

/// Soft rubber-like soil on which nothing acts; its water is soft enough for steps of the explicit scheme.
SceneDraft soft_scene(const std::string& scheme)
{
    SceneDraft scene = block_scene(scheme);
    scene.remove("motion").remove("boundaries.left").remove("boundaries.right").remove("initial");
    scene.remove("boundaries.base").remove("boundaries.surface");
    scene.set("materials.soil.model", "neo_hookean").set("materials.soil.shear_modulus", 1e6);
    scene.set("gravity.acceleration", 0.0);
    if (scheme != dry_scheme) scene.set("water.bulk_modulus", 1e7);
    return scene;
}

/// The top is drawn along until the block is sheared by 300 %; its sides are free.
void add_shear_rows(StressRows& rows)
{
    for (const char* scheme : all_schemes) {
        for (const std::string law : {"neo_hookean", "mohr_coulomb"}) {
            SceneDraft scene = soft_scene(scheme);
            scene.set("materials.soil.model", law);
            if (law == "mohr_coulomb")
                scene.set("materials.soil.friction_angle", 0.0).set("materials.soil.cohesion", 2e4);
            scene.set("grid.origin", -20.0, 0.0).set_whole("grid.cells", 50, 8);
            scene.set("boundaries.base.soil", "fixed").set("boundaries.surface.soil", "moving");
            scene.set("boundaries.surface.velocity", 2.0, 0.0).set("run.end_time", 6.0);
            scene.set("output.frame_interval", 1.0).set("output.history_interval", 0.1);
            rows.push_back(drawn_row("shear_300", fmt::format("{}-{}", scheme, law),
                                     draft_rectangle(0.0, 0.0, 8.0, 4.0).text(), scene));
        }
    }
}

/// Ten turns of a free block.
void add_turning_rows(StressRows& rows)
{
    for (const char* scheme : all_schemes) {
        SceneDraft scene = soft_scene(scheme);
        scene.set("grid.origin", -5.0, -5.0).set_whole("grid.cells", 14, 14);
        if (scheme == explicit_scheme || scheme == semi_implicit_scheme)
            scene.set("water.flow", scheme == explicit_scheme ? "undrained" : "coupled");
        scene.set("run.end_time", 62.832).set("output.frame_interval", 6.2832);
        scene.set("output.history_interval", 0.62832);
        rows.push_back(drawn_row("ten_turns", scheme, draft_rectangle(0.0, 0.0, 4.0, 4.0).text(), scene));
        rows.back().spin = 1.0;
    }
}

/// Soil that flows, or is thrown, out of a grid without room for it.
void add_leaving_rows(StressRows& rows)
{
    for (const char* scheme : all_schemes) {
        SceneDraft scene = block_scene(scheme);
        scene.remove("motion").remove("boundaries.right");
        scene.set("materials.soil.model", "mohr_coulomb").set("materials.soil.friction_angle", 20.0);
        scene.set("grid.origin", 0.0, 0.0).set_whole("grid.cells", 10, 9);
        scene.set("run.end_time", 2.0).set("output.frame_interval", 0.5);
        if (scheme != dry_scheme) scene.set("water.bulk_modulus", 2e7);
        rows.push_back(block_row("leaving", fmt::format("{}-flowing", scheme), scene));

        SceneDraft thrown = soft_scene(scheme);
        thrown.set("grid.origin", -2.0, -2.0).set_whole("grid.cells", 12, 12);
        thrown.set("run.end_time", 2.0).set("output.frame_interval", 0.5);
        rows.push_back(block_row("leaving", fmt::format("{}-thrown", scheme), thrown));
        rows.back().velocity = {3.0, 1.0};
    }
}

/// A block falls on another, bounces and comes back.
void add_meeting_rows(StressRows& rows)
{
    SectionDraft section;
    section.add_region("soil", {{{0, 0}, "base"}, {{8, 0}, ""}, {{8, 3}, ""}, {{0, 3}, ""}});
    section.add_region("soil", {{{2, 4.5}, ""}, {{6, 4.5}, ""}, {{6, 7.5}, ""}, {{2, 7.5}, ""}});
    for (const char* scheme : all_schemes) {
        SceneDraft scene = soft_scene(scheme);
        scene.set("gravity.acceleration", 9.81).set("grid.origin", -3.0, 0.0);
        scene.set_whole("grid.cells", 14, 14).set("boundaries.base.soil", "fixed");
        scene.set("initial.k0", 0.5).set("run.end_time", 2.5).set("output.frame_interval", 0.25);
        scene.set("output.history_interval", 0.025);
        rows.push_back(drawn_row("meeting", scheme, section.text(), scene));
    }
}

/// A hanging bar that swings for 10^6 steps.
void add_long_rows(StressRows& rows)
{
    SceneDraft scene = soft_scene(dry_scheme);
    scene.set("gravity.acceleration", 0.5).set("boundaries.left.soil", "fixed");
    scene.set("run.end_time", 14000.0).set("output.frame_interval", 1400.0);
    scene.set("output.history_interval", 70.0);
    rows.push_back(drawn_row("million_steps", "bar", draft_rectangle(0.0, 0.0, 8.0, 1.0).text(), scene));
}

} // namespace

void add_motion_rows(bool long_ones, StressRows& rows)
{
    add_shear_rows(rows);
    add_turning_rows(rows);
    add_leaving_rows(rows);
    add_meeting_rows(rows);
    if (long_ones) add_long_rows(rows);
}

} // namespace quicksand
