// The water at boundary curves in scenes.
#include "io/faces/boundary_kinds.hpp"

namespace quicksand {

namespace {

template <class Water>
WaterCondition read_prescribed(BoundaryTable& table, std::string_view key)
{
    if (table.has(key) && table.text("soil") == "tied") {
        table.refuse_table(" is tied and has a prescribed head", "a head on a curve that is not tied",
                           "what passes through one of two tied sides comes in at the other");
    }
    return PrescribedWater{Water{table.number(key)}, table.history()};
}

} // namespace

// One row, one key: the formatter would make it ten lines.
// clang-format off

const std::vector<SceneWaterKind>& water_kinds()
{
    static const std::vector<SceneWaterKind> kinds = {
        {.word = "drained", .read = [](BoundaryTable&) -> WaterCondition { return Drained{}; }},
        {.word = "impervious", .read = [](BoundaryTable&) -> WaterCondition { return Impervious{}; }},
        {.word = "head", .keys = {
            {.pattern = "boundaries.*.head", .dimension = Dimension::length, .required = true,
             .saturated_only = true,
             .doc = "y of the water surface beyond the curve."}},
         .read = [](BoundaryTable& table) { return read_prescribed<WaterHead>(table, "head"); }},
        {.word = "pore_pressure", .keys = {
            {.pattern = "boundaries.*.pore_pressure", .dimension = Dimension::pressure, .required = true,
             .saturated_only = true,
             .doc = "Pore pressure along the curve, with its static part; on a free curve the water beyond it presses on the soil besides."}},
         .read = [](BoundaryTable& table) { return read_prescribed<PorePressure>(table, "pore_pressure"); }},
    };
    return kinds;
}

// clang-format on

} // namespace quicksand
