#include "io/element/element_variation.hpp"

#include "geometry/drawing/nearest_name.hpp"
#include "io/element/element_keys.hpp"
#include "io/keys/scene_value_reader.hpp"
#include "io/keys/scene_words.hpp"

namespace quicksand {

namespace {

/// The numbers that may be varied: those of the test's table, or those of the material's which its law has.
std::vector<std::string> numbers_of(std::string_view table_pattern, const std::string& law = "")
{
    std::vector<std::string> names;
    for (const SceneKey* key : keys_of_table(element_key_table(), table_pattern)) {
        const std::vector<std::string_view>& laws = key->when.words;
        const bool known = law.empty() || contains(laws, law);
        if (key->type == ValueType::number && known) names.emplace_back(last_part(key->pattern));
    }
    return names;
}

DocumentNode& child_of(DocumentNode& node, const std::string& name)
{
    for (DocumentNode& child : node.children) {
        if (child.name == name) return child;
    }
    node.children.emplace_back();
    node.children.back().name = name;
    return node.children.back();
}

} // namespace

std::optional<Variation> find_variation(const DocumentNode& document, const SceneValues& values,
                                        const NamedTable& material, const NamedTable& test,
                                        Diagnostics& findings)
{
    const std::string key = values.text(test.path + ".vary");
    for (const char* wanted : {"vary", "values"}) {
        if (values.given(test.path + "." + wanted)) continue;
        findings.add(error_at(test.place, "missing-key", "[" + test.path + "] has no " + wanted,
                              "vary = \"k0\" and values = [0.4, 0.5, 1.0], for example"));
        return std::nullopt;
    }
    std::vector<std::string> of_material = numbers_of("materials.*", values.text(material.path + ".model")),
                             of_test = numbers_of("tests.*");
    const bool is_material = contains(of_material, key);
    if (!is_material && !contains(of_test, key)) {
        of_material.insert(of_material.end(), of_test.begin(), of_test.end());
        const std::string nearest = nearest_name(key, of_material);
        findings.add(error_at(values.place(test.path + ".vary"), "unknown-key",
                              "\"" + key + "\" is no number of the material or the test", one_of(of_material),
                              nearest.empty() ? "" : "did you mean \"" + nearest + "\"?"));
        return std::nullopt;
    }
    Variation variation;
    variation.path =
        is_material ? KeyPath{"materials", material.name, key} : KeyPath{"tests", test.name, key};
    const auto labels = values.find<std::vector<std::string>>(test.path + ".values");
    const DocumentNode* list = document.find("tests")->find(test.name)->find("values");
    for (std::size_t k = 0; k < labels->size(); ++k) {
        variation.values.push_back({(*labels)[k], list->children[k]});
    }
    return variation;
}

DocumentNode put_value(DocumentNode document, const KeyPath& path, const DocumentNode& value)
{
    DocumentNode* node = &document;
    for (const std::string& name : path) node = &child_of(*node, name);
    const std::string name = node->name;
    *node = value;
    node->name = name;
    node->name_place = value.place;
    return document;
}

} // namespace quicksand
