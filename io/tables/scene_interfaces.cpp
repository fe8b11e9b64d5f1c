#include "io/tables/scene_interfaces.hpp"

#include "geometry/drawing/nearest_name.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;

/// Two different regions that the scene has.
bool check_regions(const SceneValues& values, const std::string& path, const std::vector<std::string>& pair,
                   Diagnostics& findings)
{
    const auto refuse = [&](const std::string& what, const std::string& expected, const std::string& hint) {
        findings.add(error_at(values.place(path), "interface", what, expected, hint));
        return false;
    };
    if (pair.size() != 2 || pair[0] == pair[1])
        return refuse(path + " names " +
                          (pair.size() == 2 ? "the same region twice"
                                            : std::to_string(pair.size()) + " of the two that touch"),
                      "two regions, as [\"caisson\", \"sand\"]", "");
    std::vector<std::string> known;
    for (const NamedTable& region : values.tables_named("regions")) known.push_back(region.name);
    for (const std::string& name : pair) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const std::string nearest = nearest_name(name, known);
        return refuse("there is no region \"" + name + "\"", one_of(known),
                      nearest.empty()
                          ? "an interface goes with its regions: remove it as well, in a variant by "
                            "without = [\"" +
                                path.substr(0, path.rfind('.')) + "\"]"
                          : "did you mean \"" + nearest + "\"?");
    }
    return true;
}

/// Either the strength itself or its ratio to the soil's.
void check_strength(const SceneValues& values, const NamedTable& table, Diagnostics& findings)
{
    const std::string friction = table.path + ".friction_angle", cohesion = table.path + ".cohesion",
                      ratio = table.path + ".strength_ratio";
    const bool has_ratio = values.has(ratio);
    for (const std::string& own : {friction, cohesion}) {
        if (!has_ratio || !values.given(own)) continue;
        findings.add(error_at(
            values.place(own), "conflict", own + " is given, and strength_ratio reduces that of the soil",
            "strength_ratio alone, or friction_angle with cohesion", "remove one of the two"));
    }
    if (has_ratio || values.written.contains(ratio) || values.written.contains(friction)) {
        if (values.has(friction) && values.number(friction) == 0.0 && values.number(cohesion) == 0.0)
            findings.add(
                error_at(values.place(friction), "range",
                         "[" + table.path + "] has no strength: cohesion and friction_angle are both 0",
                         "one of them more than 0", "a smooth face is friction_angle = \"1 deg\""));
        return;
    }
    findings.add(error_at(table.place, "missing-key", "[" + table.path + "] has no strength",
                          "strength_ratio, or friction_angle with cohesion",
                          "steel and concrete on soil: strength_ratio = 0.67 in practice"));
}

SceneInterface read_interface(const SceneValues& values, const NamedTable& table)
{
    SceneInterface result;
    result.name = table.name;
    result.place = table.place;
    result.regions_place = values.place(table.path + ".regions");
    result.strength_ratio = values.find<double>(table.path + ".strength_ratio");
    result.strength = {std::tan(radians_per_degree * values.number(table.path + ".friction_angle")),
                       values.number(table.path + ".cohesion")};
    result.strength_place =
        values.place(table.path + (result.strength_ratio ? ".strength_ratio" : ".friction_angle"));
    result.thickness = values.find<double>(table.path + ".thickness");
    result.thickness_place = values.place(table.path + ".thickness");
    return result;
}

} // namespace

std::vector<SceneKey> interface_keys()
{
    using enum ValueType;
    constexpr Interval positive{.lower = 0.0, .lower_open = true};
    // One row, one key: the formatter would make it ten lines.
    // clang-format off
    return {
        {.pattern = "interfaces", .type = named_tables, .default_note = "regions stick to each other, up to the strength of the soil",
         .doc = "Where two regions slide on each other with less than the strength of the soil."},
        {.pattern = "interfaces.*", .type = table, .doc = "The common edge of two regions, under a name of your choice."},
        {.pattern = "interfaces.*.regions", .type = text_list, .required = true,
         .doc = "The two regions. The soil of one slides: beside a solid that of the soil, of two soils that of the first."},
        {.pattern = "interfaces.*.strength_ratio", .default_note = "friction_angle and cohesion are given",
         .allowed = {.lower = 0.0, .upper = 1.0, .lower_open = true}, .plausible = {0.3, 1.0},
         .doc = "tan(delta) over the soil's tan(phi), and adhesion over its cohesion: R_inter of practice."},
        {.pattern = "interfaces.*.friction_angle", .dimension = Dimension::angle, .default_note = "strength_ratio is given",
         .allowed = {.lower = 0.0, .upper = 45.0, .upper_open = true}, .plausible = {5.0, 40.0},
         .doc = "Angle delta of friction of the face; the soil's own strength is the limit."},
        {.pattern = "interfaces.*.cohesion", .dimension = Dimension::pressure, .default_value = 0.0, .allowed = {.lower = 0.0},
         .plausible = {0.0, 1e6}, .doc = "Adhesion of the face, beside friction_angle."},
        {.pattern = "interfaces.*.thickness", .dimension = Dimension::length,
         .default_note = "one cell beside edges on grid lines, two beside those along them, four beside others", .allowed = positive,
         .doc = "Thickness of the soil that slides, beside the edge; thinner soil slides in part, for slip takes a cell."},
    };
    // clang-format on
}

std::vector<SceneInterface> read_interfaces(const SceneValues& values, Diagnostics& findings)
{
    std::vector<SceneInterface> interfaces;
    for (const NamedTable& table : values.tables_named("interfaces")) {
        check_strength(values, table, findings);
        const std::string path = table.path + ".regions";
        const auto pair = values.find<std::vector<std::string>>(path);
        if (!pair || !check_regions(values, path, *pair, findings)) continue;
        SceneInterface next = read_interface(values, table);
        std::copy(pair->begin(), pair->end(), next.regions.begin());
        for (const SceneInterface& other : interfaces) {
            if (!std::is_permutation(next.regions.begin(), next.regions.end(), other.regions.begin()))
                continue;
            findings.add(
                error_at(values.place(path), "conflict",
                         "\"" + next.name + "\" has the regions of the interface \"" + other.name + "\"",
                         "one interface for each pair of regions"));
        }
        interfaces.push_back(std::move(next));
    }
    return interfaces;
}

} // namespace quicksand
