#include "io/scene/scene_stages.hpp"

#include "io/keys/scene_units.hpp"
#include "io/scene/scene_variant.hpp"
#include "io/scene/stage_placement.hpp"
#include "io/tables/stage_keys.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace quicksand {

namespace {

using Kind = DocumentNode::Kind;

constexpr const char* stages_key = "stages";

/// A name that can be that of a folder, and of a key after --set without quotes.
bool is_plain(const std::string& name)
{
    return !name.empty() &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
               std::string::npos;
}

std::string text_of(const DocumentNode& table, std::string_view key)
{
    const DocumentNode* node = table.find(key);
    return node != nullptr && node->kind == Kind::text ? node->text : "";
}

void check_names(const DocumentNode& stages, Diagnostics& findings)
{
    // files of a run lie beside the folders of its stages
    constexpr const char* expected = "letters, digits, - and _, other than the names of a run's own folders";
    const std::vector<std::string> taken = {"checkpoint", "fields",   "grid",   "settling",
                                            "probes",     "pictures", "figures"};
    for (const DocumentNode& stage : stages.children) {
        if (!is_plain(stage.name) || std::find(taken.begin(), taken.end(), stage.name) != taken.end())
            findings.add(error_at(stage.name_place, "stage", "a stage cannot be called '" + stage.name + "'",
                                  expected, "its results are a folder of this name"));
    }
}

/// The table of this name, made where there is none.
DocumentNode& table_in(DocumentNode& document, const std::string& name, const SourcePlace& place)
{
    if (DocumentNode* node = document.find(name)) return *node;
    DocumentNode table;
    table.name = name;
    table.name_place = table.place = place;
    document.children.push_back(std::move(table));
    return document.children.back();
}

bool gives(const DocumentNode& stage, std::string_view table, std::string_view key)
{
    const DocumentNode* node = stage.find(table);
    return node != nullptr && node->find(key) != nullptr;
}

/// An end time of no account, for a stage that has no time.
void give_instant(DocumentNode& run)
{
    if (run.find("end_time") != nullptr) return;
    DocumentNode instant;
    instant.kind = Kind::integer;
    instant.number = static_cast<double>(instant.integer = 1);
    run.set("end_time", instant);
}

/// Put what a stage changes into the document: it holds for the later stages as well.
void change(const DocumentNode& stage, DocumentNode& document)
{
    DocumentNode changes;
    for (const DocumentNode& node : stage.children)
        if (node.kind == Kind::table) changes.children.push_back(node);
    const bool seeps = text_of(stage, "kind") == word_of_kind(StageKind::seepage);
    if (seeps && !gives(stage, "water", "initial_flow"))
        table_in(changes, "water", stage.place).set("initial_flow", text_value("seepage", stage.place));
    merge_variant(std::move(changes), document);
    place_regions(stage, document);
}

/// Whether the value is a duration; where it is not, the check of the stage's own keys tells.
bool is_duration(const DocumentNode& node)
{
    if (node.kind != Kind::text)
        return (node.kind == Kind::integer || node.kind == Kind::number) && node.number > 0.0;
    const auto written = split_quantity(node.text);
    return written && to_si(*written, Dimension::time).value_or(0.0) > 0.0;
}

/// Whether a stage moves a curve, or not all have the same sides tied: columns of cells are then not all
/// equal, or not in all stages.
bool parts_columns(const DocumentNode& document)
{
    std::map<std::string, std::string> conditions; // of curves, for their soil
    const auto take = [&](const DocumentNode& part) {
        const DocumentNode* boundaries = part.find("boundaries");
        if (boundaries == nullptr || boundaries->kind != Kind::table) return;
        for (const DocumentNode& boundary : boundaries->children) {
            const std::string soil = boundary.kind == Kind::table ? text_of(boundary, "soil") : "";
            if (!soil.empty()) conditions[boundary.name] = soil;
        }
    };
    const auto names_of = [&](std::string_view soil) {
        std::set<std::string> names;
        for (const auto& [name, condition] : conditions)
            if (condition == soil) names.insert(name);
        return names;
    };
    take(document);
    std::optional<std::set<std::string>> tied; // in the stages before
    for (const DocumentNode& stage : document.find(stages_key)->children) {
        take(stage);
        const std::set<std::string> here = names_of("tied");
        if (!names_of("moving").empty() || tied.value_or(here) != here) return true;
        tied = here;
    }
    return false;
}

/// What a kind of stage has no use for, and what it cannot do without.
void suit_kind(const DocumentNode& stage, bool is_first, DocumentNode& document)
{
    const auto kind = stage_kind(text_of(stage, "kind"));
    if (!kind) { // the check of the keys tells
        give_instant(table_in(document, "run", stage.place));
        return;
    }
    if (*kind != StageKind::shake) document.remove("motion");
    if (settles(*kind)) {
        table_in(document, "relaxation", stage.place);
    } else if (*kind != StageKind::shake || !is_first) {
        document.remove("relaxation");
    }
    if (*kind == StageKind::consolidate) {
        DocumentNode& analysis = table_in(document, "analysis", stage.place);
        if (!gives(stage, "analysis", "scheme")) analysis.set("scheme", text_value("implicit", stage.place));
        if (DocumentNode* output = document.find("output"); output != nullptr) {
            for (const char* interval : {"frame_interval", "probe_interval", "history_interval"})
                if (!gives(stage, "output", interval)) output->remove(interval); // that of the shaking
        }
    }
    DocumentNode& run = table_in(document, "run", stage.place);
    const DocumentNode* duration = stage.find("duration");
    if (takes_time(*kind) && duration != nullptr && is_duration(*duration)) {
        run.set("end_time", *duration);
    } else if (!takes_time(*kind) || duration != nullptr) {
        give_instant(run);
    }
}

} // namespace

void name_stages(DocumentNode& document, Diagnostics& findings)
{
    DocumentNode* stages = document.find(stages_key);
    if (stages == nullptr) return;
    if (stages->kind == Kind::table) check_names(*stages, findings);
    if (stages->kind != Kind::array) return;
    DocumentNode named;
    named.name = stages->name;
    named.name_place = stages->name_place;
    named.place = stages->place;
    for (DocumentNode& item : stages->children) {
        if (item.kind != Kind::table) {
            findings.add(
                error_at(item.place, "type", "a stage is a table", "lines [[stages]], each with its keys"));
            continue;
        }
        const std::string name = text_of(item, "name");
        const DocumentNode* written = item.find("name");
        item.name = name.empty() ? text_of(item, "kind") : name;
        item.name_place = written != nullptr ? written->place : item.place;
        item.remove("name");
        if (named.find(item.name) != nullptr)
            findings.add(error_at(item.name_place, "stage", "there are two stages '" + item.name + "'",
                                  "a name for each stage",
                                  "give one of them a name, as name = \"" + item.name + "_2\""));
        named.children.push_back(std::move(item));
    }
    check_names(named, findings);
    *stages = std::move(named);
}

std::vector<std::string> stage_names(const DocumentNode& document)
{
    std::vector<std::string> names;
    const DocumentNode* stages = document.find(stages_key);
    if (stages == nullptr || stages->kind != Kind::table) return names;
    for (const DocumentNode& stage : stages->children)
        if (stage.kind == Kind::table) names.push_back(stage.name);
    return names;
}

DocumentNode document_of_stage(const DocumentNode& document, const std::string& name)
{
    DocumentNode result = document;
    empty_unplaced_regions(result);
    // all stages have the same particles: one column stands for all in every one of them or in none
    if ((places_soil(document) || parts_columns(document)) && !gives(result, "analysis", "columns"))
        table_in(result, "analysis", document.find(stages_key)->place)
            .set("columns", text_value("all", document.find(stages_key)->place));
    const DocumentNode stage = *document.find(stages_key)->find(name);
    const bool is_first = stage_names(document).front() == name;
    for (const DocumentNode& earlier : document.find(stages_key)->children) {
        change(earlier, result);
        if (earlier.name == name) break;
    }
    suit_kind(stage, is_first, result);
    DocumentNode own = stage;
    std::erase_if(own.children, [](const DocumentNode& node) { return node.kind == Kind::table; });
    result.find(stages_key)->children = {own};
    return result;
}

} // namespace quicksand
