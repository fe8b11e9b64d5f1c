#include "io/tables/stage_keys.hpp"

#include "io/keys/scene_words.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace quicksand {

namespace {

constexpr WordList<StageKind, 5> stage_kind_words = {{
    {"settle", StageKind::settle},
    {"seepage", StageKind::seepage},
    {"shake", StageKind::shake},
    {"consolidate", StageKind::consolidate},
    {"stability", StageKind::stability},
}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 2> pressures_by_kind = {{
    {"shake", "zero"},
    {"consolidate", "kept"},
}};

} // namespace

std::vector<SceneKey> stage_keys()
{
    using enum ValueType;
    constexpr Interval positive{.lower = 0.0, .lower_open = true};
    const Condition in_time{"kind", {"shake", "consolidate"}};
    const Condition with_duration{"kind", {"shake", "consolidate", "seepage"}};
    const Condition in_search{"kind", {"stability"}};
    const Condition settling{"kind", {"settle"}};
    const Condition at_rest{"kind", {"settle", "seepage"}};
    // One row, one key: the formatter would make it ten lines.
    // clang-format off
    return {
        {.pattern = "stages", .type = named_tables, .default_note = "one run: settling where there is [relaxation], then shaking",
         .doc = "Stages of the scene, each written as [[stages]], in their order. Each goes on from the end of the one before."},
        {.pattern = "stages.*", .type = table,
         .doc = "One stage. Tables of the scene within it, as [stages.water] or [stages.boundaries.river], hold from it on."},
        {.pattern = "stages.*.kind", .type = word, .required = true, .words = {"settle", "seepage", "shake", "consolidate", "stability"},
         .doc = "Settle under gravity, with still water or in the steady flow between heads; shake; let excess pore pressures go in long steps; find the factor of safety."},
        {.pattern = "stages.*.duration", .dimension = Dimension::time, .default_note = "run.end_time; with seepage no time but the steady flow", .allowed = positive,
         .when = with_duration, .doc = "Length of the stage, whose time counts from its start; loads, walls that move and outer water go on where the stage leaves them as they were. With seepage the water flows for so long from where the stage before has left it, while heads rise and fall and pores fill and drain."},
        {.pattern = "stages.*.drainage", .type = word, .default_value = "drained", .words = {"drained", "undrained"}, .when = settling,
         .doc = "Whether water leaves the pores while soil settles, or stays and bears what weight and loads come at once: its excess pressure goes in a stage that consolidates."},
        {.pattern = "stages.*.place", .type = text_list, .default_note = "no soil is placed", .when = at_rest,
         .doc = "Regions whose soil is placed at the start of the stage: free of stress, up to the height drawn, on the ground as it has settled. Before that they have no soil."},
        {.pattern = "stages.*.remove", .type = text_list, .default_note = "no soil is removed", .when = at_rest,
         .doc = "Regions whose soil is excavated at the start of the stage; a later stage can place new soil there."},
        {.pattern = "stages.*.displacements", .type = word, .default_value = "kept", .words = {"kept", "zero"}, .when = in_time,
         .doc = "Whether displacements and strains go on from the stage before; after settling they are zero."},
        {.pattern = "stages.*.excess_pressures", .type = word, .derived = {.sibling = "kind", .choices = pressures_by_kind},
         .words = {"kept", "zero"}, .when = in_time,
         .doc = "Whether ru and excess pore pressures count on from the stage before, or from the start of this one."},
        {.pattern = "stages.*.residual_strength", .default_note = "what friction and effective stress allow", .allowed = positive,
         .plausible = {0.02, 0.4}, .when = in_search,
         .doc = "S_r / sigma'_v0: undrained strength of liquefied sand over its vertical effective stress before the shaking."},
        {.pattern = "stages.*.liquefied_ru", .default_value = 0.8, .allowed = {.lower = 0.0, .upper = 1.0, .lower_open = true},
         .when = in_search, .doc = "Least ru of sand that has its residual strength."},
        {.pattern = "stages.*.seismic_coefficient", .default_value = 0.0, .allowed = {.lower = -2.0, .upper = 2.0}, .when = in_search,
         .doc = "Horizontal force over weight, positive towards +x (pseudo-static)."},
    };
    // clang-format on
}

std::optional<SceneStage> read_stage(const SceneValues& values)
{
    const std::vector<NamedTable>& stages = values.tables_named("stages");
    if (stages.empty()) return std::nullopt;
    const NamedTable& table = stages.front();
    SceneStage stage;
    stage.name = table.name;
    stage.place = table.place;
    stage.kind = word_of(stage_kind_words, values.text(table.path + ".kind"));
    if (stage.kind == StageKind::seepage) stage.flow_duration = values.find<double>(table.path + ".duration");
    stage.keeps_pressures = values.text(table.path + ".drainage") == "undrained";
    stage.zero_displacements = values.text(table.path + ".displacements") == "zero";
    stage.residual_strength = values.number(table.path + ".residual_strength");
    stage.liquefied_ru = values.number(table.path + ".liquefied_ru");
    stage.seismic_coefficient = values.number(table.path + ".seismic_coefficient");
    stage.zero_pressures = values.text(table.path + ".excess_pressures") == "zero";
    return stage;
}

std::optional<StageKind> stage_kind(std::string_view word)
{
    const auto found = std::find_if(stage_kind_words.begin(), stage_kind_words.end(),
                                    [&](const auto& entry) { return entry.first == word; });
    if (found == stage_kind_words.end()) return std::nullopt;
    return found->second;
}

std::string_view word_of_kind(StageKind kind)
{
    const auto found = std::find_if(stage_kind_words.begin(), stage_kind_words.end(),
                                    [&](const auto& entry) { return entry.second == kind; });
    return found->first;
}

} // namespace quicksand
