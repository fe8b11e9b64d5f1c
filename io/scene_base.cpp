#include "io/scene_base.hpp"

#include "io/scene_schema.hpp"
#include "io/scene_text.hpp"
#include "io/scene_units.hpp"

#include <fmt/format.h>

#include <utility>

namespace quicksand {

namespace {

using Kind = DocumentNode::Kind;

constexpr const char* base_key = "base";

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

} // namespace

std::optional<DocumentNode> merge_with_base(const std::filesystem::path& file, DocumentNode&& document,
                                            Diagnostics& findings)
{
    const DocumentNode* name = document.find(base_key);
    if (name == nullptr || name->kind != Kind::text) return std::move(document);
    const auto refuse = [&](std::string what, std::string expected) {
        findings.add(error_at(name->place, "base", std::move(what), std::move(expected)));
        return std::nullopt;
    };
    const std::filesystem::path base = file.parent_path() / name->text;
    if (name->text.empty() || std::filesystem::path(name->text).has_parent_path())
        return refuse("the base is not in the folder of this scene",
                      "the name of a scene in the same folder");
    if (base.lexically_normal() == file.lexically_normal())
        return refuse("the scene names itself as its base", "the name of another scene in the same folder");
    const auto text = read_text_file(base, name->place, findings);
    if (!text) return std::nullopt;
    findings.keep_text(base, *text);
    check_characters(base, *text, findings);
    if (findings.has_errors()) return std::nullopt;
    auto merged = read_document(base, *text, {}, findings);
    if (!merged) return std::nullopt;
    if (merged->find(base_key) != nullptr)
        return refuse("the base has a base itself", "a scene that stands by itself");
    replace_keys(std::move(document), *merged);
    return merged;
}

std::string document_text(const DocumentNode& document)
{
    DocumentNode standing = document;
    std::erase_if(standing.children, [](const DocumentNode& node) { return node.name == base_key; });
    std::string text;
    append_table(standing, {}, text);
    return text;
}

} // namespace quicksand
