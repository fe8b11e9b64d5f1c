// Viscous faces in scenes: the keys of the rock beyond them.
#include "io/faces/boundary_kinds.hpp"
#include "io/keys/scene_units.hpp"

#include <array>

namespace quicksand {

namespace {

constexpr std::array rock_keys = {"rock_density", "rock_shear_wave_speed", "rock_compression_wave_speed"};

SoilCondition read_viscous_face(BoundaryTable& table)
{
    std::string given, missing;
    for (const char* key : rock_keys) {
        if (table.has(key)) {
            given = key;
        } else if (table.is_written(key)) {
            return ViscousFace{}; // its value is wrong and has been reported
        } else {
            missing += (missing.empty() ? "" : " and ") + std::string(key);
        }
    }
    if (given.empty()) return ViscousFace{};
    if (!missing.empty()) {
        table.refuse(given, table.path(given) + " is alone: " + missing + " are unknown",
                     "all of rock_density, rock_shear_wave_speed, rock_compression_wave_speed, or none",
                     "none makes the boundary as stiff as the soil beside it");
        return ViscousFace{};
    }
    const HalfSpace rock{table.number(rock_keys[0]), table.number(rock_keys[1]), table.number(rock_keys[2])};
    if (rock.compression_wave_speed <= rock.shear_wave_speed) {
        table.refuse(rock_keys[2],
                     table.path(rock_keys[2]) + " is not larger than the shear wave speed " +
                         quantity_text(rock.shear_wave_speed, Dimension::velocity),
                     "a compression wave that is faster than the shear wave");
    }
    return ViscousFace{rock};
}

} // namespace

// One row, one key: the formatter would make it ten lines.
// clang-format off

SceneSoilKind scene_kind(const ViscousFace&)
{
    const Interval positive{.lower = 0.0, .lower_open = true};
    return {.word = "viscous", .doc = "viscous (waves leave)",
            .keys = {
        {.pattern = "boundaries.*.rock_density", .dimension = Dimension::density,
         .default_note = "as the soil beside the curve", .allowed = positive, .plausible = {1500.0, 3500.0},
         .doc = "Density of what goes on beyond the curve."},
        {.pattern = "boundaries.*.rock_shear_wave_speed", .dimension = Dimension::velocity,
         .default_note = "as the soil beside the curve", .allowed = positive, .plausible = {50.0, 5000.0},
         .doc = "Shear wave speed beyond the curve."},
        {.pattern = "boundaries.*.rock_compression_wave_speed", .dimension = Dimension::velocity,
         .default_note = "as the soil beside the curve", .allowed = positive, .plausible = {100.0, 8000.0},
         .doc = "Compression wave speed beyond the curve."},
            },
            .read = read_viscous_face};
}

// clang-format on

} // namespace quicksand
