#include "io/scene/scene_file.hpp"

#include "geometry/drawing/nearest_name.hpp"
#include "io/keys/scene_check.hpp"
#include "io/keys/scene_text.hpp"
#include "io/keys/scene_units.hpp"
#include "io/keys/scene_words.hpp"
#include "io/laws/soil_laws.hpp"
#include "io/scene/scene_base.hpp"
#include "io/scene/scene_references.hpp"
#include "io/scene/scene_stages.hpp"
#include "io/scene/scene_variant.hpp"
#include "io/scene/stage_beginning.hpp"
#include "io/scene/stage_changes.hpp"
#include "io/scene/stage_placement.hpp"
#include "io/tables/scene_boundaries.hpp"
#include "io/tables/scene_figures.hpp"
#include "io/tables/scene_interfaces.hpp"
#include "io/tables/scene_motion.hpp"
#include "io/tables/scene_verification.hpp"
#include "io/tables/stage_keys.hpp"
#include "solver/problem/solid_mixture.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <tuple>

namespace quicksand {

namespace {

constexpr WordList<ProbeKind, 4> probe_words = {{
    {"material", ProbeKind::material},
    {"fixed", ProbeKind::fixed},
    {"surface", ProbeKind::surface},
    {"profile", ProbeKind::profile},
}};

constexpr std::array<std::pair<std::string_view, Interpolation>, 5> interpolation_words = {{
    {"cpdi", Interpolation::cpdi},
    {"cpdi2", Interpolation::cpdi2},
    {"gimp", Interpolation::gimp},
    {"cpgimp", Interpolation::cpgimp},
    {"linear", Interpolation::linear},
}};
constexpr std::array<std::pair<std::string_view, TimeScheme>, 3> scheme_words = {{
    {"explicit", TimeScheme::explicit_steps},
    {"semi_implicit", TimeScheme::semi_implicit},
    {"implicit", TimeScheme::implicit},
}};

constexpr std::array<std::pair<std::string_view, StrainForm>, 2> strain_words = {{
    {"large", StrainForm::large},
    {"small", StrainForm::small},
}};

constexpr std::array<std::pair<std::string_view, WaterFlow>, 3> flow_words = {{
    {"coupled", WaterFlow::coupled},
    {"undrained", WaterFlow::undrained},
    {"drained", WaterFlow::drained},
}};
constexpr std::array<std::pair<std::string_view, PermeabilityLaw>, 3> permeability_words = {{
    {"constant", PermeabilityLaw::constant},
    {"kozeny_carman", PermeabilityLaw::kozeny_carman},
    {"specific_volume_squared", PermeabilityLaw::specific_volume_squared},
}};

void fill_geometry(const SceneValues& values, const std::filesystem::path& folder, Scene& scene)
{
    scene.geometry_file = folder / values.text("geometry.file");
    scene.geometry_parameters = values.find<std::map<std::string, double>>("geometry.parameters")
                                    .value_or(std::map<std::string, double>());
    scene.geometry_place = values.place("geometry.file");
    scene.cell_size = values.find<double>("grid.cell_size").value_or(0.0);
    scene.grid_origin = values.find<Vector2>("grid.origin");
    scene.grid_cells = values.find<std::pair<int, int>>("grid.cells");
    scene.grid_place = values.has_table("grid") ? values.tables.at("grid") : scene.geometry_place;
    if (values.text("sampling.kind") == "mesh") {
        scene.sampling = MeshSampling{values.find<double>("sampling.quad_size").value_or(0.0)};
        return;
    }
    LatticeSampling lattice;
    std::tie(lattice.per_cell_x, lattice.per_cell_y) =
        values.find<std::pair<int, int>>("sampling.particles_per_cell").value_or(std::pair(3, 3));
    scene.sampling = lattice;
}

/// A soil by its phases, or a solid by its density; the water is that of the scene.
Material read_material(const SceneValues& values, const NamedTable& table, const std::optional<Water>& water)
{
    const auto number = [&](const char* key) { return values.number(table.path + "." + key); };
    Material material;
    material.name = table.name;
    material.volumetric_strain = values.text(table.path + ".volumetric_strain") == "cell"
                                     ? VolumetricStrain::cell
                                     : VolumetricStrain::particle;
    if (values.text(table.path + ".water") == "none") {
        make_solid(number("density"), water, material);
        return material;
    }
    material.grain_density = number("grain_density");
    material.porosity = number("porosity");
    material.hydraulic_conductivity = number("hydraulic_conductivity");
    material.conductivity_gravity =
        values.find<double>(table.path + ".conductivity_gravity").value_or(standard_gravity);
    material.permeability_law = word_of(permeability_words, values.text(table.path + ".permeability_law"));
    return material;
}

Water read_water(const SceneValues& values)
{
    Water water;
    water.density = values.number("water.density");
    water.bulk_modulus = values.number("water.bulk_modulus");
    water.level = values.number("water.level");
    water.flow = word_of(flow_words, values.text("water.flow"));
    if (const auto saturation = values.find<double>("water.saturation")) {
        water.bulk_modulus =
            modulus_with_air(water.bulk_modulus, *saturation, values.number("water.air_pressure"));
    }
    water.cavitation_pressure = values.find<double>("water.cavitation_pressure");
    return water;
}

/// None: the fastest one. Without water there is no pressure to be implicit.
std::optional<TimeScheme> read_scheme(const SceneValues& values)
{
    const std::string word = values.text("analysis.scheme");
    if (word == "auto") return std::nullopt;
    const TimeScheme scheme = word_of(scheme_words, word);
    const bool is_dry = !values.has_table("water");
    return is_dry && scheme == TimeScheme::semi_implicit ? TimeScheme::explicit_steps : scheme;
}

void fill_ground(const SceneValues& values, Scene& scene)
{
    scene.interpolation = word_of(interpolation_words, values.text("analysis.interpolation"));
    scene.strain = word_of(strain_words, values.text("analysis.strain"));
    scene.scheme = read_scheme(values);
    scene.columns = values.text("analysis.columns") == "all" ? ColumnsComputed::all : ColumnsComputed::one;
    scene.step_fraction = values.number("analysis.step_share");
    scene.gravity = values.number("gravity.acceleration");
    if (values.has_table("water")) {
        scene.water = read_water(values);
        scene.phreatic_line =
            values.find<std::vector<Vector2>>("water.phreatic_line").value_or(std::vector<Vector2>());
        scene.phreatic_place = values.place("water.phreatic_line");
        scene.starts_seeping = values.text("water.initial_flow") == "seepage";
        scene.flow_place = values.place("water.initial_flow");
    }
    for (const NamedTable& table : values.tables_named("materials")) {
        Material material = read_material(values, table, scene.water);
        const double saturation =
            material.has_pores ? values.number(table.path + ".saturation_above_water") : 1.0;
        scene.materials.push_back({std::move(material), saturation, table.place});
    }
    for (const NamedTable& table : values.tables_named("regions")) {
        scene.regions.push_back({table.name, values.text(table.path + ".material"), table.place});
    }
    scene.k0 = values.number("initial.k0");
    scene.excess_pore_pressure = values.number("initial.excess_pore_pressure");
    if (values.has_table("relaxation")) {
        scene.relaxation =
            RelaxationControls{values.number("relaxation.damping"), values.number("relaxation.tolerance"),
                               values.find<std::int64_t>("relaxation.max_steps").value_or(0)};
    }
}

void fill_run(const SceneValues& values, Scene& scene)
{
    for (const NamedTable& table : values.tables_named("probes")) {
        SceneProbe probe;
        probe.name = table.name;
        probe.kind = word_of(probe_words, values.text(table.path + ".kind"));
        probe.at = values.find<Vector2>(table.path + ".at");
        probe.to = values.find<Vector2>(table.path + ".to");
        probe.points =
            static_cast<int>(values.find<std::int64_t>(table.path + ".points").value_or(probe.points));
        probe.place = table.place;
        scene.probes.push_back(std::move(probe));
    }
    scene.end_time = values.number("run.end_time");
    scene.output = {values.number("output.frame_interval"), values.number("output.probe_interval"),
                    values.number("output.history_interval"), values.number("output.checkpoint_interval")};
}

/// Frames are numbered with six digits, and no table of more rows than that can be looked at.
void check_intervals(const SceneValues& values, Diagnostics& findings)
{
    constexpr double most = 1e6;
    const double end_time = values.number("run.end_time");
    for (const char* key : {"output.frame_interval", "output.probe_interval", "output.history_interval"}) {
        const double interval = values.number(key);
        if (interval <= 0.0 || end_time <= most * interval) continue;
        findings.add(error_at(values.place(key), "range",
                              std::string(key) + " is " + number_text(interval) + " s, " +
                                  number_text(std::round(end_time / interval)) + " times in the run of " +
                                  number_text(end_time) + " s",
                              "at most " + number_text(most) + " times, or 0 for none"));
    }
}

void check_geometry_file(const SceneValues& values, const std::filesystem::path& file, Diagnostics& findings)
{
    if (!values.has("geometry.file")) return;
    const auto refuse = [&](const std::string& what, const std::string& expected, const std::string& hint) {
        findings.add(error_at(values.place("geometry.file"), "file", what, expected, hint));
    };
    std::error_code error;
    if (std::filesystem::is_directory(file, error)) {
        refuse("'" + file.string() + "' is a folder", "a drawing", "name the file in it");
    } else if (!std::filesystem::exists(file, error)) {
        std::vector<std::string> drawings;
        const auto folder = file.parent_path().empty() ? std::filesystem::path(".") : file.parent_path();
        for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
            drawings.push_back(entry.path().filename().string());
        }
        std::sort(drawings.begin(), drawings.end());
        const std::string nearest = nearest_name(file.filename().string(), drawings);
        refuse("there is no file '" + file.string() + "'",
               "a drawing; its path is relative to the scene file",
               nearest.empty() ? "" : "did you mean " + nearest + "?");
    } else if (const auto suffix = file.extension();
               suffix != ".geo" && suffix != ".geo_unrolled" && suffix != ".msh") {
        refuse("'" + file.string() + "' is not a drawing that can be read",
               "a file .geo, .geo_unrolled or .msh", "");
    }
}

/// A scene of another version is not judged by the keys of this one.
bool check_version(const DocumentNode& document, Diagnostics& findings)
{
    const DocumentNode* version = document.find("scene_version");
    if (version == nullptr || version->kind != DocumentNode::Kind::integer || version->integer == 1)
        return true;
    const std::string number = std::to_string(version->integer);
    findings.add(error_at(version->place, "version",
                          "scene_version " + number + " is not known to this program", "scene_version = 1",
                          version->integer > 1 ? "the scene is for a newer version of Quicksand"
                                               : "the first version is 1"));
    return false;
}

/// With the phases of the materials at hand.
void read_soil_laws(SceneValues& values, Scene& scene, Diagnostics& findings)
{
    for (SceneMaterial& material : scene.materials) {
        const std::string& name = material.material.name;
        const NamedTable table = {name, join_path({"materials", name}), material.place};
        material.material.law = read_soil_law({values, table, material.material, findings});
    }
}

/// The document of a scene with its base and overrides, and its text where it stands alone.
struct SceneDocument {
    DocumentNode document;
    std::string text;
    bool stands_alone = true;
};

SceneDocument read_scene_document(const std::filesystem::path& file,
                                  const std::vector<std::string>& overrides, Diagnostics& findings)
{
    auto text = read_text_file(file, {file, 0, 0}, findings);
    if (!text) throw_findings(findings, "");
    check_characters(file, *text, findings);
    if (findings.has_errors()) throw_findings(findings, *text);
    auto document = read_document(file, *text, {}, findings);
    DocumentNode unread; // overrides of a text that is no TOML are checked all the same
    if (document) name_stages(*document, findings);
    DocumentNode overriding;
    replace_by_overrides(overrides, overriding, findings);
    merge_variant(std::move(overriding), document ? *document : unread);
    if (!document || !check_version(*document, findings)) throw_findings(findings, *text);
    const bool stands_alone = document->find("base") == nullptr && document->find("stages") == nullptr;
    if (!stands_alone) findings.keep_text(file, *text);
    document = merge_with_base(file, std::move(*document), findings);
    if (!document || !check_version(*document, findings)) throw_findings(findings, *text);
    return {std::move(*document), std::move(*text), stands_alone};
}

SceneReading read_scene(const std::filesystem::path& file, const DocumentNode& document, std::string text,
                        Diagnostics& findings)
{
    SceneValues values = check_document(scene_key_table(), document, findings);
    check_references(values, findings);
    SceneReading reading;
    Scene& scene = reading.scene;
    scene.file = file;
    scene.text = std::move(text);
    scene.title = values.text("title");
    scene.accepted = values.find<std::vector<std::string>>("accept").value_or(std::vector<std::string>());
    scene.stage = read_stage(values);
    fill_geometry(values, file.parent_path(), scene);
    fill_ground(values, scene);
    if (scene.water && scene.stage && scene.stage->keeps_pressures)
        scene.water->while_settling = WaterFlow::undrained;
    fill_run(values, scene);
    scene.boundaries = read_boundaries(values, file.parent_path(), findings);
    scene.interfaces = read_interfaces(values, findings);
    read_soil_laws(values, scene, findings);
    scene.base_motion = read_motion(values, file.parent_path(), findings);
    scene.verification = read_verification(values, findings);
    static_cast<void>(read_figures(values, findings)); // drawn from the results, so only checked here
    check_geometry_file(values, scene.geometry_file, findings);
    check_intervals(values, findings);
    findings.accept(scene.accepted);
    reading.keys = std::move(values.keys);
    return reading;
}

} // namespace

std::vector<SceneReading> read_scene_stages(const std::filesystem::path& file,
                                            const std::vector<std::string>& overrides)
{
    Diagnostics findings;
    const SceneDocument read = read_scene_document(file, overrides, findings);
    const std::vector<std::string> stages = stage_names(read.document);
    if (stages.empty()) {
        SceneReading reading = read_scene(
            file, read.document, read.stands_alone ? read.text : document_text(read.document), findings);
        if (findings.has_errors()) throw_findings(findings, read.text);
        reading.warnings = std::move(findings);
        std::vector<SceneReading> readings{std::move(reading)};
        share_water_lines(readings);
        return readings;
    }
    check_placement(read.document, findings);
    std::vector<SceneReading> readings;
    for (const std::string& stage : stages) {
        const DocumentNode document = document_of_stage(read.document, stage);
        Diagnostics found;
        readings.push_back(read_scene(file, document, document_text(without_placement(document)), found));
        for (const Diagnostic& finding : found.findings()) findings.add_new(finding);
    }
    check_stages(readings, findings);
    if (findings.has_errors()) throw_findings(findings, read.text);
    readings.front().warnings = std::move(findings); // of all stages
    readings.front().warnings.keep_text(file, read.text);
    for (std::size_t k = 1; k < readings.size(); ++k)
        readings[k].warnings.keep_texts_of(readings.front().warnings);
    keep_histories(readings);
    end_damping(readings);
    carry_courses_on(readings);
    carry_water_on(readings);
    share_water_lines(readings);
    return readings;
}

SceneReading read_scene_file(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
    return std::move(read_scene_stages(file, overrides).front());
}

} // namespace quicksand
