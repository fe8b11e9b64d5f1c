#include "io/results/run_record.hpp"

#include "io/files/atomic_file.hpp"
#include "solver/base/failure.hpp"
#include "solver/step_length/time_step.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace quicksand {

namespace {

using Json = nlohmann::ordered_json; // the summary in the order of the file

std::string text_of(const Json& json, const char* name)
{
    const auto found = json.find(name);
    return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

double number_of(const Json& json, const char* name)
{
    const auto found = json.find(name);
    return found != json.end() && found->is_number() ? found->get<double>() : 0.0;
}

/// The values of tables; what is largest in the last frame is none.
std::vector<SummaryValue> read_summary(const Json& json)
{
    std::vector<SummaryValue> values;
    const auto summary = json.find("summary");
    if (summary == json.end() || !summary->is_object()) return values;
    for (const auto& [table, columns] : summary->items()) {
        if (!columns.is_object() || table == "last_frame") continue;
        for (const auto& [column, value] : columns.items())
            if (value.is_object() && value.contains("peak"))
                values.push_back({table, column, number_of(value, "peak"), number_of(value, "peak_time_s"),
                                  number_of(value, "final")});
    }
    return values;
}

std::optional<std::vector<WaterLine>> read_water_lines(const Json& json)
{
    const auto found = json.find("water_lines_m");
    if (found == json.end() || !found->is_array()) return std::nullopt;
    std::vector<WaterLine> lines;
    for (const Json& points : *found) {
        WaterLine line;
        for (const Json& point : points)
            if (point.is_array() && point.size() == 2 && point[0].is_number() && point[1].is_number())
                line.points.emplace_back(point[0].get<double>(), point[1].get<double>());
        if (!line.points.empty()) lines.push_back(std::move(line));
    }
    return lines;
}

std::optional<TimeScheme> scheme_named(const std::string& name)
{
    for (const TimeScheme scheme :
         {TimeScheme::explicit_steps, TimeScheme::semi_implicit, TimeScheme::implicit})
        if (name == name_of(scheme)) return scheme;
    return std::nullopt;
}

} // namespace

RunRecord read_run_record(const std::filesystem::path& manifest)
{
    if (!std::filesystem::exists(manifest))
        throw InputError("there are no results in " + manifest.parent_path().string() +
                         "\nhint: name the results folder of a run, which holds run_manifest.json");
    const auto json = Json::parse(read_text(manifest), nullptr, false);
    if (!json.is_object()) throw InputError(manifest.string() + " is damaged: it is no JSON");
    RunRecord record;
    record.version = text_of(json, "version");
    record.status = text_of(json, "status");
    record.exit_reason = text_of(json, "exit_reason");
    record.verdict = text_of(json, "verdict");
    record.scene_file = text_of(json, "scene_file");
    record.scene_hash = text_of(json, "scene_hash");
    record.state_hash = text_of(json, "state_hash");
    record.start_time = text_of(json, "start_time");
    record.end_time = text_of(json, "end_time");
    record.wall_time = number_of(json, "wall_time_s");
    record.simulated_time = number_of(json, "simulated_time_s");
    record.steps = number_of(json, "steps");
    record.particles = number_of(json, "particles");
    record.threads = number_of(json, "threads");
    record.step_halvings = number_of(json, "step_halvings");
    record.summary = read_summary(json);
    record.water_lines = read_water_lines(json);
    record.scheme = scheme_named(text_of(json, "scheme"));
    if (json.contains("overrides") && json["overrides"].is_array())
        for (const auto& word : json["overrides"])
            if (word.is_string()) record.overrides.push_back(word.get<std::string>());
    if (json.contains("largest_errors") && json["largest_errors"].is_object())
        for (const auto& [name, value] : json["largest_errors"].items())
            record.largest_errors[name] = value.is_number() ? value.get<double>() : std::nan("");
    return record;
}

} // namespace quicksand
