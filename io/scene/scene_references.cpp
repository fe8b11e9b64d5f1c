#include "io/scene/scene_references.hpp"

#include "geometry/drawing/lower_case.hpp"
#include "geometry/drawing/nearest_name.hpp"
#include "io/keys/scene_value_reader.hpp"
#include "io/keys/scene_words.hpp"

#include <algorithm>

namespace quicksand {

namespace {

std::vector<std::string> names(const std::vector<NamedTable>& tables)
{
    std::vector<std::string> list;
    for (const NamedTable& table : tables) list.push_back(table.name);
    return list;
}

std::string did_you_mean(const std::string& name, const std::vector<std::string>& known)
{
    const std::string nearest = nearest_name(name, known);
    return nearest.empty() ? "" : "did you mean \"" + nearest + "\"?";
}

void check_materials(const SceneValues& values, Diagnostics& findings)
{
    const auto& materials = values.tables_named("materials");
    const auto known = names(materials);
    std::vector<std::string> used;
    bool all_known = true;
    for (const NamedTable& region : values.tables_named("regions")) {
        const std::string path = region.path + ".material", name = values.text(path);
        used.push_back(name);
        all_known = all_known && contains(known, name);
        if (name.empty()) continue;
        if (contains(known, name)) continue;
        findings.add(error_at(values.place(path), "unknown-material", "there is no material \"" + name + "\"",
                              one_of(known), did_you_mean(name, known)));
    }
    for (const NamedTable& material : materials) {
        if (!all_known || contains(used, material.name)) continue; // a misspelt name may have meant this one
        findings.add(warning_at(material.place, material.path, "unused",
                                "no region has the material \"" + material.name + "\""));
    }
}

void check_tied_boundary(const SceneValues& values, const NamedTable& boundary,
                         const std::vector<std::string>& known, Diagnostics& findings)
{
    const std::string path = boundary.path + ".tied_to", partner = values.text(path);
    if (partner.empty()) return;
    const auto refuse = [&](const std::string& what, const std::string& expected, const std::string& hint) {
        findings.add(error_at(values.place(path), "tied", what, expected, hint));
    };
    if (partner == boundary.name) {
        refuse("\"" + partner + "\" is tied to itself", "", "name the opposite curve");
        return;
    }
    if (!contains(known, partner)) {
        refuse("there is no boundary \"" + partner + "\"", one_of(known), did_you_mean(partner, known));
        return;
    }
    const std::string partner_path = join_path({"boundaries", partner});
    const std::string soil = values.text(partner_path + ".soil"),
                      back = values.text(partner_path + ".tied_to");
    const std::string lines =
        "write soil = \"tied\" and tied_to = \"" + boundary.name + "\" in [" + partner_path + "]";
    if (!soil.empty() && soil != "tied") {
        refuse("\"" + partner + "\" is " + soil + ", not tied", "two curves tied to each other", lines);
    } else if (contains(known, back) && back != partner && back != boundary.name) {
        refuse("\"" + partner + "\" is tied to \"" + back + "\", not to \"" + boundary.name + "\"",
               "two curves tied to each other", lines);
    }
}

/// The semi-implicit scheme is that of two phases; no implicit one knows water that moves with the grains.
void check_scheme(const SceneValues& values, Diagnostics& findings)
{
    const std::string scheme = values.text("analysis.scheme");
    if (scheme != "semi_implicit" && scheme != "implicit") return;
    const std::string flow = values.text("water.flow");
    if (scheme == "semi_implicit" && flow.empty())
        findings.add(warning_at(values.place("analysis.scheme"), "analysis.scheme", "unused",
                                "scheme = \"semi_implicit\" has no effect in a dry scene", "",
                                "take \"explicit\" or \"implicit\", or add a table [water]"));
    if (scheme == "implicit" && flow == "undrained")
        findings.add(error_at(values.place("analysis.scheme"), "combination",
                              "scheme = \"implicit\" does not resist the waves of water that moves with the "
                              "grains, water.flow = \"undrained\"",
                              "scheme = \"explicit\", or water.flow = \"coupled\" with a low conductivity"));
    if (scheme == "implicit" || (flow != "undrained" && flow != "drained")) return;
    findings.add(error_at(values.place("analysis.scheme"), "combination",
                          "scheme = \"" + scheme + "\" has no pressure to solve for with water.flow = \"" +
                              flow + "\"",
                          "scheme = \"explicit\", or water.flow = \"coupled\""));
}

/// Laws of the porosity have nothing to follow where the porosity stays.
void check_permeability(const SceneValues& values, Diagnostics& findings)
{
    if (values.text("analysis.strain") != "small") return;
    for (const NamedTable& material : values.tables_named("materials")) {
        const std::string path = material.path + ".permeability_law", law = values.text(path);
        if (law.empty() || law == "constant") continue;
        findings.add(warning_at(values.place(path), path, "unused",
                                path + " has no effect in small strain: the porosity stays", "",
                                "set analysis.strain = \"large\", or remove it"));
    }
}

/// Solids are elastic, up to a strength if they have one.
void check_solids(const SceneValues& values, Diagnostics& findings)
{
    for (const NamedTable& material : values.tables_named("materials")) {
        const std::string path = material.path + ".water", model = values.text(material.path + ".model");
        if (values.text(path) != "none" || model == "linear_elastic" || model == "mohr_coulomb") continue;
        findings.add(error_at(values.place(path), "combination",
                              path + " = \"none\" makes a solid without pores, and model = \"" + model +
                                  "\" is no law of solids",
                              "model = \"linear_elastic\" or \"mohr_coulomb\" with water = \"none\"",
                              "remove water, or take the law of the solid"));
    }
}

void check_boundaries(const SceneValues& values, Diagnostics& findings)
{
    const auto& boundaries = values.tables_named("boundaries");
    const auto known = names(boundaries);
    int tied = 0;
    for (const NamedTable& boundary : boundaries) {
        check_tied_boundary(values, boundary, known, findings);
        if (values.text(boundary.path + ".soil") == "tied" && ++tied == 3) {
            findings.add(error_at(boundary.place, "tied", "a scene has at most one pair of tied curves",
                                  "two boundaries with soil = \"tied\""));
        }
    }
}

/// Members of the family that are boxes along the axes cannot tile a mesh; corners need a domain.
void check_interpolation(const SceneValues& values, Diagnostics& findings)
{
    const std::string member = values.text("analysis.interpolation");
    if (values.text("sampling.kind") != "mesh" || (member != "gimp" && member != "cpgimp")) return;
    findings.add(error_at(values.place("analysis.interpolation"), "combination",
                          "interpolation = \"" + member +
                              "\" gives every point a box along the axes, and boxes cannot tile a mesh",
                          "interpolation = \"cpdi2\", \"cpdi\" or \"linear\" with sampling.kind = \"mesh\"",
                          "cpdi2 keeps the quadrilaterals as they are; or sample a lattice"));
}

void check_probes(const SceneValues& values, Diagnostics& findings)
{
    std::map<std::string, std::string> spellings; // by the lower-case name
    for (const NamedTable& probe : values.tables_named("probes")) {
        const std::string& name = probe.name;
        const bool control = std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x20U; });
        if (name.empty() || name.starts_with('.') || name.size() > 100 || control ||
            name.find_first_of("/\\:*?\"<>|") != std::string::npos) {
            findings.add(error_at(probe.place, "name", "the probe's name cannot be that of a file",
                                  "at most 100 characters, none of / \\ : * ? \" < > |, no leading dot"));
        }
        const auto [other, is_new] = spellings.emplace(lower_case(name), name);
        if (!is_new) {
            findings.add(error_at(probe.place, "name",
                                  "the probes \"" + other->second + "\" and \"" + name +
                                      "\" differ in capitals only"));
        }
        const auto at = values.find<Vector2>(probe.path + ".at"),
                   to = values.find<Vector2>(probe.path + ".to");
        if (at && to && *at == *to) {
            findings.add(error_at(values.place(probe.path + ".to"), "range", "the profile has no length",
                                  "a point other than at"));
        }
    }
}

/// Split a path as the user writes it into its parts; quoted parts keep their dots.
KeyPath split_path(std::string_view text)
{
    KeyPath path(1);
    char quote = '\0';
    for (const char c : text) {
        if (quote != '\0' ? c == quote : c == '"' || c == '\'') {
            quote = quote != '\0' ? '\0' : c;
        } else if (c == '.' && quote == '\0') {
            path.emplace_back();
        } else {
            path.back() += c;
        }
    }
    return path;
}

void check_accepted(const SceneValues& values, Diagnostics& findings)
{
    std::vector<std::string> known;
    for (const ResolvedKey& key : values.keys) known.push_back(key.path);
    for (const std::string& accepted :
         values.find<std::vector<std::string>>("accept").value_or(std::vector<std::string>())) {
        if (find_key(scene_key_table(), split_path(accepted)) != nullptr) continue;
        const std::string nearest = nearest_name(accepted, known);
        findings.add(error_at(values.place("accept"), "unknown-key",
                              "accept names \"" + accepted + "\", which is no key",
                              "the path of a key, as materials.sand.porosity",
                              nearest.empty() ? "" : "did you mean \"" + nearest + "\"?"));
    }
}

} // namespace

void check_references(const SceneValues& values, Diagnostics& findings)
{
    check_materials(values, findings);
    check_boundaries(values, findings);
    check_interpolation(values, findings);
    check_permeability(values, findings);
    check_solids(values, findings);
    check_scheme(values, findings);
    check_probes(values, findings);
    check_accepted(values, findings);
}

} // namespace quicksand
