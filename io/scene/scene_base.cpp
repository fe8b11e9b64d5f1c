#include "io/scene/scene_base.hpp"

#include "io/keys/scene_schema.hpp"
#include "io/keys/scene_text.hpp"
#include "io/keys/scene_units.hpp"
#include "io/scene/scene_stages.hpp"
#include "io/scene/scene_variant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace quicksand {

namespace {

using Kind = DocumentNode::Kind;

constexpr const char* base_key = "base";
constexpr const char* without_key = "without";

std::string value_as_toml(const DocumentNode& node)
{
    if (node.kind == Kind::text) return toml_text(node.text);
    if (node.kind == Kind::integer) return fmt::format("{}", node.integer);
    if (node.kind == Kind::number) {
        const std::string digits = fmt::format("{}", node.number);
        return digits.find_first_of(".en") == std::string::npos ? digits + ".0" : digits;
    }
    std::string items;
    for (const DocumentNode& item : node.children) items += (items.empty() ? "" : ", ") + value_as_toml(item);
    return "[" + items + "]";
}

/// The values of a table, then the tables in it under their headers.
void append_table(const DocumentNode& table, const KeyPath& path, std::string& text)
{
    for (const DocumentNode& node : table.children) {
        if (node.kind != Kind::table) text += join_path({node.name}) + " = " + value_as_toml(node) + "\n";
    }
    for (const DocumentNode& node : table.children) {
        if (node.kind != Kind::table) continue;
        KeyPath inner = path;
        inner.push_back(node.name);
        text += "\n[" + join_path(inner) + "]\n";
        append_table(node, inner, text);
    }
}

/// Take the key or table of this path out of `table`, whose own path is `place`; false when there is none.
bool take_out(const std::string& path, const KeyPath& place, DocumentNode& table)
{
    for (auto node = table.children.begin(); node != table.children.end(); ++node) {
        KeyPath inner = place;
        inner.push_back(node->name);
        if (join_path(inner) == path) {
            table.children.erase(node);
            return true;
        }
        if (node->kind == Kind::table && take_out(path, inner, *node)) return true;
    }
    return false;
}

/// Take what the variant goes without out of its base.
void take_out_keys(const DocumentNode& document, const std::string& base_name, DocumentNode& base,
                   Diagnostics& findings)
{
    const DocumentNode* without = document.find(without_key);
    if (without == nullptr || without->kind != Kind::array) return; // the check of the keys tells
    for (const DocumentNode& item : without->children) {
        if (item.kind == Kind::text && !take_out(item.text, {}, base))
            findings.add(error_at(item.place, without_key, "the base has no '" + item.text + "'",
                                  "a key or table of " + base_name + ", as \"water\" or \"motion.cycles\""));
    }
}

void remove_names_of_bases(DocumentNode& document)
{
    std::erase_if(document.children,
                  [](const DocumentNode& node) { return node.name == base_key || node.name == without_key; });
}

/// The base that a scene names, itself merged with its own base. `seen` are the files from the scene that is
/// read to this one.
std::optional<DocumentNode> read_base(const DocumentNode& name, std::vector<std::filesystem::path> seen,
                                      Diagnostics& findings);

std::optional<DocumentNode> merge_with_bases(std::vector<std::filesystem::path> seen, DocumentNode&& document,
                                             Diagnostics& findings)
{
    const DocumentNode* name = document.find(base_key);
    if (name == nullptr || name->kind != Kind::text) {
        if (const DocumentNode* without = document.find(without_key)) {
            findings.add(error_at(without->name_place, without_key,
                                  "the scene has no base to leave keys out of", "",
                                  "remove the key, or add base = \"scene.toml\""));
            return std::nullopt;
        }
        return std::move(document);
    }
    auto merged = read_base(*name, std::move(seen), findings);
    if (!merged) return std::nullopt;
    take_out_keys(document, name->text, *merged, findings);
    if (findings.has_errors()) return std::nullopt;
    merge_variant(std::move(document), *merged);
    return merged;
}

std::optional<DocumentNode> read_base(const DocumentNode& name, std::vector<std::filesystem::path> seen,
                                      Diagnostics& findings)
{
    const auto refuse = [&](std::string what, std::string expected) {
        findings.add(error_at(name.place, base_key, std::move(what), std::move(expected)));
        return std::nullopt;
    };
    if (name.text.empty() || std::filesystem::path(name.text).has_parent_path())
        return refuse("the base is not in the folder of this scene",
                      "the name of a scene in the same folder");
    const std::filesystem::path base = (seen.back().parent_path() / name.text).lexically_normal();
    if (base == seen.back())
        return refuse("the scene names itself as its base", "the name of another scene in the same folder");
    if (std::find(seen.begin(), seen.end(), base) != seen.end())
        return refuse("'" + name.text + "' has this scene among its bases",
                      "a scene that does not lead back to this one");
    const auto text = read_text_file(base, name.place, findings);
    if (!text) return std::nullopt;
    findings.keep_text(base, *text);
    check_characters(base, *text, findings);
    if (findings.has_errors()) return std::nullopt;
    auto document = read_document(base, *text, {}, findings);
    if (!document) return std::nullopt;
    name_stages(*document, findings);
    if (findings.has_errors()) return std::nullopt;
    seen.push_back(base);
    auto standing = merge_with_bases(std::move(seen), std::move(*document), findings);
    if (standing) remove_names_of_bases(*standing);
    return standing;
}

} // namespace

std::optional<DocumentNode> merge_with_base(const std::filesystem::path& file, DocumentNode&& document,
                                            Diagnostics& findings)
{
    return merge_with_bases({file.lexically_normal()}, std::move(document), findings);
}

std::string document_text(const DocumentNode& document)
{
    DocumentNode standing = document;
    remove_names_of_bases(standing);
    std::string text;
    append_table(standing, {}, text);
    return text;
}

} // namespace quicksand
