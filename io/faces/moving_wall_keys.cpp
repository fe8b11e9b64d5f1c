// Moving walls in scenes: the keys of their motions.
#include "io/faces/boundary_kinds.hpp"

#include <algorithm>

namespace quicksand {

namespace {

const std::vector<std::string_view> motion_keys = {"velocity", "normal_velocity", "displacement",
                                                   "normal_displacement"};

/// The key that says how the wall moves; "" where it is missing or wrong, which has been reported then.
std::string motion_key(BoundaryTable& table)
{
    std::vector<std::string> given;
    for (const std::string_view key : motion_keys) {
        if (table.is_written(key)) given.emplace_back(key);
    }
    const std::string expected = "one of velocity, normal_velocity, displacement, normal_displacement";
    if (given.empty()) {
        table.refuse_table(" moves but does not say how", expected);
        return "";
    }
    if (!std::all_of(given.begin(), given.end(), [&](const auto& key) { return table.has(key); })) return "";
    if (given.size() == 1) return given[0];
    table.refuse(given[1], table.path(given[1]) + " and " + given[0] + " contradict each other", expected,
                 "remove one of the two");
    return "";
}

SoilCondition read_moving_wall(BoundaryTable& table)
{
    const std::string key = motion_key(table);
    if (key.empty()) return MovingWall{};
    WallMotion motion;
    motion.quantity = key.ends_with("velocity") ? MotionQuantity::velocity : MotionQuantity::displacement;
    motion.grip = key.starts_with("normal") ? WallGrip::smooth : WallGrip::rough;
    if (motion.grip == WallGrip::smooth) {
        motion.inward = table.number(key);
    } else {
        motion.value = table.point(key);
    }
    motion.history = table.history();
    const bool varies = table.has("ramp_time") || table.has("frequency") || table.has("history");
    if (motion.quantity == MotionQuantity::displacement && !varies) {
        table.refuse(key, table.path(key) + " has no course: the curve would jump to it at the start",
                     "a ramp_time, a frequency or a history beside it");
    }
    return MovingWall{motion};
}

} // namespace

// One row, one key: the formatter would make it ten lines.
// clang-format off

SceneSoilKind scene_kind(const MovingWall&)
{
    using enum ValueType;
    return {.word = "moving", .doc = "moving as given",
            .keys = {
        {.pattern = "boundaries.*.velocity", .type = point, .dimension = Dimension::velocity,
         .default_note = "none",
         .doc = "Velocity of the curve; the grains take part in it in both directions."},
        {.pattern = "boundaries.*.normal_velocity", .dimension = Dimension::velocity, .default_note = "none",
         .doc = "Velocity of the curve into the soil; along the curve the grains are free."},
        {.pattern = "boundaries.*.displacement", .type = point, .dimension = Dimension::length,
         .default_note = "none",
         .doc = "Displacement of the curve; the grains take part in it in both directions."},
        {.pattern = "boundaries.*.normal_displacement", .dimension = Dimension::length,
         .default_note = "none",
         .doc = "Displacement of the curve into the soil; along the curve the grains are free."},
            },
            .varying = motion_keys, .read = read_moving_wall};
}

// clang-format on

} // namespace quicksand
