#include "app/stages/run_origin.hpp"

#include "app/run/number_format.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/run_record.hpp"
#include "io/results/stage_table.hpp"
#include "io/scene/scene_keys.hpp"
#include "io/scene/stage_changes.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>

namespace quicksand {

namespace fs = std::filesystem;

namespace {

StageStart start_of(const Scene& scene)
{
    StageStart start;
    start.zero_pressures = true; // in a scene without stages the shaking begins here
    if (!scene.stage) return start;
    start.settles = settles(scene.stage->kind);
    start.zero_pressures = scene.stage->zero_pressures;
    start.zero_displacements = scene.stage->zero_displacements;
    return start;
}

/// Throws InputError where the scene differs from that of the results in what both have to share.
void require_common(const fs::path& folder, const std::vector<ResolvedKey>& before,
                    const std::vector<ResolvedKey>& now, bool settles)
{
    const std::vector<std::string> differing = uncommon_keys(before, now, settles);
    if (differing.empty()) return;
    std::string names;
    for (const std::string& name : differing) names += (names.empty() ? "" : ", ") + name;
    throw InputError("the run cannot go on from " + folder.string() + ", which has other values of " + names +
                     "\nexpected: the same drawing, grid, sampling, gravity and still water");
}

/// Whether a stage has left the water in the pores bear what came at once.
bool has_settled_undrained(const std::vector<ResolvedKey>& keys)
{
    return std::any_of(keys.begin(), keys.end(), [](const ResolvedKey& key) {
        return key.path.starts_with("stages.") && key.path.ends_with(".drainage") && key.value == "undrained";
    });
}

/// Soil settles drained: what its pores hold above the pressures of the stage's own water goes without a
/// trace.
std::string warn_of_lost_pressure(const Particles& drawn, const Particles& reached)
{
    constexpr double little = 0.02; // of the largest vertical stress of the grains
    if (drawn.pore_pressure.empty() || reached.pore_pressure.empty()) return "";
    std::map<std::int32_t, double> own; // of the particles by their lasting numbers [Pa]
    for (std::size_t p = 0; p < drawn.size(); ++p) own[drawn.identifier[p]] = drawn.pore_pressure[p];
    double lost = 0.0, stress = 0.0;
    for (std::size_t p = 0; p < reached.size(); ++p) {
        stress = std::max(stress, -reached.stress.yy[p]);
        if (const auto found = own.find(reached.identifier[p]); found != own.end())
            lost = std::max(lost, reached.pore_pressure[p] - found->second);
    }
    if (!(lost > little * stress)) return "";
    return fmt::format(
        "warning: soil settles drained in this stage: excess pore pressures of up to {} kPa are "
        "lost\nhint: a stage of kind = \"consolidate\" before it lets them go in time",
        short_number(1e-3 * lost, 3));
}

/// Whether the particle remembers that it has liquefied.
bool has_liquefied(const SkeletonLaw& law, const Particles& particles, std::size_t p)
{
    const std::size_t column = column_of(memory_of(law), "liquefied_shear");
    return column < std::min(memory_of(law).size(), particles.memory.size()) &&
           particles.memory[column][p] > 0.0;
}

/// Sand that is to settle after it has liquefied, and does not know that it has.
std::string warn_of_lost_history(const Problem& problem, const StageStart& start, const State& reached)
{
    if (!(reached.time > 0.0)) return "";
    const Particles& particles = reached.particles;
    bool lost = false;
    for (std::size_t p = 0; p < particles.size() && !lost; ++p) {
        const SkeletonLaw& law = problem.materials[static_cast<std::size_t>(particles.material[p])].law;
        const auto region = static_cast<std::size_t>(particles.region[p]);
        const bool is_new = region < start.changed_soils.size() && start.changed_soils[region];
        lost = !is_new && keeps_history(law) &&
               (start.settles ? has_liquefied(law, particles, p)
                              : particles.memory.size() < memory_of(law).size());
    }
    if (!lost) return "";
    return start.settles
               ? "warning: sand forgets its shaking where soil settles: a later stage does not compact it "
                 "for it"
                 "\nhint: stages that shake or consolidate keep the history of the sand"
               : "warning: the run before kept no history of the sand, which begins here: it does not settle "
                 "for having liquefied\nhint: run both as stages of one scene, or with the same keys of the "
                 "sand";
}

/// Ground that is to consolidate while it still moves from its shaking: the long steps let it coast.
std::string warn_of_motion(const Scene& scene, const State& reached)
{
    constexpr double lasting = 0.05; // [m/s]
    if (!scene.stage || scene.stage->kind != StageKind::consolidate) return "";
    double fastest = 0.0;
    for (std::size_t p = 0; p < reached.particles.size(); ++p)
        fastest = std::max(fastest, reached.particles.velocity_solid[p].norm());
    if (!(fastest > lasting)) return "";
    return fmt::format("warning: the ground moves at up to {} m/s where this stage of consolidation begins, "
                       "whose steps do not follow that"
                       "\nhint: let the stage of shaking before it go on until the ground rests",
                       short_number(fastest, 2));
}

} // namespace

fs::path folder_of_end(const std::string& from)
{
    if (fs::exists(from)) return with_end(from);
    const std::size_t colon = from.rfind(':');
    const fs::path results = from.substr(0, colon);
    if (colon == std::string::npos || !fs::exists(results))
        throw InputError("--from: there are no results " + results.string() +
                         "\nexpected: RESULTS or RESULTS:STAGE, as results/my_dike:gravity");
    const std::string stage = from.substr(colon + 1);
    const std::vector<StageRow> stages = read_stage_table(results);
    std::vector<std::string> names;
    for (const StageRow& row : stages) {
        if (row.name == stage) return results / stage;
        names.push_back(row.name);
    }
    throw InputError("--from: " + results.string() + " has no stage " + stage +
                     "\nexpected: " + (names.empty() ? "a run with stages" : one_of(names)));
}

void part_as_in(const fs::path& folder, SceneReading& reading)
{
    const RunRecord record = read_run_record(ResultsFolder{folder}.manifest());
    reading.parted_before = record.water_lines;
}

void resume_as_in(const fs::path& folder, SceneReading& reading)
{
    part_as_in(folder, reading);
    if (!reading.scene.scheme)
        reading.scene.scheme = read_run_record(ResultsFolder{folder}.manifest()).scheme;
}

Origin origin_from(const fs::path& folder, const std::vector<ResolvedKey>& now,
                   const AssembledCase& assembled)
{
    const ResultsFolder results{folder};
    const RunRecord record = read_run_record(results.manifest());
    if (record.status != "finished")
        throw InputError("the run in " + folder.string() + " has not ended well (" + record.status +
                         "): nothing can go on from it\nhint: let it reach its end first");
    const std::vector<ResolvedKey> before = read_scene_keys(results.scene_copy(), record.overrides);
    Origin origin;
    origin.start = start_of(assembled.scene);
    require_common(folder, before, now, origin.start.settles);
    origin.start.changed_soils = changed_soils(before, now, assembled.problem.region_names);
    origin.reached = read_checkpoint(results.checkpoint(), record.state_hash);
    const bool has_excess = origin.reached.time > 0.0 || has_settled_undrained(before);
    if (origin.start.settles && !settles_undrained(assembled.problem) && has_excess)
        origin.warnings.push_back(warn_of_lost_pressure(assembled.state.particles, origin.reached.particles));
    origin.warnings.push_back(warn_of_lost_history(assembled.problem, origin.start, origin.reached));
    origin.warnings.push_back(warn_of_motion(assembled.scene, origin.reached));
    std::erase(origin.warnings, "");
    return origin;
}

State end_as_state(const fs::path& folder, const SceneSetup& setup)
{
    Origin origin = origin_from(folder, setup.keys, setup.assembled);
    origin.start.settles = origin.start.zero_pressures = origin.start.zero_displacements = false;
    StagedRun run(setup.assembled.problem, setup.assembled.state, run_controls(setup.assembled.scene));
    run.go_on_from(std::move(origin.reached), origin.start);
    return run.state_of_body();
}

} // namespace quicksand
