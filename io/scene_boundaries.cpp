#include "io/scene_boundaries.hpp"

#include "io/scene_text.hpp"
#include "io/scene_words.hpp"
#include "io/time_table.hpp"

#include <initializer_list>

namespace quicksand {

namespace {

constexpr WordList<SoilCondition, 4> soil_words = {{
    {"free", SoilCondition::free},
    {"fixed", SoilCondition::fixed},
    {"roller", SoilCondition::roller},
    {"tied", SoilCondition::tied},
}};
constexpr WordList<WaterCondition, 2> water_words = {{
    {"drained", WaterCondition::drained},
    {"impervious", WaterCondition::impervious},
}};

/// One table [boundaries.NAME] and where its findings go.
class BoundaryReader {
public:
    BoundaryReader(const SceneValues& values, const NamedTable& table, const std::filesystem::path& folder,
                   Diagnostics& findings)
        : values_(values), table_(table), folder_(folder), findings_(findings)
    {
    }

    SceneBoundary read();

private:
    std::string path(const char* key) const { return table_.path + "." + key; }
    bool has(const char* key) const { return values_.given(path(key)); }
    void refuse(const char* key, std::string what, std::string expected, std::string hint = "")
    {
        findings_.add(error_at(values_.place(path(key)), "boundary", std::move(what), std::move(expected),
                               std::move(hint)));
    }
    std::optional<SurfaceLoad> read_load();
    void check_history();
    History read_history();
    std::optional<SampledHistory> read_table();

    const SceneValues& values_;
    const NamedTable& table_;
    const std::filesystem::path& folder_;
    Diagnostics& findings_;
};

/// The first of the keys that is given, "" when none is.
template <class Has>
std::string first_given(std::initializer_list<const char*> keys, Has&& has)
{
    for (const char* key : keys) {
        if (has(key)) return key;
    }
    return "";
}

std::optional<SampledHistory> BoundaryReader::read_table()
{
    const std::filesystem::path file = folder_ / values_.text(path("history"));
    const SourcePlace place = values_.place(path("history"));
    const auto text = read_text_file(file, place, findings_);
    if (!text) return std::nullopt;
    TimeTable table;
    std::string what = parse_time_table(*text, table);
    if (what.empty()) what = check_times(table);
    if (!what.empty()) {
        findings_.add(error_at(place, "history", "'" + file.string() + "': " + what,
                               "rows `time_s, factor` from time 0 on, at most one header line"));
        return std::nullopt;
    }
    SampledHistory history;
    for (const TimeRow& row : table.rows) {
        history.times.push_back(row.time);
        history.values.push_back(row.value);
    }
    return history;
}

void BoundaryReader::check_history()
{
    const auto given = [&](const char* key) { return has(key); };
    const std::string varies = first_given({"ramp_time", "frequency", "history"}, given);
    const std::string acts = first_given({"pressure", "traction"}, given);
    if (!varies.empty() && acts.empty()) {
        refuse(varies.c_str(), path(varies.c_str()) + " has nothing to act on",
               "a pressure or a traction on the same curve", "add pressure or traction, or remove the key");
    }
    if (!has("history")) return;
    for (const char* key : {"ramp_time", "frequency"}) {
        if (has(key))
            refuse(key, path(key) + " and a history file contradict each other", "one of the two",
                   "the file holds the whole course");
    }
}

History BoundaryReader::read_history()
{
    History history;
    history.ramp_time = values_.number(path("ramp_time"));
    if (const auto frequency = values_.find<double>(path("frequency")))
        history.shape = SineHistory{*frequency};
    if (values_.has(path("history"))) {
        if (auto table = read_table()) history.shape = std::move(*table);
    }
    return history;
}

std::optional<SurfaceLoad> BoundaryReader::read_load()
{
    if (!has("pressure") && !has("traction")) return std::nullopt;
    SurfaceLoad load;
    load.pressure = values_.number(path("pressure"));
    load.traction = values_.find<Vector2>(path("traction")).value_or(Vector2::Zero());
    return load;
}

SceneBoundary BoundaryReader::read()
{
    SceneBoundary boundary;
    boundary.name = table_.name;
    boundary.soil = word_of(soil_words, values_.text(path("soil")));
    boundary.water = word_of(water_words, values_.text(path("water")));
    boundary.tied_to = values_.text(path("tied_to"));
    boundary.place = table_.place;
    check_history();
    const History history = read_history();
    boundary.load = read_load();
    if (boundary.load) boundary.load->history = history;
    return boundary;
}

} // namespace

std::vector<SceneBoundary> read_boundaries(const SceneValues& values, const std::filesystem::path& folder,
                                           Diagnostics& findings)
{
    std::vector<SceneBoundary> boundaries;
    const auto tables = values.named.find("boundaries");
    if (tables == values.named.end()) return boundaries;
    for (const NamedTable& table : tables->second)
        boundaries.push_back(BoundaryReader(values, table, folder, findings).read());
    return boundaries;
}

} // namespace quicksand
