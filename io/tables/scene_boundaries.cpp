#include "io/tables/scene_boundaries.hpp"

#include "io/keys/scene_text.hpp"
#include "io/keys/scene_units.hpp"
#include "io/keys/scene_words.hpp"
#include "io/motions/time_table.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace quicksand {

namespace {

constexpr std::array motion_keys = {"velocity", "normal_velocity", "displacement", "normal_displacement"};
constexpr std::array rock_keys = {"rock_density", "rock_shear_wave_speed", "rock_compression_wave_speed"};

constexpr WordList<SoilCondition, 6> soil_words = {{
    {"free", SoilCondition::free},
    {"fixed", SoilCondition::fixed},
    {"roller", SoilCondition::roller},
    {"tied", SoilCondition::tied},
    {"moving", SoilCondition::moving},
    {"viscous", SoilCondition::viscous},
}};
constexpr WordList<WaterCondition, 4> water_words = {{
    {"drained", WaterCondition::drained},
    {"impervious", WaterCondition::impervious},
    {"head", WaterCondition::prescribed},
    {"pore_pressure", WaterCondition::prescribed},
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
    /// Whether the file holds the key, be its value good or bad.
    bool is_written(const char* key) const { return values_.written.contains(path(key)); }
    void refuse(const char* key, std::string what, std::string expected, std::string hint = "")
    {
        findings_.add(error_at(values_.place(path(key)), "boundary", std::move(what), std::move(expected),
                               std::move(hint)));
    }
    std::optional<SurfaceLoad> read_load();
    std::optional<WallMotion> read_motion();
    std::optional<HalfSpace> read_half_space();
    std::optional<OuterWater> read_outer_water();
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
    const std::string acts = first_given({"pressure", "traction", "velocity", "normal_velocity",
                                          "displacement", "normal_displacement", "head", "pore_pressure"},
                                         given);
    if (!varies.empty() && acts.empty()) {
        refuse(varies.c_str(), path(varies.c_str()) + " has nothing to act on",
               "a load, a motion or a head on the same curve", "remove the key, or add what varies");
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

std::optional<WallMotion> BoundaryReader::read_motion()
{
    if (values_.text(path("soil")) != "moving") return std::nullopt;
    std::vector<std::string> given;
    for (const char* key : motion_keys) {
        if (is_written(key)) given.emplace_back(key);
    }
    const std::string expected = "one of velocity, normal_velocity, displacement, normal_displacement";
    if (given.empty()) {
        findings_.add(
            error_at(table_.place, "boundary", table_.path + " moves but does not say how", expected));
        return std::nullopt;
    }
    if (!std::all_of(given.begin(), given.end(), [&](const auto& key) { return has(key.c_str()); }))
        return std::nullopt; // its value is wrong and has been reported
    if (given.size() > 1) {
        refuse(given[1].c_str(), path(given[1].c_str()) + " and " + given[0] + " contradict each other",
               expected, "remove one of the two");
        return std::nullopt;
    }
    WallMotion motion;
    const std::string& key = given[0];
    motion.quantity = key.ends_with("velocity") ? MotionQuantity::velocity : MotionQuantity::displacement;
    motion.grip = key.starts_with("normal") ? WallGrip::smooth : WallGrip::rough;
    if (motion.grip == WallGrip::smooth) {
        motion.inward = values_.number(path(key.c_str()));
    } else {
        motion.value = values_.find<Vector2>(path(key.c_str())).value_or(Vector2::Zero());
    }
    const bool varies = has("ramp_time") || has("frequency") || has("history");
    if (motion.quantity == MotionQuantity::displacement && !varies) {
        refuse(key.c_str(), path(key.c_str()) + " has no course: the curve would jump to it at the start",
               "a ramp_time, a frequency or a history beside it");
    }
    return motion;
}

std::optional<HalfSpace> BoundaryReader::read_half_space()
{
    if (values_.text(path("soil")) != "viscous") return std::nullopt;
    std::string given, missing;
    for (const char* key : rock_keys) {
        if (has(key)) {
            given = key;
        } else if (is_written(key)) {
            return std::nullopt; // its value is wrong and has been reported
        } else {
            missing += (missing.empty() ? "" : " and ") + std::string(key);
        }
    }
    if (given.empty()) return std::nullopt;
    if (!missing.empty()) {
        refuse(given.c_str(), path(given.c_str()) + " is alone: " + missing + " are unknown",
               "all of rock_density, rock_shear_wave_speed, rock_compression_wave_speed, or none",
               "none makes the boundary as stiff as the soil beside it");
        return std::nullopt;
    }
    HalfSpace rock{values_.number(path(rock_keys[0])), values_.number(path(rock_keys[1])),
                   values_.number(path(rock_keys[2]))};
    if (rock.compression_wave_speed <= rock.shear_wave_speed) {
        refuse(rock_keys[2],
               path(rock_keys[2]) + " is not larger than the shear wave speed " +
                   quantity_text(rock.shear_wave_speed, Dimension::velocity),
               "a compression wave that is faster than the shear wave");
    }
    return rock;
}

std::optional<OuterWater> BoundaryReader::read_outer_water()
{
    OuterWater outer;
    if (const auto head = values_.find<double>(path("head"))) {
        outer.value = WaterHead{*head};
    } else if (const auto pressure = values_.find<double>(path("pore_pressure"))) {
        outer.value = PorePressure{*pressure};
    } else {
        return std::nullopt;
    }
    if (values_.text(path("soil")) == "tied") {
        findings_.add(error_at(table_.place, "boundary", table_.path + " is tied and has a prescribed head",
                               "a head on a curve that is not tied",
                               "what passes through one of two tied sides comes in at the other"));
    }
    return outer;
}

SceneBoundary BoundaryReader::read()
{
    SceneBoundary boundary;
    boundary.name = table_.name;
    boundary.soil = word_of(soil_words, values_.text(path("soil")));
    boundary.water = word_of(water_words, values_.text(path("water")));
    boundary.place = table_.place;
    check_history();
    const History history = read_history();
    boundary.load = read_load();
    boundary.motion = read_motion();
    boundary.half_space = read_half_space();
    boundary.outer_water = read_outer_water();
    if (boundary.load) boundary.load->history = history;
    if (boundary.motion) boundary.motion->history = history;
    if (!boundary.outer_water) return boundary;
    boundary.outer_water->history = history;
    boundary.water_place = values_.place(path(has("head") ? "head" : "pore_pressure"));
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
