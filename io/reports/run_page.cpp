#include "io/reports/run_page.hpp"

#include "io/files/atomic_file.hpp"
#include "io/frames/vtk_series.hpp"
#include "io/keys/scene_units.hpp"
#include "io/pictures/picture_set.hpp"
#include "io/reports/crest_check.hpp"
#include "io/reports/html_page.hpp"
#include "io/reports/page_pictures.hpp"
#include "io/reports/review_checklist.hpp"
#include "io/reports/summary_reading.hpp"
#include "io/results/results_folder.hpp"
#include "io/results/run_record.hpp"
#include "io/results/stage_table.hpp"
#include "io/scene/scene_keys.hpp"
#include "solver/base/failure.hpp"
#include "solver/measure/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

namespace fs = std::filesystem;
using Rows = std::vector<std::vector<std::string>>;

std::string number(double value, const char* unit = "")
{
    return std::isnan(value) ? "no number" : fmt::format("{:.4g}{}", value, unit);
}

std::string paragraph(std::string_view text, std::string_view kind = "")
{
    return fmt::format("<p class=\"{}\">{}</p>\n", kind, html_text(text));
}

std::string verdict_text(const RunRecord& record)
{
    const std::string state = "The run is " + (record.status.empty() ? "of unknown state" : record.status) +
                              (record.exit_reason.empty() ? "" : ": " + record.exit_reason) + ".";
    if (record.verdict.empty())
        return paragraph(state + " It has no verdict: its balances are judged at its end.", "bad");
    return paragraph(state + " Verdict on its balances: " + record.verdict + ".", record.verdict);
}

std::string run_table(const RunRecord& record)
{
    Rows rows{{"run", ""},
              {"scene", record.scene_file.string()},
              {"hash of the scene", record.scene_hash},
              {"program", "Quicksand " + record.version},
              {"begun, ended", record.start_time + ", " + record.end_time},
              {"time reached", time_text(record.simulated_time)},
              {"particles", fmt::format("{:.0f}", record.particles)},
              {"steps, wall time", fmt::format("{:.0f}, {:.4g} s", record.steps, record.wall_time)}};
    for (const std::string& words : record.overrides) rows.push_back({"--set", words});
    return html_table(rows);
}

/// What the stages of the run came to, of which the page shows one; nothing where the results are no stage.
std::string stages_section(const fs::path& results)
{
    const fs::path shown = fs::canonical(results);
    const std::vector<StageRow> stages = read_stage_table(shown.parent_path());
    const auto is_shown = [&](const StageRow& stage) { return stage.name == shown.filename(); };
    if (std::none_of(stages.begin(), stages.end(), is_shown)) return "";
    Rows rows{{"stage", "kind", "state", "from", "over", "factor of safety"}};
    for (const StageRow& stage : stages)
        rows.push_back({stage.name, stage.kind, stage.status, time_text(stage.start),
                        time_text(stage.duration),
                        stage.factor_of_safety ? number(*stage.factor_of_safety) : ""});
    return html_section("Stages", html_table(rows) + paragraph("This page is about the stage " +
                                                               shown.filename().string() + "."));
}

std::string crest_text(const fs::path& results, const std::optional<double>& required)
{
    const std::optional<CrestCheck> crest = check_crest(results);
    if (!crest)
        return paragraph("The results have no frames or no crest settlement: the crest is not judged.");
    Rows rows{{"crest", ""},
              {"highest point at the start", number(crest->before, " m")},
              {"settlement of the crest since then", number(crest->settlement, " m")},
              {"crest at the end", number(crest->after(), " m")}};
    if (required) {
        rows.push_back({"required height", number(*required, " m")});
        rows.push_back({"left above it", number(crest->after() - *required, " m")});
    }
    std::string html = html_table(rows);
    if (crest->is_unseen)
        html += paragraph("In small strain soil that settles in later stages keeps the shape as drawn, also "
                          "in pictures; the heights here count its total displacement.");
    if (!required) return html + paragraph("No required height was given (--required-height).");
    const bool kept = crest->after() >= *required;
    return html + paragraph(kept ? "The crest keeps the required height."
                                 : "The crest falls below the required height.",
                            kept ? "good" : "bad");
}

std::string extremes_text(const RunSummary& summary)
{
    Rows values{{"history or probe", "quantity", "peak", "at s", "at the end"}};
    for (const SummaryValue& value : summary.values)
        values.push_back({value.table, value.column, number(value.peak), number(value.peak_time),
                          number(value.final_value)});
    Rows places{{"largest in the last frame", "value", "at x, y"}};
    for (const SummaryPlace& place : summary.places)
        places.push_back({place.field, number(place.value) + (place.unit.empty() ? "" : " " + place.unit),
                          fmt::format("{} m, {} m", coordinate_text(place.x), coordinate_text(place.y))});
    return (places.size() > 1 ? html_table(places) : "") + (values.size() > 1 ? html_table(values) : "");
}

std::string balances_text(const RunRecord& record)
{
    Rows rows{{"quantity", "largest", "good up to", "usable up to", "a large one says"}};
    for (const Criterion& criterion : verdict_criteria()) {
        const auto found = record.largest_errors.find(std::string(criterion.quantity));
        if (found == record.largest_errors.end()) continue;
        rows.push_back({found->first, number(found->second), number(criterion.good),
                        std::isinf(criterion.usable) ? "" : number(criterion.usable),
                        std::string(criterion.meaning)});
    }
    std::string html =
        rows.size() > 1 ? html_table(rows) : paragraph("The balances have not been judged yet.");
    if (record.step_halvings > 0.0)
        html += paragraph(
            fmt::format("The watchdog has halved the time step {:.0f} times: the chosen one was too long.",
                        record.step_halvings),
            "usable");
    return html;
}

std::string source_of(const fs::path& file, const std::string& summary)
{
    return fs::exists(file) ? html_source(summary, read_text(file)) : "";
}

/// The field of the animation: the one asked for, or ru, in a dry scene the displacement.
std::string animated_field(const ReportRequest& request)
{
    const std::vector<FrameEntry> frames =
        read_series_index(ResultsFolder{request.results}.particle_series());
    if (frames.empty()) throw InputError(request.results.string() + ": the run has no frames yet");
    const std::vector<std::string> known =
        drawable_fields(read_particle_frame(request.results / frames.back().file));
    const auto has = [&](const std::string& name) {
        return std::find(known.begin(), known.end(), name) != known.end();
    };
    if (request.field.empty()) return has("ru") ? "ru" : "displacement";
    if (!has(request.field))
        throw InputError(fmt::format("there is no field '{}' in the results. Available: {}", request.field,
                                     fmt::join(known, ", ")));
    return request.field;
}

} // namespace

std::string run_page(const ReportRequest& request)
{
    const ResultsFolder folder{request.results};
    const RunRecord record = read_run_record(folder.manifest());
    const std::string field = animated_field(request);
    const ShortLivedFolder place;
    const std::string motion = motion_pictures(request.results, place.path(), request.notify);
    const std::string title = scene_title(request.results);
    const std::string heading = title.empty() ? record.scene_file.filename().string() : title;

    std::string body = "<h1>" + html_text(heading) + "</h1>\n" + verdict_text(record) + run_table(record);
    body += stages_section(request.results);
    body += html_section("Crest", crest_text(request.results, request.required_height));
    body += html_section("Section", section_picture(request.results, place.path()));
    body += html_section("Motion of the base", motion.empty() ? paragraph("The base is at rest.") : motion);
    body += html_section("Extremes", extremes_text(summarize_run(request.results)));
    body += html_section("In time", field_animation(request.results, field, place.path()));
    body += html_section("Pictures", result_pictures(request.results, place.path(), request.notify));
    body += html_section("Balances", balances_text(record));
    body += html_section("Reviewer's checklist", review_checklist());
    body += html_section("Scene and log",
                         source_of(folder.scene_copy(), "scene.toml") + source_of(folder.log(), "log.txt"));
    return html_page(heading, body);
}

} // namespace quicksand
