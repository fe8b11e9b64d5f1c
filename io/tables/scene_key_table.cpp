#include "io/faces/boundary_keys.hpp"
#include "io/keys/scene_schema.hpp"
#include "io/laws/soil_laws.hpp"
#include "io/tables/figure_keys.hpp"
#include "io/tables/motion_keys.hpp"
#include "io/tables/scene_interfaces.hpp"
#include "io/tables/stage_keys.hpp"
#include "solver/verification/studies/study.hpp"

#include <utility>

namespace quicksand {

namespace {

using enum ValueType;

constexpr Interval positive{.lower = 0.0, .lower_open = true};
constexpr Interval not_negative{.lower = 0.0};
constexpr Interval fraction{.lower = 0.0, .upper = 1.0, .lower_open = true, .upper_open = true};

const Condition manufactured_only{"problem", {"axis_aligned", "largest_vortex", "vortex"}};
const std::vector<std::string_view> coupled_only{"coupled"}, with_pressure{"coupled", "undrained"};
const Condition water_with_pressure{"flow", with_pressure};
const Condition profile_only{"kind", {"profile"}};
const Condition with_pores{"water", {"pores"}}, a_solid{"water", {"none"}};

// One row, one key: the formatter would make it ten lines.
// clang-format off

std::vector<SceneKey> geometry_keys()
{
    return {
        {.pattern = "geometry", .type = table, .required = true, .doc = "The drawn cross-section."},
        {.pattern = "geometry.file", .type = path, .required = true,
         .doc = "Drawing with named physical groups: .geo, .geo_unrolled or .msh, relative to the scene."},
        {.pattern = "geometry.parameters", .type = number_table,
         .default_value = std::map<std::string, double>{},
         .doc = "Values that replace those of the drawing's DefineConstant, as { crest_width = 0.15 }."},
        {.pattern = "grid", .type = table,
         .doc = "The background grid of square cells; what is not given is chosen, and check says what and why."},
        {.pattern = "grid.cell_size", .dimension = Dimension::length,
         .default_note = "4 cells through the thinnest region, 16 through all, 10 along a wave; walls on lines",
         .allowed = positive,
         .plausible = {1e-4, 10.0}, .doc = "Edge length of a cell."},
        {.pattern = "grid.origin", .type = point, .dimension = Dimension::length,
         .default_note = "such that the first walls from the left and from below lie on lines",
         .doc = "Lower left corner of the grid."},
        {.pattern = "grid.cells", .type = count_pair,
         .default_note = "what covers the section, with room above it",
         .allowed = {1.0, 100'000.0}, .doc = "Cells along x and y; left out, they reach beyond sides without walls as well."},
        {.pattern = "sampling", .type = table, .doc = "How the section is filled with material points."},
        {.pattern = "sampling.kind", .type = word, .default_value = "lattice", .words = {"lattice", "mesh"},
         .doc = "A regular lattice in every cell, or one point per quadrilateral of a mesh."},
        {.pattern = "sampling.particles_per_cell", .type = count_pair,
         .default_value = std::pair<int, int>(3, 3),
         .allowed = {1.0, 10.0}, .plausible = {2.0, 4.0}, .when = {"kind", {"lattice"}},
         .doc = "Material points of a cell along x and y; outlines cut their domains exactly."},
        {.pattern = "sampling.quad_size", .dimension = Dimension::length,
         .derived = {.key = "grid.cell_size", .divisor = 3.0},
         .allowed = positive, .when = {"kind", {"mesh"}}, .doc = "Edge length of the quadrilaterals."},
    };
}

std::vector<SceneKey> analysis_keys()
{
    return {
        {.pattern = "analysis", .type = table, .doc = "The form of the equations."},
        {.pattern = "analysis.interpolation", .type = word, .default_value = "cpdi",
         .words = {"cpdi", "cpdi2", "gimp", "cpgimp", "linear"},
         .doc = "Domains of the points: parallelograms, quadrilaterals, fixed or stretching boxes, or none."},
        {.pattern = "analysis.strain", .type = word, .default_value = "large", .words = {"large", "small"},
         .doc = "Whether the equations follow the motion, or stay on the drawn shape as in linear theory."},
        {.pattern = "analysis.scheme", .type = word, .default_value = "auto",
         .words = {"explicit", "semi_implicit", "implicit", "auto"},
         .doc = "Steps limited by sound in water, by waves in the skeleton with the water's pressure implicit, or by "
                "accuracy with the skeleton's inertia implicit as well, which give way to those that waves limit while "
                "these cost less; auto takes the fastest of the last two, and explicit steps for water that moves with "
                "the grains, for dry and drained soil that nothing shakes nor loads slowly, and where sound "
                "crosses the soil less than twenty times."},
        {.pattern = "analysis.columns", .type = word, .default_value = "one", .words = {"one", "all"},
         .doc = "Whether only one column of cells is computed between tied sides where all columns are equal."},
        {.pattern = "analysis.step_share", .default_value = 1.0, .allowed = {.lower = 0.0, .upper = 1.0, .lower_open = true},
         .doc = "Time step over the stable time step; runs with smaller values show the error of the time steps."},
    };
}

std::vector<SceneKey> ground_keys()
{
    return {
        {.pattern = "gravity", .type = table, .doc = "Gravity, acting downward."},
        {.pattern = "gravity.acceleration", .dimension = Dimension::acceleration,
         .default_value = standard_gravity,
         .allowed = not_negative, .plausible = {1.0, 2000.0},
         .doc = "Magnitude; a centrifuge at 120 times gravity is \"120 g\"."},
        {.pattern = "water", .type = table, .default_note = "a dry scene",
         .doc = "Pore water; without it the scene is dry."},
        {.pattern = "water.density", .dimension = Dimension::density, .default_value = 1000.0,
         .allowed = positive,
         .plausible = {900.0, 1100.0}, .doc = "Density of the pore water."},
        {.pattern = "water.bulk_modulus", .dimension = Dimension::pressure, .default_value = 2.2e9,
         .allowed = positive, .plausible = {1e8, 3e9}, .doc = "Bulk modulus of the pore water."},
        {.pattern = "water.level", .dimension = Dimension::length, .required = true,
         .doc = "y of the lowest still water; soil above it is dry, unless a phreatic line rises over it."},
        {.pattern = "water.phreatic_line", .type = point_list, .dimension = Dimension::length,
         .default_note = "the level",
         .doc = "Points from left to right: soil below is saturated, soil above drained, curves below that have no head of "
                "their own get the line's; level beyond its ends."},
        {.pattern = "water.initial_flow", .type = word, .default_value = "still", .words = {"still", "seepage"},
         .doc = "Water at the start: at rest, or in the steady flow between the heads at the curves, whose phreatic line is "
                "computed."},
        {.pattern = "water.flow", .type = word, .default_value = "coupled",
         .words = {"coupled", "undrained", "drained"},
         .doc = "Water with its own velocity, with the velocity of the grains, or without excess pressure."},
        {.pattern = "water.saturation", .default_value = 1.0, .allowed = {.lower = 0.0, .upper = 1.0, .lower_open = true},
         .plausible = {0.85, 1.0},
         .caution = "air is entrapped in bubbles above 85 per cent or so; below, suction would count",
         .when = water_with_pressure,
         .doc = "Fraction of the pore volume filled with water; the rest is entrapped air, 1/K = S/K_w + (1-S)/p_air."},
        {.pattern = "water.air_pressure", .dimension = Dimension::pressure, .default_value = atmospheric_pressure,
         .allowed = positive, .plausible = {5e4, 5e6}, .when = water_with_pressure,
         .doc = "Absolute pressure of the entrapped air, taken as constant; of use with saturation < 1."},
        {.pattern = "water.cavitation_pressure", .dimension = Dimension::pressure,
         .default_note = "water bears any tension",
         .allowed = {.upper = atmospheric_pressure, .upper_open = true}, .plausible = {0.0, 2e4},
         .caution = "this is an absolute pressure; the vapour pressure of water at 20 degrees is 2.3 kPa",
         .when = water_with_pressure,
         .doc = "Absolute pore pressure (atmosphere: 100 kPa) at which cavities open instead of more tension."},
    };
}

std::vector<std::string_view> words_of_laws()
{
    std::vector<std::string_view> words;
    for (const SoilLaw& law : soil_laws()) words.push_back(law.word);
    return words;
}

std::vector<std::pair<std::string_view, std::string_view>> volumetric_strains_of_laws()
{
    std::vector<std::pair<std::string_view, std::string_view>> choices;
    for (const SoilLaw& law : soil_laws()) choices.emplace_back(law.word, flows_at_constant_volume(law.form) ? "cell" : "particle");
    return choices;
}

/// A soil, but for the keys of its law.
std::vector<SceneKey> skeleton_keys()
{
    static const auto volumetric_strain_of_model = volumetric_strains_of_laws();
    return {
        {.pattern = "materials", .type = named_tables, .required = true, .doc = "The soils."},
        {.pattern = "materials.*", .type = table, .doc = "One soil, under a name of your choice."},
        {.pattern = "materials.*.model", .type = word, .required = true,
         .words = words_of_laws(),
         .doc = "Stress-strain law of the grain skeleton: elastic, elastic with the strength of friction and "
                "cohesion, sand that liquefies, or elastic at large strain and free of stress as drawn (for verification)."},
        {.pattern = "materials.*.volumetric_strain", .type = word,
         .derived = {.sibling = "model", .choices = volumetric_strain_of_model}, .words = {"cell", "particle"},
         .doc = "Whether stress follows the volume change of the cell, which keeps flow at constant volume "
                "free of locking, or that of the particle."},
    };
}

/// Grains, pores and the water in them.
std::vector<SceneKey> phase_keys()
{
    return {
        {.pattern = "materials.*.water", .type = word, .default_value = "pores", .words = {"pores", "none"},
         .doc = "Whether water fills the pores of the material, or it is a solid without pores: concrete, rock, steel."},
        {.pattern = "materials.*.density", .dimension = Dimension::density, .required = true,
         .allowed = positive, .plausible = {1000.0, 8000.0}, .when = a_solid,
         .doc = "Density of the solid, in the air: 2400 of concrete; buoyancy is added below the water."},
        {.pattern = "materials.*.grain_density", .dimension = Dimension::density, .default_value = 2650.0,
         .allowed = positive, .plausible = {2000.0, 3300.0},
         .caution = "this is the density of the grains, not of the soil", .when = with_pores, .doc = "Density of the grains."},
        {.pattern = "materials.*.porosity", .required = true, .allowed = fraction, .plausible = {0.2, 0.7},
         .caution = "porosity is the void volume over the total volume, not the void ratio", .when = with_pores,
         .doc = "Initial porosity: void volume over total volume."},
        {.pattern = "materials.*.hydraulic_conductivity", .dimension = Dimension::velocity, .required = true,
         .saturated_only = true, .flows = coupled_only, .used_by_seepage = true, .allowed = positive,
         .plausible = {1e-10, 1.0},
         .caution = "this is Darcy's conductivity in m/s, not an intrinsic permeability in m2, not k/gamma_w",
         .when = with_pores,
         .doc = "Darcy's conductivity k, at the gravity of conductivity_gravity."},
        {.pattern = "materials.*.conductivity_gravity", .dimension = Dimension::acceleration,
         .saturated_only = true, .flows = coupled_only, .used_by_seepage = true,
         .default_value = standard_gravity, .allowed = positive, .plausible = {1.0, 2000.0}, .when = with_pores,
         .doc = "Gravity at which the conductivity was measured; at 120 g a wrong value changes k by a factor of 120."},
        {.pattern = "materials.*.saturation_above_water", .saturated_only = true, .default_value = 0.0,
         .allowed = {.lower = 0.0, .upper = 1.0}, .when = with_pores,
         .doc = "Fraction of the pore volume filled with water above the phreatic line; it adds weight only."},
        {.pattern = "materials.*.permeability_law", .type = word, .saturated_only = true, .flows = coupled_only,
         .default_value = "constant", .words = {"constant", "kozeny_carman", "specific_volume_squared"},
         .when = with_pores,
         .doc = "Dependence of k on the porosity: constant, n^3/(1-n)^2, or 1/(1-n)^2."},
    };
}

std::vector<SceneKey> region_keys()
{
    return {
        {.pattern = "regions", .type = named_tables, .required = true,
         .doc = "The materials of the physical surfaces."},
        {.pattern = "regions.*", .type = table, .doc = "One physical surface of the drawing, by its name."},
        {.pattern = "regions.*.material", .type = text, .required = true, .doc = "Name of a material."},
        {.pattern = "regions.*.soil", .type = word, .default_value = "present", .words = {"present", "absent"},
         .doc = "Whether the region has soil, or is as empty as if it were not drawn; place and remove of stages change it."},
    };
}

std::vector<SceneKey> initial_keys()
{
    return {
        {.pattern = "initial", .type = table, .doc = "The initial state."},
        {.pattern = "initial.k0", .default_value = 0.5, .allowed = not_negative, .plausible = {0.2, 2.0},
         .doc = "Horizontal over vertical effective stress."},
        {.pattern = "initial.excess_pore_pressure", .dimension = Dimension::pressure,
         .saturated_only = true, .flows = with_pressure, .default_value = 0.0, .plausible = {-1e5, 1e7},
         .doc = "Excess pore pressure everywhere at the start of the run, as from an undrained load."},
        {.pattern = "relaxation", .type = table, .default_note = "the run starts from the K0 state as it is",
         .doc = "A damped stage in which the soil settles under gravity before the shaking."},
        {.pattern = "relaxation.damping", .default_value = 0.7, .allowed = fraction,
         .plausible = {0.05, 0.95},
         .doc = "Local damping factor."},
        {.pattern = "relaxation.tolerance", .default_value = 1e-6, .allowed = fraction,
         .plausible = {1e-12, 1e-2},
         .doc = "Out-of-balance force over body force at which the stage ends."},
        {.pattern = "relaxation.max_steps", .type = integer, .default_value = std::int64_t{200'000},
         .allowed = {1.0, 1e12}, .doc = "Steps after which a stage that has not settled is a failure."},
    };
}

std::vector<SceneKey> run_keys()
{
    return {
        {.pattern = "run", .type = table, .required = true, .doc = "The run."},
        {.pattern = "run.end_time", .dimension = Dimension::time, .required = true, .allowed = positive,
         .plausible = {1e-4, 1e8}, .doc = "End of the run, counted from the start of the shaking; a stage has a duration instead."},
        {.pattern = "output", .type = table, .doc = "Times at which results are written."},
        {.pattern = "output.frame_interval", .dimension = Dimension::time,
         .derived = {.key = "run.end_time", .divisor = 50.0},
         .allowed = positive, .doc = "Time between the frames of fields.pvd."},
        {.pattern = "output.probe_interval", .dimension = Dimension::time,
         .derived = {.key = "run.end_time", .divisor = 400.0},
         .allowed = positive, .doc = "Time between the rows of a probe; accelerations are means over it."},
        {.pattern = "output.history_interval", .dimension = Dimension::time,
         .derived = {.key = "run.end_time", .divisor = 200.0}, .allowed = positive,
         .doc = "Time between the rows of history.csv and steps.csv."},
        {.pattern = "output.checkpoint_interval", .dimension = Dimension::time, .default_value = 60.0,
         .allowed = positive, .doc = "Wall time between checkpoints."},
        {.pattern = "probes", .type = named_tables, .doc = "Places whose histories are written."},
        {.pattern = "probes.*", .type = table, .doc = "One probe; its name is that of its CSV file."},
        {.pattern = "probes.*.kind", .type = word, .default_value = "material",
         .words = {"material", "fixed", "surface", "profile"},
         .doc = "Moves with the soil, in all stages with the same particle, is fixed in space, follows the surface at an x, with the displacement and velocity of the surface itself, or samples a line."},
        {.pattern = "probes.*.at", .type = point, .dimension = Dimension::length,
         .default_note = "the physical point of the probe's name",
         .doc = "Place of the probe; start of a profile."},
        {.pattern = "probes.*.to", .type = point, .dimension = Dimension::length, .required = true,
         .when = profile_only, .doc = "End of a profile."},
        {.pattern = "probes.*.points", .type = integer, .default_value = std::int64_t{21},
         .allowed = {2.0, 10'000.0}, .when = profile_only, .doc = "Points of a profile."},
    };
}

std::vector<SceneKey> verification_keys()
{
    std::vector<std::string_view> problems;
    for (const Study& study : studies()) problems.push_back(study.name);
    return {
        {.pattern = "verification", .type = table, .default_note = "nothing to verify",
         .doc = "A problem with a known solution, for quicksand verify."},
        {.pattern = "verification.problem", .type = word, .required = true, .words = problems,
         .doc = "The study that runs the scene and knows its solution."},
        {.pattern = "verification.amplitude", .default_note = "that of the published problem", .allowed = positive,
         .when = manufactured_only,
         .doc = "Amplitude of a manufactured motion: a displacement in m, or a vortex's angle in rad."},
        {.pattern = "verification.length", .dimension = Dimension::length, .required = true,
         .allowed = positive, .doc = "Length along which cells are counted."},
        {.pattern = "verification.cells", .type = count_list, .required = true, .allowed = {1.0, 100'000.0},
         .doc = "Cells along the length, one run each, from coarse to fine."},
        {.pattern = "verification.short_cells", .type = count_list,
         .default_note = "the first of cells", .allowed = {1.0, 100'000.0},
         .doc = "Those of cells that quicksand verify --short runs."},
        {.pattern = "verification.one_cell", .type = text_list, .default_value = std::vector<std::string>{},
         .doc = "DefineConstant values of the drawing that are one cell long, as the width of a column."},
        {.pattern = "verification.limits", .type = list_table,
         .default_value = std::map<std::string, std::vector<double>>{}, .allowed = positive,
         .doc = "Largest error of a quantity, one for each of cells: \"quantity\" = [0.02, 0.005]."},
        {.pattern = "verification.orders", .type = number_table,
         .default_value = std::map<std::string, double>{}, .plausible = {0.5, 4.0},
         .doc = "Least order of convergence of a quantity: \"quantity\" = 1.8."},
    };
}

// clang-format on

std::vector<SceneKey> all_keys()
{
    std::vector<SceneKey> keys = {
        {.pattern = "scene_version",
         .type = integer,
         .required = true,
         .allowed = {1.0, 1.0},
         .doc = "Version of the scene format: 1."},
        {.pattern = "title", .type = text, .default_value = "", .doc = "One line on what the scene shows."},
        {.pattern = "base",
         .type = path,
         .default_note = "the scene stands by itself",
         .doc = "Scene in the same folder that holds the keys which are not given here; it may have a base "
                "itself."},
        {.pattern = "without",
         .type = text_list,
         .default_note = "all keys of the base hold",
         .doc = "Keys and tables of the base that this scene does not have, as [\"water\"]."},
        {.pattern = "accept",
         .type = text_list,
         .default_value = std::vector<std::string>{},
         .doc = "Keys whose warnings you have read and accept, as [\"materials.sand.porosity\"]."},
    };
    for (const auto& part :
         {geometry_keys(), analysis_keys(), ground_keys(), skeleton_keys(), phase_keys(), soil_law_keys(),
          region_keys(), interface_keys(), boundary_keys(), initial_keys(), motion_keys(), run_keys(),
          stage_keys(), figure_keys(), verification_keys()}) {
        keys.insert(keys.end(), part.begin(), part.end());
    }
    return keys;
}

} // namespace

const KeyTable& scene_key_table()
{
    static const KeyTable table = {"scene",
                                   "scene_version",
                                   "Scene keys",
                                   all_keys(),
                                   {{"sampling.boundary_refinement", "outlines cut the domains exactly"}}};
    return table;
}

} // namespace quicksand
