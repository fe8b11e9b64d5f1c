#include "io/sweeps/sweep_file.hpp"

#include "geometry/drawing/nearest_name.hpp"
#include "io/keys/scene_check.hpp"
#include "io/keys/scene_text.hpp"
#include "io/keys/scene_words.hpp"
#include "io/sweeps/sweep_keys.hpp"

#include <algorithm>
#include <array>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr WordList<DistributionKind, 3> distribution_words = {{
    {"normal", DistributionKind::normal},
    {"lognormal", DistributionKind::lognormal},
    {"uniform", DistributionKind::uniform},
}};

/// A sweep of another version is not judged by the keys of this one.
bool check_version(const DocumentNode& document, Diagnostics& findings)
{
    const DocumentNode* version = document.find("sweep_version");
    if (version == nullptr || version->kind != DocumentNode::Kind::integer || version->integer == 1)
        return true;
    findings.add(
        error_at(version->place, "version",
                 "sweep_version " + std::to_string(version->integer) + " is not known to this program",
                 "sweep_version = 1"));
    return false;
}

/// [vary.motion.amplitude] is a table in a table for TOML, and the mistake that everyone makes once.
bool check_quotes(const DocumentNode& document, Diagnostics& findings)
{
    const DocumentNode* vary = document.find("vary");
    if (vary == nullptr) return true;
    bool good = true;
    for (const DocumentNode& part : vary->children)
        for (const DocumentNode& child : part.children) {
            if (part.kind != DocumentNode::Kind::table || child.kind != DocumentNode::Kind::table) continue;
            findings.add(error_at(child.place, "quotes", "the key of the scene stands without quotes",
                                  "[vary.\"" + part.name + "." + child.name + "\"]"));
            good = false;
        }
    return good;
}

class SweepReader {
public:
    SweepReader(const SceneValues& values, Diagnostics& findings) : values_(values), findings_(findings) {}

    Sweep read(const fs::path& file);

private:
    fs::path read_scene(const fs::path& folder);
    VariedKey read_varied(const NamedTable& table);
    std::optional<Distribution> read_distribution(const NamedTable& table, const std::string& word);
    double read_quantity(const std::string& path, Distribution& distribution, bool first);
    void check_samples(const Sweep& sweep);
    void check_fixed(const Sweep& sweep);
    std::optional<FragilityRequest> read_fragility(const Sweep& sweep);
    void refuse(const SourcePlace& place, const char* kind, std::string what, std::string expected,
                std::string hint = "")
    {
        findings_.add(error_at(place, kind, std::move(what), std::move(expected), std::move(hint)));
    }

    const SceneValues& values_;
    Diagnostics& findings_;
    std::optional<SourcePlace> random_; // the first random key
};

fs::path SweepReader::read_scene(const fs::path& folder)
{
    const std::string written = values_.text("scene");
    if (written.empty()) return {};
    fs::path scene = (folder / written).lexically_normal();
    std::error_code ignored;
    if (fs::is_directory(scene, ignored)) scene /= "scene.toml";
    if (!fs::exists(scene, ignored))
        refuse(values_.place("scene"), "file", "there is no scene '" + scene.string() + "'",
               "a scene, or a folder that holds scene.toml; the path is relative to the sweep's file");
    return scene;
}

/// A parameter of a distribution; all of them have the unit of the first.
double SweepReader::read_quantity(const std::string& path, Distribution& distribution, bool first)
{
    const auto quantity = split_quantity(values_.text(path));
    if (!quantity) return 0.0; // there is a finding already
    if (first) distribution.unit = quantity->unit;
    if (quantity->unit != distribution.unit)
        refuse(values_.place(path), "unit",
               path + (quantity->unit.empty() ? " has no unit" : " has the unit '" + quantity->unit + "'"),
               distribution.unit.empty() ? "no unit, as the parameter before it"
                                         : "'" + distribution.unit + "', as the parameter before it");
    return quantity->number;
}

std::optional<Distribution> SweepReader::read_distribution(const NamedTable& table, const std::string& word)
{
    Distribution distribution;
    distribution.kind = word_of(distribution_words, word);
    const bool uniform = distribution.kind == DistributionKind::uniform;
    const std::string first = table.path + (uniform ? ".low" : ".mean");
    const std::string second = table.path + (uniform ? ".high" : ".deviation");
    if (!values_.has(first) || !values_.has(second)) return std::nullopt; // there is a finding already
    const double a = read_quantity(first, distribution, true), b = read_quantity(second, distribution, false);
    if (uniform) {
        distribution.low = a;
        distribution.high = b;
        if (!(a < b)) refuse(values_.place(second), "range", second + " is not above the lower limit", "");
        return distribution;
    }
    distribution.mean = a;
    distribution.deviation = b;
    if (distribution.kind == DistributionKind::lognormal && !(a > 0.0))
        refuse(values_.place(first), "range", first + " of a lognormal key is not above 0", "more than 0");
    if (!(b > 0.0)) refuse(values_.place(second), "range", second + " is not above 0", "more than 0");
    return distribution;
}

VariedKey SweepReader::read_varied(const NamedTable& table)
{
    VariedKey varied;
    varied.key = table.name;
    varied.place = table.place;
    const std::string word = values_.text(table.path + ".distribution");
    if (!word.empty() && word != "list" && !random_) random_ = table.place;
    if (word == "list")
        varied.values = values_.find<std::vector<std::string>>(table.path + ".values")
                            .value_or(std::vector<std::string>());
    else if (!word.empty())
        varied.distribution = read_distribution(table, word);
    return varied;
}

void SweepReader::check_samples(const Sweep& sweep)
{
    const bool sampled = values_.given("samples");
    if (random_ && !sampled)
        refuse(*random_, "missing-key", "the key is random, and the sweep has no samples",
               "samples = 100, above the first table");
    if (!random_ && sampled && !findings_.has_errors()) // a distribution with a mistake is none
        refuse(values_.place("samples"), "samples", "samples are of no use: no key has a distribution",
               "distribution = \"lognormal\" in a table [vary.\"KEY\"]");
    constexpr double most = 100'000.0; // runs that a folder can hold and a person look at
    double count = static_cast<double>(sweep.samples);
    for (const VariedKey& key : sweep.varied)
        if (!key.values.empty()) count *= static_cast<double>(key.values.size());
    if (count > most)
        refuse(sweep.varied.front().place, "range", "the sweep has " + number_text(count) + " runs",
               "at most " + number_text(most));
}

/// A key is replaced once.
void SweepReader::check_fixed(const Sweep& sweep)
{
    for (const std::string& word : sweep.fixed)
        for (const VariedKey& key : sweep.varied)
            if (word.substr(0, word.find('=')) == key.key)
                refuse(values_.place("set"), "duplicate-key", "set and vary both give " + key.key,
                       "one of the two");
}

std::optional<FragilityRequest> SweepReader::read_fragility(const Sweep& sweep)
{
    if (!values_.has_table("fragility")) return std::nullopt;
    FragilityRequest request{values_.text("fragility.quantity"), values_.number("fragility.threshold"),
                             values_.text("fragility.intensity")};
    std::vector<std::string> known;
    for (const VariedKey& key : sweep.varied) {
        known.push_back(key.key);
        if (request.intensity.empty() && (key.key == "motion.amplitude" || key.key == "motion.scale"))
            request.intensity = key.key;
    }
    if (std::find(known.begin(), known.end(), request.intensity) != known.end()) return request;
    const bool written = values_.given("fragility.intensity");
    const std::string nearest = written ? nearest_name(request.intensity, known) : "";
    refuse(written ? values_.place("fragility.intensity") : values_.tables.at("fragility"), "intensity",
           written ? "\"" + request.intensity + "\" is not varied"
                   : "neither motion.amplitude nor motion.scale is varied, and fragility names no intensity",
           one_of(known), nearest.empty() ? "" : "did you mean \"" + nearest + "\"?");
    return std::nullopt;
}

Sweep SweepReader::read(const fs::path& file)
{
    Sweep sweep;
    sweep.file = file;
    sweep.title = values_.text("title");
    sweep.scene = read_scene(file.parent_path());
    sweep.fixed = values_.find<std::vector<std::string>>("set").value_or(std::vector<std::string>());
    sweep.samples = values_.find<std::int64_t>("samples").value_or(1);
    sweep.seed = static_cast<std::uint64_t>(values_.find<std::int64_t>("seed").value_or(1));
    for (const NamedTable& table : values_.tables_named("vary")) sweep.varied.push_back(read_varied(table));
    check_samples(sweep);
    check_fixed(sweep);
    sweep.fragility = read_fragility(sweep);
    return sweep;
}

} // namespace

Sweep read_sweep_file(const fs::path& file)
{
    Diagnostics findings(sweep_key_table().file);
    const auto text = read_text_file(file, {file, 0, 0}, findings);
    if (!text) throw_findings(findings, "");
    check_characters(file, *text, findings);
    if (findings.has_errors()) throw_findings(findings, *text);
    const auto document = read_document(file, *text, {}, findings);
    if (!document || !check_version(*document, findings) || !check_quotes(*document, findings))
        throw_findings(findings, *text);
    const SceneValues values = check_document(sweep_key_table(), *document, findings);
    Sweep sweep = SweepReader(values, findings).read(file);
    if (findings.has_errors()) throw_findings(findings, *text);
    return sweep;
}

} // namespace quicksand
