#include "io/element/element_file.hpp"

#include "geometry/drawing/nearest_name.hpp"
#include "io/element/element_data.hpp"
#include "io/element/element_keys.hpp"
#include "io/element/element_variation.hpp"
#include "io/keys/scene_text.hpp"
#include "io/keys/scene_value_reader.hpp"
#include "io/laws/soil_laws.hpp"
#include "solver/base/failure.hpp"

#include <algorithm>

namespace quicksand {

namespace {

Drainage drainage_of(const SceneValues& values, const std::string& test)
{
    return values.text(test + ".drainage") == "drained" ? Drainage::drained : Drainage::undrained;
}

std::vector<ElementLoading> read_loadings(const SceneValues& values, const std::string& test)
{
    const auto number = [&](const char* key) { return values.number(test + "." + key); };
    const auto list = [&](const char* key) {
        return values.find<std::vector<double>>(test + "." + key).value_or(std::vector<double>());
    };
    const std::string kind = values.text(test + ".kind");
    std::vector<ElementLoading> loadings;
    if (kind == "cyclic_shear_stress_controlled") {
        for (const double csr : list("csr")) {
            loadings.push_back(StressCycles{csr, number("cycles"), number("largest_shear_strain"),
                                            number("cycles_after_liquefaction")});
        }
    } else if (kind == "cyclic_shear_strain_controlled") {
        for (const double gamma : list("shear_strains")) {
            loadings.push_back(StrainCycles{
                .gamma = gamma, .cycles = number("cycles"), .drainage = drainage_of(values, test)});
        }
    } else if (kind == "reconsolidation") {
        for (const double gamma : list("shear_strains")) {
            loadings.push_back(Reconsolidation{gamma, number("cycles")});
        }
    } else if (kind == "monotonic_shear") {
        loadings.push_back(MonotonicShear{drainage_of(values, test), number("largest_shear_strain")});
    } else if (kind == "biaxial_compression") {
        loadings.push_back(BiaxialCompression{drainage_of(values, test), number("largest_vertical_strain")});
    } else if (kind == "oedometer") {
        loadings.push_back(OedometerLoading{list("stresses")});
    } else if (kind == "isotropic_compression") {
        loadings.push_back(IsotropicLoading{list("stresses")});
    }
    return loadings;
}

/// The least stress of the model is also the least of a test.
void check_stresses(const SceneValues& values, const std::string& test,
                    const std::vector<ElementSpecimen>& specimens, Diagnostics& findings)
{
    const std::string path = test + ".stresses";
    StressFloor floor;
    for (const ElementSpecimen& specimen : specimens) {
        const StressFloor other = stress_floor_of(specimen.soil.law);
        if (other.stress > floor.stress) floor = other;
    }
    for (const double stress : values.find<std::vector<double>>(path).value_or(std::vector<double>())) {
        if (stress >= floor.stress) continue;
        findings.add(error_at(values.place(path), "range",
                              path + " has " + quantity_text(stress, Dimension::pressure) +
                                  ", which is below the least stress of the model",
                              "at least " + quantity_text(floor.stress, Dimension::pressure) + ", the " +
                                  std::string(floor.key)));
        return;
    }
}

/// The material that the test names, or the only one; null, and a finding, when there is none.
const NamedTable* find_material(const SceneValues& values, const std::string& test, const SourcePlace& place,
                                Diagnostics& findings)
{
    const std::vector<NamedTable>& materials = values.tables_named("materials");
    const std::string name = values.text(test + ".material");
    if (name.empty() && materials.size() == 1) return &materials.front();
    std::vector<std::string> known;
    for (const NamedTable& material : materials) {
        if (material.name == name) return &material;
        known.push_back(material.name);
    }
    const std::string nearest = name.empty() ? "" : nearest_name(name, known);
    findings.add(error_at(name.empty() ? place : values.place(test + ".material"), "unknown-material",
                          name.empty() ? "there are several materials and the test names none"
                                       : "there is no material \"" + name + "\"",
                          one_of(known), nearest.empty() ? "" : "did you mean \"" + nearest + "\"?"));
    return nullptr;
}

std::string consolidation_hint(const ElementSpecimen& specimen)
{
    const Consolidation& start = specimen.start;
    const StressFloor floor = stress_floor_of(specimen.soil.law);
    if (0.5 * (1.0 + start.k0) * start.vertical_stress < floor.stress)
        return "raise vertical_stress, or lower " + std::string(floor.key);
    if (!bears_stress_as_drawn(specimen.soil.law)) return "lower vertical_stress, or take stiffer soil";
    return start.static_shear != 0.0 ? "reduce static_shear_ratio, or bring k0 nearer to 1"
                                     : "bring k0 nearer to 1";
}

DescribedLaw read_soil(SceneValues& values, const NamedTable& material, Diagnostics& findings)
{
    return read_element_law({values, material, Material(), findings});
}

/// Soil and initial stresses; that they can be is checked by consolidating.
ElementSpecimen read_specimen(SceneValues& values, const NamedTable& material, const NamedTable& test,
                              const SourcePlace& place, Diagnostics& findings)
{
    const auto number = [&](const char* key, double otherwise) {
        return values.find<double>(test.path + "." + key).value_or(otherwise);
    };
    ElementSpecimen specimen;
    specimen.soil = read_soil(values, material, findings);
    specimen.start.vertical_stress = number("vertical_stress", specimen.start.vertical_stress);
    specimen.start.k0 = number("k0", 1.0);
    specimen.start.static_shear = number("static_shear_ratio", 0.0) * specimen.start.vertical_stress;
    if (findings.has_errors()) return specimen;
    try {
        consolidate(specimen.soil.law, specimen.start);
    } catch (const InputError& error) {
        findings.add(error_at(place, "consolidation", error.what(), "", consolidation_hint(specimen)));
    }
    return specimen;
}

/// The specimens of a test, one for each value of the key that it varies.
std::vector<ElementSpecimen> read_specimens(const DocumentNode& document, SceneValues& values,
                                            const NamedTable& material, const NamedTable& test,
                                            Diagnostics& findings)
{
    if (!values.given(test.path + ".vary") && !values.given(test.path + ".values")) {
        return {read_specimen(values, material, test, test.place, findings)};
    }
    const auto variation = find_variation(document, values, material, test, findings);
    std::vector<ElementSpecimen> specimens;
    if (!variation || findings.has_errors()) return specimens;
    for (const VariedValue& varied : variation->values) {
        Diagnostics about_value;
        SceneValues changed = check_document(element_key_table(),
                                             put_value(document, variation->path, varied.node), about_value);
        ElementSpecimen specimen = read_specimen(changed, material, test, varied.node.place, about_value);
        specimen.label = variation->path.back() + " = " + varied.label;
        specimen.value = changed.number(join_path(variation->path));
        specimens.push_back(std::move(specimen));
        for (const Diagnostic& finding : about_value.findings()) {
            if (finding.severity == Severity::error || finding.place.line == varied.node.place.line) {
                findings.add(finding);
            }
        }
    }
    return specimens;
}

void check_name(const NamedTable& test, Diagnostics& findings)
{
    const std::string& name = test.name;
    const bool control = std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x20U; });
    if (!name.empty() && !name.starts_with('.') && name.size() <= 100 && !control &&
        name.find_first_of("/\\:*?\"<>|") == std::string::npos) {
        return;
    }
    findings.add(error_at(test.place, "name", "the test's name cannot be that of a folder",
                          "at most 100 characters, none of / \\ : * ? \" < > |, no leading dot"));
}

ElementTest read_test(const DocumentNode& document, SceneValues& values, const NamedTable& table,
                      const std::filesystem::path& folder, Diagnostics& findings)
{
    ElementTest test;
    test.name = table.name;
    check_name(table, findings);
    const NamedTable* material = find_material(values, table.path, table.place, findings);
    if (material == nullptr || findings.has_errors()) return test;
    test.material = material->name;
    test.soil = read_soil(values, *material, findings);
    test.varied = values.text(table.path + ".vary");
    test.specimens = read_specimens(document, values, *material, table, findings);
    test.loadings = read_loadings(values, table.path);
    check_stresses(values, table.path, test.specimens, findings);
    test.criterion =
        find_criterion(values.text(table.path + ".criterion")).value_or(LiquefactionCriterion::ru_95);
    if (const std::string data = values.text(table.path + ".data"); !data.empty()) {
        const std::string path = table.path + ".data", label = values.text(table.path + ".data_label");
        test.data = read_strength_data(folder / data, test.varied, values.place(path), findings);
        if (test.data && !label.empty()) test.data->label = label;
    }
    return test;
}

void check_accepted(const SceneValues& values, const std::vector<std::string>& accepted,
                    Diagnostics& findings)
{
    std::vector<std::string> known;
    for (const ResolvedKey& key : values.keys) known.push_back(key.path);
    for (const std::string& path : accepted) {
        if (std::find(known.begin(), known.end(), path) != known.end()) continue;
        const std::string nearest = nearest_name(path, known);
        findings.add(error_at(values.place("accept"), "unknown-key",
                              "accept names \"" + path + "\", which is no key",
                              "the path of a key, as tests.strength.k0",
                              nearest.empty() ? "" : "did you mean \"" + nearest + "\"?"));
    }
}

bool check_version(const DocumentNode& document, Diagnostics& findings)
{
    const DocumentNode* version = document.find("test_version");
    if (version == nullptr || version->kind != DocumentNode::Kind::integer || version->integer == 1)
        return true;
    findings.add(
        error_at(version->place, "version",
                 "test_version " + std::to_string(version->integer) + " is not known to this program",
                 "test_version = 1"));
    return false;
}

} // namespace

std::optional<LiquefactionCriterion> find_criterion(std::string_view word)
{
    if (word == "ru_95") return LiquefactionCriterion::ru_95;
    if (word == "strain_3_percent") return LiquefactionCriterion::strain_3_percent;
    if (word == "strain_3.75_percent") return LiquefactionCriterion::strain_375_percent;
    if (word == "double_7.5_percent") return LiquefactionCriterion::double_amplitude_75_percent;
    return std::nullopt;
}

ElementReading read_element_file(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
    Diagnostics findings(element_key_table().file);
    const auto text = read_text_file(file, {file, 0, 0}, findings);
    if (!text) throw_findings(findings, "");
    check_characters(file, *text, findings);
    if (findings.has_errors()) throw_findings(findings, *text);
    const auto document = read_document(file, *text, overrides, findings);
    if (!document || !check_version(*document, findings)) throw_findings(findings, *text);

    SceneValues values = check_document(element_key_table(), *document, findings);
    const auto accepted =
        values.find<std::vector<std::string>>("accept").value_or(std::vector<std::string>());
    check_accepted(values, accepted, findings);
    ElementReading reading;
    reading.programme = {file, *text, values.text("title"), {}};
    for (const NamedTable& material : values.tables_named("materials")) {
        read_soil(values, material, findings);
    }
    if (findings.has_errors()) throw_findings(findings, *text);
    for (const NamedTable& table : values.tables_named("tests")) {
        Diagnostics about_test;
        reading.programme.tests.push_back(
            read_test(*document, values, table, file.parent_path(), about_test));
        findings.add(about_test);
    }
    findings.accept(accepted);
    if (findings.has_errors()) throw_findings(findings, *text);
    reading.keys = std::move(values.keys);
    reading.warnings = std::move(findings);
    return reading;
}

} // namespace quicksand
