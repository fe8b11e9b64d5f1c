#include "io/tables/boundary_keys.hpp"

#include <array>

namespace quicksand {

namespace {

using enum ValueType;

constexpr Interval positive{.lower = 0.0, .lower_open = true};

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> water_beside_soil = {
    {{"free", "drained"},
     {"fixed", "impervious"},
     {"roller", "impervious"},
     {"tied", "impervious"},
     {"moving", "impervious"},
     {"viscous", "impervious"}}};

const Condition free_only{"soil", {"free"}};
const Condition moving_only{"soil", {"moving"}};
const Condition viscous_only{"soil", {"viscous"}};

} // namespace

// One row, one key: the formatter would make it ten lines.
// clang-format off

std::vector<SceneKey> boundary_keys()
{
    return {
        {.pattern = "boundaries", .type = named_tables, .doc = "Conditions on the physical curves."},
        {.pattern = "boundaries.*", .type = table, .doc = "One physical curve of the drawing, by its name."},
        {.pattern = "boundaries.*.soil", .type = word, .default_value = "free",
         .words = {"free", "fixed", "roller", "tied", "moving", "viscous"},
         .doc = "free, fixed, roller (slides along the curve), tied to the opposite side, moving as given, or "
                "viscous (waves leave)."},
        {.pattern = "boundaries.*.water", .type = word, .saturated_only = true,
         .derived = {.sibling = "soil", .choices = water_beside_soil},
         .words = {"drained", "impervious", "head", "pore_pressure"},
         .doc = "Whether pore water passes the curve, with the still water or the phreatic line beyond it, or what "
                "head or pressure it has there."},
        {.pattern = "boundaries.*.tied_to", .type = text, .required = true, .when = {"soil", {"tied"}},
         .doc = "The opposite curve, whose points of equal height move together with this one's."},
        {.pattern = "boundaries.*.pressure", .dimension = Dimension::pressure, .default_note = "none",
         .plausible = {-1e6, 1e8}, .when = free_only,
         .doc = "Pressure on the curve, normal to the surface as it moves, positive onto the soil."},
        {.pattern = "boundaries.*.traction", .type = point, .dimension = Dimension::pressure,
         .default_note = "none", .plausible = {-1e8, 1e8}, .when = free_only,
         .doc = "Load on the curve per length as drawn; it moves along and keeps its direction."},
        {.pattern = "boundaries.*.velocity", .type = point, .dimension = Dimension::velocity,
         .default_note = "none", .when = moving_only,
         .doc = "Velocity of the curve; the grains take part in it in both directions."},
        {.pattern = "boundaries.*.normal_velocity", .dimension = Dimension::velocity, .default_note = "none",
         .when = moving_only,
         .doc = "Velocity of the curve into the soil; along the curve the grains are free."},
        {.pattern = "boundaries.*.displacement", .type = point, .dimension = Dimension::length,
         .default_note = "none", .when = moving_only,
         .doc = "Displacement of the curve; the grains take part in it in both directions."},
        {.pattern = "boundaries.*.normal_displacement", .dimension = Dimension::length,
         .default_note = "none", .when = moving_only,
         .doc = "Displacement of the curve into the soil; along the curve the grains are free."},
        {.pattern = "boundaries.*.rock_density", .dimension = Dimension::density,
         .default_note = "as the soil beside the curve", .allowed = positive, .plausible = {1500.0, 3500.0},
         .when = viscous_only, .doc = "Density of what goes on beyond the curve."},
        {.pattern = "boundaries.*.rock_shear_wave_speed", .dimension = Dimension::velocity,
         .default_note = "as the soil beside the curve", .allowed = positive, .plausible = {50.0, 5000.0},
         .when = viscous_only, .doc = "Shear wave speed beyond the curve."},
        {.pattern = "boundaries.*.rock_compression_wave_speed", .dimension = Dimension::velocity,
         .default_note = "as the soil beside the curve", .allowed = positive, .plausible = {100.0, 8000.0},
         .when = viscous_only, .doc = "Compression wave speed beyond the curve."},
        {.pattern = "boundaries.*.head", .dimension = Dimension::length, .required = true,
         .saturated_only = true, .when = {"water", {"head"}},
         .doc = "y of the water surface beyond the curve."},
        {.pattern = "boundaries.*.pore_pressure", .dimension = Dimension::pressure, .required = true,
         .saturated_only = true, .when = {"water", {"pore_pressure"}},
         .doc = "Pore pressure along the curve, with its static part."},
        {.pattern = "boundaries.*.ramp_time", .dimension = Dimension::time, .default_note = "at once",
         .allowed = positive,
         .doc = "Time over which what acts on the curve rises linearly, a head from the water at rest."},
        {.pattern = "boundaries.*.frequency", .dimension = Dimension::frequency, .default_note = "no wave",
         .allowed = positive, .doc = "What acts on the curve varies as sin(2 pi f t) times its value."},
        {.pattern = "boundaries.*.history", .type = path, .default_note = "constant",
         .doc = "Two columns, time in s and the factor on what acts on the curve; linear in between."},
    };
}

// clang-format on

} // namespace quicksand
