#include "io/results/run_manifest.hpp"

#include "geometry/drawing/geo_script.hpp"
#include "io/files/atomic_file.hpp"
#include "io/results/output_names.hpp"
#include "solver/base/failure.hpp"
#include "solver/measure/quantities.hpp"
#include "solver/step_length/time_step.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <array>
#include <cmath>
#include <ctime>
#include <fstream>

namespace quicksand {

namespace {

const char* name_of(RunStatus status)
{
    switch (status) {
    case RunStatus::running:
        return "running";
    case RunStatus::finished:
        return "finished";
    case RunStatus::failed:
        return "failed";
    case RunStatus::stopped:
        return "stopped";
    }
    return "";
}

constexpr std::uint64_t empty_hash = 14695981039346656037ULL;

void add_to_hash(std::uint64_t& hash, std::string_view text)
{
    constexpr std::uint64_t prime = 1099511628211ULL;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= prime;
    }
}

std::string host_name()
{
    char name[256] = "";
    return gethostname(name, sizeof(name) - 1) == 0 ? name : "";
}

std::string compiler_name()
{
#if defined(__clang__)
    return std::string("Clang ") + __clang_version__;
#else
    return std::string("GCC ") + __VERSION__;
#endif
}

/// Whether the key names a file that the run depends on.
bool names_input(std::string_view key)
{
    return key == "geometry.file" || key == "motion.file" ||
           (key.starts_with("boundaries.") && key.ends_with(".history"));
}

double particle_steps_per_second(const RunManifest& manifest)
{
    if (manifest.wall_time <= 0.0) return 0.0;
    return static_cast<double>(manifest.particles) * static_cast<double>(manifest.steps) / manifest.wall_time;
}

/// Discarded where the file is missing or damaged.
nlohmann::json read_json(const std::filesystem::path& path)
{
    if (!std::filesystem::exists(path)) return nlohmann::json(nlohmann::json::value_t::discarded);
    return nlohmann::json::parse(read_text(path), nullptr, false);
}

using Json = nlohmann::ordered_json;

/// What stands in the file.
struct Field {
    std::string_view name, meaning;
    Json (*value)(const RunManifest&);
};

constexpr std::string_view resumed_at = "resumed_at_s";

Json hashes_of(const RunManifest& manifest)
{
    Json hashes = Json::object();
    for (const InputFile& input : manifest.inputs) hashes[input.key] = input.hash;
    return hashes;
}

Json water_lines_of(const RunManifest& manifest)
{
    Json lines = Json::array();
    for (const WaterLine& line : manifest.water_lines) {
        Json points = Json::array();
        for (const Vector2& point : line.points) points.push_back({point.x(), point.y()});
        lines.push_back(std::move(points));
    }
    return lines;
}

Json errors_of(const RunManifest& manifest)
{
    Json errors = Json::object();
    for (const Finding& finding : manifest.findings)
        errors[std::string(finding.criterion->quantity)] = finding.worst;
    return errors;
}

/// Tables by name, their columns with peak, time and final value; then the last frame.
Json summary_of(const RunManifest& manifest)
{
    const RunSummary& summary = manifest.summary;
    Json json = Json::object();
    for (const SummaryValue& value : summary.values)
        json[value.table][value.column] = {
            {"peak", value.peak}, {"peak_time_s", value.peak_time}, {"final", value.final_value}};
    if (summary.places.empty()) return json;
    Json& frame = json["last_frame"];
    frame["time_s"] = summary.frame_time;
    for (const SummaryPlace& place : summary.places)
        frame[place.field + unit_suffix(place.unit)] = {
            {"largest", place.value}, {"x_m", place.x}, {"y_m", place.y}};
    return json;
}

// One row, one field: the formatter would make it three lines.
// clang-format off
const std::array fields = {
    Field{"program", "Quicksand", [](const RunManifest&) { return Json("Quicksand"); }},
    Field{"version", "of the program", [](const RunManifest&) { return Json(program_version()); }},
    Field{"status", "running, finished, failed or stopped", [](const RunManifest& m) { return Json(name_of(m.status)); }},
    Field{"exit_reason", "one line; empty while the run goes on", [](const RunManifest& m) { return Json(m.exit_reason); }},
    Field{"scene_file", "the scene that was run", [](const RunManifest& m) { return Json(m.scene_file.string()); }},
    Field{"scene_hash", "of its text and the overrides", [](const RunManifest& m) { return Json(m.scene_hash); }},
    Field{"state_hash", "of the keys that the state hangs on: all but those that end a stage or report on it", [](const RunManifest& m) { return Json(m.state_hash); }},
    Field{"scene_hash_kind", "how it is computed", [](const RunManifest&) { return Json("FNV-1a 64 of the text and the overrides"); }},
    Field{"overrides", "keys replaced with --set", [](const RunManifest& m) { return Json(m.overrides); }},
    Field{"input_hashes", "of the files that keys of the scene name", hashes_of},
    Field{"water_lines_m", "lines of water, still or flowing steadily in this or another stage, at which particles are parted", water_lines_of},
    Field{"scheme", "explicit, semi-implicit or implicit: what \"auto\" has chosen, or the scene", [](const RunManifest& m) { return Json(name_of(m.scheme)); }},
    Field{"threads", "of the run", [](const RunManifest& m) { return Json(m.threads); }},
    Field{resumed_at, "time of the checkpoint that the run went on from; left out where it did not", [](const RunManifest& m) { return Json(m.resumed_at.value_or(0.0)); }},
    Field{"start_time", "UTC", [](const RunManifest& m) { return Json(m.start_time); }},
    Field{"end_time", "UTC; empty while the run goes on", [](const RunManifest& m) { return Json(m.end_time); }},
    Field{"wall_time_s", "of this process", [](const RunManifest& m) { return Json(m.wall_time); }},
    Field{"simulated_time_s", "time that the run has reached", [](const RunManifest& m) { return Json(m.simulated_time); }},
    Field{"steps", "taken by this process", [](const RunManifest& m) { return Json(m.steps); }},
    Field{"particles", "computed", [](const RunManifest& m) { return Json(m.particles); }},
    Field{"particle_steps_per_s", "particles times steps over the wall time", [](const RunManifest& m) { return Json(particle_steps_per_second(m)); }},
    Field{"step_halvings", "how often the watchdog has halved the step: 0 where the chosen one held", [](const RunManifest& m) { return Json(m.step_halvings); }},
    Field{"verdict", "good, usable or bad, by the largest errors; empty before the end", [](const RunManifest& m) { return Json(m.findings.empty() ? "" : name_of(worst_grade(m.findings))); }},
    Field{"largest_errors", "of the balances and checkerboards over the run", errors_of},
    Field{"summary", "peak, time of the peak and final value of what the pictures of history and probes show; largest values in the last frame and where; empty before the end", summary_of},
    Field{"compiler", "that built the program", [](const RunManifest&) { return Json(compiler_name()); }},
    Field{"build_type", "of the program", [](const RunManifest&) { return Json(QUICKSAND_BUILD_TYPE); }},
    Field{"processor", "of the machine", [](const RunManifest&) { return Json(processor_name()); }},
    Field{"host", "name of the machine", [](const RunManifest&) { return Json(host_name()); }},
    Field{"outputs", "files that the run writes, relative to the folder", [](const RunManifest& m) { return Json(m.outputs); }},
};
// clang-format on

} // namespace

std::vector<DocumentedName> manifest_fields()
{
    std::vector<DocumentedName> names;
    for (const Field& field : fields) names.push_back({field.name, field.meaning});
    return names;
}

std::string program_version()
{
    return QUICKSAND_VERSION;
}

std::string processor_name()
{
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return {};
}

std::string text_hash(std::string_view text)
{
    return scene_hash(text, {});
}

std::string scene_hash(std::string_view text, const std::vector<std::string>& overrides)
{
    std::uint64_t hash = empty_hash;
    add_to_hash(hash, text);
    for (const std::string& override_text : overrides) {
        add_to_hash(hash, std::string_view("\0", 1));
        add_to_hash(hash, override_text);
    }
    return fmt::format("{:016x}", hash);
}

std::vector<InputFile> input_files(const Scene& scene, const std::vector<ResolvedKey>& keys)
{
    std::vector<InputFile> inputs;
    for (const ResolvedKey& key : keys) {
        if (!key.given || !names_input(key.path)) continue;
        const std::filesystem::path file = scene.file.parent_path() / key.value;
        const bool is_drawing = file.extension() == ".geo" || file.extension() == ".geo_unrolled";
        for (const std::filesystem::path& opened : is_drawing ? opened_files(file) : std::vector{file}) {
            const std::filesystem::path name = opened.lexically_relative(file.parent_path());
            const std::string key_of_opened = opened == file ? key.path : key.path + " > " + name.string();
            inputs.push_back({key_of_opened, opened, text_hash(read_text(opened))});
        }
    }
    return inputs;
}

void require_same_inputs(const std::filesystem::path& manifest, const std::vector<InputFile>& inputs)
{
    if (!std::filesystem::exists(manifest)) return;
    const auto json = nlohmann::json::parse(read_text(manifest), nullptr, false);
    if (!json.is_object() || !json.contains("input_hashes")) return;
    const nlohmann::json& hashes = json["input_hashes"];
    for (const InputFile& input : inputs) {
        const auto former = hashes.find(input.key);
        if (former == hashes.end() || *former == input.hash) continue;
        throw InputError(input.file.string() + ": the file has changed since the run began (" + input.key +
                         ", hash " + input.hash + "; " + manifest.string() + " has " + former->dump() +
                         "). Resume with the unchanged file, or begin anew with --overwrite");
    }
}

std::string utc_now()
{
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&now, &parts);
    char text[32] = "";
    std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

RunManifest begin_manifest(const Scene& scene, const std::vector<std::string>& overrides, int threads,
                           std::size_t particles)
{
    RunManifest manifest;
    manifest.scene_file = std::filesystem::absolute(scene.file).lexically_normal();
    manifest.scene_hash = scene_hash(scene.text, overrides);
    manifest.overrides = overrides;
    manifest.threads = threads;
    manifest.start_time = utc_now();
    manifest.particles = particles;
    manifest.outputs = output_names(scene);
    return manifest;
}

std::optional<RunStatus> read_run_status(const std::filesystem::path& path)
{
    const auto json = read_json(path);
    if (!json.is_object() || !json.contains("status")) return std::nullopt;
    for (const RunStatus status :
         {RunStatus::running, RunStatus::finished, RunStatus::failed, RunStatus::stopped})
        if (json["status"] == name_of(status)) return status;
    return std::nullopt;
}

double read_step_halvings(const std::filesystem::path& path)
{
    const auto json = read_json(path);
    const bool tells = json.is_object() && json.contains("step_halvings");
    return tells && json["step_halvings"].is_number() ? json["step_halvings"].get<double>() : std::nan("");
}

void write_run_manifest(const std::filesystem::path& path, const RunManifest& manifest)
{
    nlohmann::ordered_json json;
    for (const Field& field : fields) {
        if (field.name != resumed_at || manifest.resumed_at)
            json[std::string(field.name)] = field.value(manifest);
    }
    // A file name need not be UTF-8; that must not end a run.
    write_atomically(path, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

} // namespace quicksand
