// Free faces in scenes: the keys of their loads.
#include "io/faces/boundary_kinds.hpp"

namespace quicksand {

namespace {

SoilCondition read_free_face(BoundaryTable& table)
{
    FreeFace face;
    if (!table.has("pressure") && !table.has("traction")) return face;
    face.load = SurfaceLoad{table.point("traction"), table.number("pressure"), table.history()};
    return face;
}

} // namespace

// One row, one key: the formatter would make it ten lines.
// clang-format off

SceneSoilKind scene_kind(const FreeFace&)
{
    return {.word = "free", .doc = "free", .water = "drained",
            .keys = {
        {.pattern = "boundaries.*.pressure", .dimension = Dimension::pressure, .default_note = "none",
         .plausible = {-1e6, 1e8},
         .doc = "Pressure on the curve, normal to the surface as it moves, positive onto the soil."},
        {.pattern = "boundaries.*.traction", .type = ValueType::point, .dimension = Dimension::pressure,
         .default_note = "none", .plausible = {-1e8, 1e8},
         .doc = "Load on the curve per length as drawn; it moves along and keeps its direction."},
            },
            .varying = {"pressure", "traction"}, .read = read_free_face};
}

// clang-format on

} // namespace quicksand
