#include "io/scene/stage_changes.hpp"

#include "io/keys/scene_schema.hpp"
#include "io/laws/soil_laws.hpp"
#include "io/tables/stage_keys.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace quicksand {

namespace {

using Keys = std::vector<ResolvedKey>;
using Values = std::map<std::string, const ResolvedKey*>;

Values values_of(const Keys& keys)
{
    Values values;
    for (const ResolvedKey& key : keys) values[key.path] = &key;
    return values;
}

std::string value_of(const Values& values, const std::string& path)
{
    const auto found = values.find(path);
    return found == values.end() ? "" : found->second->value;
}

bool begins_with_one_of(const std::string& path, const auto& prefixes)
{
    return std::any_of(prefixes.begin(), prefixes.end(), [&](std::string_view prefix) {
        return path == prefix || (prefix.ends_with('.') && path.starts_with(prefix));
    });
}

/// Paths whose values differ, in the order of the reference; those of the stages themselves left out.
std::vector<std::string> differing_paths(const Keys& before, const Keys& now)
{
    const Values old = values_of(before), present = values_of(now);
    std::vector<std::string> paths;
    for (const ResolvedKey& key : now) {
        if (!key.path.starts_with("stages.") && value_of(old, key.path) != key.value)
            paths.push_back(key.path);
    }
    for (const ResolvedKey& key : before) {
        if (!key.path.starts_with("stages.") && !present.contains(key.path)) paths.push_back(key.path);
    }
    return paths;
}

/// What particles and equations are made of.
constexpr std::array<std::string_view, 6> common{"geometry.", "grid.",           "sampling.",
                                                 "gravity.",  "analysis.strain", "analysis.interpolation"};
/// Where soil is saturated, and what pore pressures are when nothing flows.
constexpr std::array<std::string_view, 3> still_water{"water.level", "water.phreatic_line",
                                                      "water.initial_flow"};

void check_stage(const SceneReading& before, const SceneReading& now, Diagnostics& findings)
{
    const SceneStage& stage = *now.scene.stage;
    const bool is_settled = settles(stage.kind) && !stage.keeps_pressures;
    for (const std::string& path : uncommon_keys(before.keys, now.keys, is_settled)) {
        const bool is_water = begins_with_one_of(path, still_water);
        findings.add(error_at(
            stage.place, "stage", "the stage \"" + stage.name + "\" cannot change " + path,
            is_water ? "a drained stage of kind = \"settle\" or \"seepage\", whose soil comes to rest with "
                       "other water"
                     : "the same value in all stages",
            is_water ? "outer water that rises or falls in time is the head of a boundary, with ramp_time or "
                       "a history"
                     : "give " + path + " for the whole scene"));
    }
    const Values old = values_of(before.keys), present = values_of(now.keys);
    for (const std::string& path : differing_paths(before.keys, now.keys))
        if (path.starts_with("initial.") && old.contains(path) &&
            present.contains(path)) // others come with a flow
            findings.add(error_at(stage.place, "stage",
                                  "the stage \"" + stage.name + "\" cannot change " + path +
                                      ": it goes on from the end of the stage before",
                                  "the table [initial] of the scene",
                                  "of placed soil stress comes with its weight"));
    if (before.scene.water.has_value() != now.scene.water.has_value())
        findings.add(error_at(
            stage.place, "stage", "the stage \"" + stage.name + "\" cannot add or remove [water]",
            "water in all stages, or in none", "water that stays at rest is water.flow = \"drained\""));
    if (stage.kind == StageKind::consolidate && now.scene.water &&
        now.scene.water->flow != WaterFlow::coupled)
        findings.add(error_at(stage.place, "stage",
                              "no water flows in the stage \"" + stage.name + "\", which is to consolidate",
                              "water.flow = \"coupled\" in this stage"));
}

/// Keys of a material that leave it the same soil, which remembers what it went through: how its water flows,
/// how it settles after shaking, how exactly its law is integrated.
constexpr std::array<std::string_view, 16> of_same_soil = {
    "hydraulic_conductivity", "conductivity_gravity",  "permeability_law",    "liquefied_conductivity",
    "reconsolidation",        "reconsolidation_slope", "sedimentation_floor", "sedimentation_stress",
    "volumetric_strain",      "largest_ratio_step",    "largest_stress_step", "resolved_floors",
    "substep_tolerance",      "stress_tolerance",      "damping_ratio",       "damping_frequency"};

/// The keys that are given of the soil of a region and tell which soil it is, by their names; what its law
/// derives follows from them.
std::map<std::string, std::string> given_soil_keys(const Keys& keys, const std::string& region)
{
    const std::string material = value_of(values_of(keys), join_path({"regions", region, "material"}));
    const std::string table = join_path({"materials", material}) + ".";
    std::map<std::string, std::string> soil;
    for (const ResolvedKey& key : keys) {
        if (!key.given || !key.path.starts_with(table)) continue;
        const std::string name = key.path.substr(table.size());
        if (std::find(of_same_soil.begin(), of_same_soil.end(), name) == of_same_soil.end())
            soil[name] = key.value;
    }
    return soil;
}

/// Warn of the materials of regions that are as `is_doubtful` says, at a key of theirs; whether there are
/// any.
bool doubt_materials(const Scene& stage, std::string_view key, const std::string& hint,
                     bool (*is_doubtful)(const SkeletonLaw&), std::string_view what, Diagnostics& findings)
{
    bool told = false;
    for (const SceneMaterial& material : stage.materials) {
        const std::string& name = material.material.name;
        const bool is_there = std::any_of(stage.regions.begin(), stage.regions.end(),
                                          [&](const SceneRegion& region) { return region.material == name; });
        if (!is_there || !is_doubtful(material.material.law)) continue;
        findings.add(warning_at(stage.stage->place, join_path({"materials", name, std::string(key)}), "stage",
                                "the sand \"" + name + "\" " + std::string(what) + " in the stage \"" +
                                    stage.stage->name + "\"",
                                "", hint + " in a table [stages.materials." + name + "]"));
        told = true;
    }
    return told;
}

/// Sand that has been shaken and settles by a fraction of what laboratories measure, told once, and sand that
/// is shaken with what is for settling.
void doubt_sands(const std::vector<SceneReading>& stages, Diagnostics& findings)
{
    bool has_shaken = false;
    for (const SceneReading& now : stages) {
        if (now.scene.stage->kind == StageKind::shake) {
            has_shaken = true;
            doubt_materials(now.scene, "reconsolidation", "reconsolidation = 0", has_post_shaking_option,
                            "is shaken with its post-shaking option, reconsolidation, which softens it,",
                            findings);
        } else if (has_shaken && now.scene.stage->kind == StageKind::consolidate) {
            has_shaken = !doubt_materials(now.scene, "reconsolidation_slope",
                                          "give it a reconsolidation_slope", lacks_reconsolidation,
                                          "settles after liquefaction by a fraction of what laboratories "
                                          "measure, with a reconsolidation_slope of 0,",
                                          findings);
        }
        findings.accept(now.scene.accepted);
    }
}

/// Whether a region has soil with a strength. Regions of wrong materials count: they have been reported.
bool has_strength(const Scene& scene)
{
    return std::any_of(scene.regions.begin(), scene.regions.end(), [&](const SceneRegion& region) {
        return std::none_of(
            scene.materials.begin(), scene.materials.end(), [&](const SceneMaterial& material) {
                return material.material.name == region.material && !has_strength(material.material.law);
            });
    });
}

} // namespace

void check_stages(const std::vector<SceneReading>& stages, Diagnostics& findings)
{
    for (std::size_t k = 0; k < stages.size(); ++k) {
        const SceneReading& now = stages[k];
        if (!now.scene.stage) return; // its keys are wrong and have been reported
        if (k > 0) check_stage(stages[k - 1], now, findings);
        const bool reacts = now.scene.water && now.scene.water->flow != WaterFlow::drained;
        if (now.scene.stage->keeps_pressures && !reacts)
            findings.add(error_at(now.scene.stage->place, "stage",
                                  "no water reacts in the stage \"" + now.scene.stage->name +
                                      "\", which settles undrained",
                                  "a table [water], with flow = \"coupled\" or \"undrained\""));
        if (now.scene.stage->kind == StageKind::stability && !has_strength(now.scene))
            findings.add(error_at(now.scene.stage->place, "stage",
                                  "no soil has a strength that the stage \"" + now.scene.stage->name +
                                      "\" could reduce",
                                  "a material with model = " + laws_with_strength()));
        if (now.scene.stage->kind == StageKind::consolidate && !now.scene.water)
            findings.add(error_at(now.scene.stage->place, "stage", "dry soil does not consolidate",
                                  "a table [water], or kind = \"settle\""));
    }
    if (!findings.has_errors()) doubt_sands(stages, findings);
}

void keep_histories(std::vector<SceneReading>& stages)
{
    const auto for_each_law = [&](auto&& visit) {
        for (SceneReading& stage : stages)
            for (SceneMaterial& material : stage.scene.materials) visit(material.material.law);
    };
    bool is_asked_for = false;
    for_each_law([&](const SkeletonLaw& law) { is_asked_for = is_asked_for || keeps_history(law); });
    if (is_asked_for) for_each_law([](SkeletonLaw& law) { keep_history(law); });
}

void end_damping(std::vector<SceneReading>& stages)
{
    for (SceneReading& stage : stages) {
        if (!stage.scene.stage || stage.scene.stage->kind == StageKind::shake) continue;
        for (SceneMaterial& each : stage.scene.materials) each.material.law = undamped(each.material.law);
    }
}

std::vector<std::string> uncommon_keys(const Keys& before, const Keys& now, bool settles)
{
    std::vector<std::string> names;
    for (const std::string& path : differing_paths(before, now)) {
        const bool is_water = begins_with_one_of(path, still_water);
        if ((is_water && !settles) || begins_with_one_of(path, common)) names.push_back(path);
    }
    return names;
}

std::vector<std::string> changed_keys(const Keys& before, const Keys& now,
                                      const std::function<bool(const std::string&)>& is_told)
{
    const Values old = values_of(before), present = values_of(now);
    const auto shown = [](const std::string& value) { return value.empty() ? std::string("none") : value; };
    std::vector<std::string> lines;
    for (const std::string& path : differing_paths(before, now)) {
        if (is_told && !is_told(path)) continue;
        const auto found = present.find(path);
        const bool has_unit = found != present.end() && !found->second->unit.empty();
        lines.push_back(path + ": " + shown(value_of(old, path)) + " -> " + shown(value_of(present, path)) +
                        (has_unit ? " " + found->second->unit : ""));
    }
    return lines;
}

std::vector<bool> changed_soils(const Keys& before, const Keys& now, const std::vector<std::string>& regions)
{
    std::vector<bool> changed;
    for (const std::string& region : regions)
        changed.push_back(given_soil_keys(before, region) != given_soil_keys(now, region));
    return changed;
}

std::vector<bool> absent_soils(const Keys& keys, const std::vector<std::string>& regions)
{
    const Values values = values_of(keys);
    std::vector<bool> absent;
    for (const std::string& region : regions)
        absent.push_back(value_of(values, join_path({"regions", region, "soil"})) == "absent");
    return absent;
}

} // namespace quicksand
