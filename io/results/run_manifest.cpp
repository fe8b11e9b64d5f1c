#include "io/results/run_manifest.hpp"

#include "geometry/drawing/geo_script.hpp"
#include "io/files/atomic_file.hpp"
#include "io/results/output_names.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

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

} // namespace

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
    manifest.scene_file = scene.file;
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
    if (!std::filesystem::exists(path)) return std::nullopt;
    const auto json = nlohmann::json::parse(read_text(path), nullptr, false);
    if (!json.is_object() || !json.contains("status")) return std::nullopt;
    for (const RunStatus status :
         {RunStatus::running, RunStatus::finished, RunStatus::failed, RunStatus::stopped})
        if (json["status"] == name_of(status)) return status;
    return std::nullopt;
}

void write_run_manifest(const std::filesystem::path& path, const RunManifest& manifest)
{
    nlohmann::ordered_json json;
    json["program"] = "Quicksand";
    json["version"] = program_version();
    json["status"] = name_of(manifest.status);
    json["exit_reason"] = manifest.exit_reason;
    json["scene_file"] = manifest.scene_file.string();
    json["scene_hash"] = manifest.scene_hash;
    json["scene_hash_kind"] = "FNV-1a 64 of the text and the overrides";
    json["overrides"] = manifest.overrides;
    json["input_hashes"] = nlohmann::ordered_json::object();
    for (const InputFile& input : manifest.inputs) json["input_hashes"][input.key] = input.hash;
    json["threads"] = manifest.threads;
    if (manifest.resumed_at) json["resumed_at_s"] = *manifest.resumed_at;
    json["start_time"] = manifest.start_time;
    json["end_time"] = manifest.end_time;
    json["wall_time_s"] = manifest.wall_time;
    json["simulated_time_s"] = manifest.simulated_time;
    json["steps"] = manifest.steps;
    json["particles"] = manifest.particles;
    json["particle_steps_per_s"] = particle_steps_per_second(manifest);
    json["compiler"] = compiler_name();
    json["build_type"] = QUICKSAND_BUILD_TYPE;
    json["processor"] = processor_name();
    json["host"] = host_name();
    json["outputs"] = manifest.outputs;
    // A file name need not be UTF-8; that must not end a run.
    write_atomically(path, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

} // namespace quicksand
