#include "io/tables/scene_boundaries.hpp"

#include "io/faces/boundary_kinds.hpp"
#include "io/keys/scene_text.hpp"
#include "io/keys/scene_units.hpp"
#include "io/motions/record_limits.hpp"
#include "io/motions/record_unit.hpp"
#include "io/motions/time_table.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

std::optional<SampledHistory> read_table(const BoundaryTable& boundary, const std::filesystem::path& folder,
                                         Diagnostics& findings)
{
    const std::filesystem::path file = folder / boundary.text("history");
    const SourcePlace place = boundary.place("history");
    const auto text = read_text_file(file, place, findings);
    if (!text) return std::nullopt;
    TimeTable table;
    std::string what = parse_time_table(*text, table);
    if (what.empty()) what = check_times(table);
    if (!what.empty()) {
        findings.add(error_at(place, "history", "'" + file.string() + "': " + what,
                              "rows `time_s, factor` from time 0 on, at most one header line"));
        return std::nullopt;
    }
    if (const std::string unit = foreign_unit_of_time(table.header); !unit.empty()) {
        findings.add(error_at(place, "history",
                              "'" + file.string() + "': its header says that times are in " + unit,
                              "times in s", "convert them, and name s in the header"));
        return std::nullopt;
    }
    if (const std::string unit = unit_of_values(table.header); !unit.empty()) {
        findings.add(error_at(place, "history",
                              "'" + file.string() + "': its header says " + unit +
                                  ", and its rows are factors on what the curve has in the scene",
                              "factors, which have no unit",
                              "divide the values by that of the scene, and name them factor"));
        return std::nullopt;
    }
    SampledHistory history;
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        const TimeRow& row = table.rows[k];
        if (std::abs(row.value) > largest_factor) {
            findings.keep_text(file, *text);
            findings.add(error_at(SourcePlace{file, table.lines[k], 1, 1}, "history",
                                  "a factor of " + number_text(row.value) + " is beyond all loads",
                                  "at most " + number_text(largest_factor) + " in amount"));
            return std::nullopt;
        }
        history.times.push_back(row.time);
        history.values.push_back(row.value);
    }
    return history;
}

/// Whether anything that a history is a factor on is given.
bool has_what_varies(const BoundaryTable& boundary)
{
    const auto has = [&](std::string_view key) { return boundary.has(key); };
    const auto acts = [&](const SceneSoilKind& kind) {
        return std::any_of(kind.varying.begin(), kind.varying.end(), has);
    };
    const auto flows = [&](const SceneWaterKind& kind) {
        return std::any_of(kind.keys.begin(), kind.keys.end(),
                           [&](const SceneKey& key) { return has(last_part(key.pattern)); });
    };
    return std::any_of(soil_kinds().begin(), soil_kinds().end(), acts) ||
           std::any_of(water_kinds().begin(), water_kinds().end(), flows);
}

void check_history(BoundaryTable& boundary)
{
    for (const char* key : {"ramp_time", "frequency", "history"}) {
        if (!boundary.has(key)) continue;
        if (!has_what_varies(boundary)) {
            boundary.refuse(key, boundary.path(key) + " has nothing to act on",
                            "a load, a motion or a head on the same curve",
                            "remove the key, or add what varies");
        }
        break;
    }
    if (!boundary.has("history")) return;
    for (const char* key : {"ramp_time", "frequency"}) {
        if (boundary.has(key))
            boundary.refuse(key, boundary.path(key) + " and a history file contradict each other",
                            "one of the two", "the file holds the whole course");
    }
}

History read_history(const BoundaryTable& boundary, const std::filesystem::path& folder,
                     Diagnostics& findings)
{
    History history;
    history.ramp_time = boundary.number("ramp_time");
    if (boundary.has("frequency")) history.shape = SineHistory{boundary.number("frequency")};
    if (boundary.has("history")) {
        if (auto table = read_table(boundary, folder, findings)) history.shape = std::move(*table);
    }
    return history;
}

} // namespace

std::vector<SceneBoundary> read_boundaries(const SceneValues& values, const std::filesystem::path& folder,
                                           Diagnostics& findings)
{
    std::vector<SceneBoundary> boundaries;
    for (const NamedTable& named : values.tables_named("boundaries")) {
        BoundaryTable table(values, named, findings);
        check_history(table);
        table.set_history(read_history(table, folder, findings));
        SceneBoundary& scene = boundaries.emplace_back();
        scene.place = named.place;
        scene.boundary.name = named.name;
        scene.boundary.soil = kind_named(soil_kinds(), table.text("soil")).read(table);
        const SceneWaterKind& water = kind_named(water_kinds(), table.text("water"));
        scene.boundary.water = water.read(table);
        scene.water_place = table.place(water.word);
    }
    return boundaries;
}

const SceneBoundary* find_boundary(const Scene& scene, const std::string& curve)
{
    const auto found = std::find_if(scene.boundaries.begin(), scene.boundaries.end(),
                                    [&](const SceneBoundary& b) { return b.boundary.name == curve; });
    return found == scene.boundaries.end() ? nullptr : &*found;
}

} // namespace quicksand
