#include "app/stress/scenes/designed_set.hpp"
#include "app/stress/scenes/section_draft.hpp"

#include <fmt/format.h>

namespace quicksand {

namespace {

constexpr double wall_way = 0.05, moving_time = 0.3;      // how far a wall moves [m], and how long [s]
constexpr double fastest_side = 1.0, fastest_base = 0.05; // of the soil: several times the walls' [m/s]

/// What the right side does: `sign` is 1 into the soil and -1 away from it.
void set_moving_side(const std::string& quantity, double sign, SceneDraft& scene)
{
    scene.set("boundaries.right.soil", "moving");
    const std::string key = "boundaries.right." + quantity;
    if (quantity == "velocity") scene.set(key, -sign * wall_way / moving_time, 0.0);
    if (quantity == "normal_velocity") scene.set(key, sign * wall_way / moving_time);
    if (quantity == "displacement") scene.set(key, -sign * wall_way, 0.0);
    if (quantity == "normal_displacement") scene.set(key, sign * wall_way);
    scene.set("boundaries.right.ramp_time", moving_time);
}

/// The block with its right side moving, as drawn or with all walls between grid lines.
void add_moving_side(const std::string& scheme, const std::string& base, StressRows& rows)
{
    for (const std::string quantity :
         {"velocity", "normal_velocity", "displacement", "normal_displacement"}) {
        for (const double sign : {1.0, -1.0}) {
            for (const double offset : {0.0, 0.3}) {
                SceneDraft scene = block_scene(scheme);
                scene.remove("motion").set("boundaries.base.soil", base);
                set_moving_side(quantity, sign, scene);
                if (offset > 0.0)
                    scene.set("grid.origin", offset - 2.0, offset - 1.0).set_whole("grid.cells", 12, 12);
                rows.push_back(block_row("moving_walls",
                                         fmt::format("{}-{}-{}-{}-{}", scheme, base, quantity,
                                                     sign > 0.0 ? "in" : "out", offset > 0.0 ? "off" : "on"),
                                         scene));
                rows.back().most_velocity = fastest_side;
            }
        }
    }
}

/// Half of a straight base moves up or down beside the other half, which stands.
void add_parting_base(const std::string& scheme, StressRows& rows)
{
    SectionDraft section;
    section.add_region("soil", {{{0.0, 0.0}, "base"},
                                {{3.3, 0.0}, "base_2"},
                                {{8.0, 0.0}, "right"},
                                {{8.0, 6.0}, "surface"},
                                {{0.0, 6.0}, "left"}});
    for (const double velocity : {3e-5, 3e-3, -3e-3}) {
        SceneDraft scene = block_scene(scheme);
        scene.remove("motion").set("boundaries.base_2.soil", "moving");
        scene.set("boundaries.base_2.velocity", 0.0, velocity);
        rows.push_back(drawn_row("moving_walls", fmt::format("{}-half_a_base-{:g}", scheme, velocity),
                                 section.text(), scene));
        rows.back().most_velocity = fastest_base;
    }
}

} // namespace

void add_moving_rows(StressRows& rows)
{
    for (const char* scheme : {explicit_scheme, semi_implicit_scheme, dry_scheme}) {
        for (const char* base : {"fixed", "roller"}) add_moving_side(scheme, base, rows);
        add_parting_base(scheme, rows);
    }
}

} // namespace quicksand
