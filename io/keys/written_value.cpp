#include "io/keys/written_value.hpp"

#include <cmath>

namespace quicksand {

namespace {

using Kind = DocumentNode::Kind;

/// The value as it may stand behind an equals sign; "" where it holds other than numbers, texts and lists.
std::string value_in_toml(const DocumentNode& node)
{
    if (node.kind == Kind::text) return toml_text(node.text);
    if (node.kind == Kind::integer) return std::to_string(node.integer);
    if (node.kind == Kind::number) return std::isfinite(node.number) ? decimal_text(node.number) : "";
    if (node.kind != Kind::array) return "";
    std::string text;
    for (const DocumentNode& child : node.children) {
        const std::string value = value_in_toml(child);
        if (value.empty()) return "";
        text += (text.empty() ? "" : ", ") + value;
    }
    return "[" + text + "]";
}

std::optional<SceneValue> quantity_of(const DocumentNode& node)
{
    const bool plain = node.kind == Kind::integer || node.kind == Kind::number;
    if (plain && std::isfinite(node.number)) return number_text(node.number);
    if (node.kind == Kind::text && split_quantity(node.text)) return node.text;
    return std::nullopt;
}

std::optional<SceneValue> list_of(const DocumentNode& node)
{
    if (node.kind != Kind::array || node.children.empty()) return std::nullopt;
    std::vector<std::string> texts;
    for (const DocumentNode& child : node.children) {
        texts.push_back(value_in_toml(child));
        if (texts.back().empty()) return std::nullopt;
    }
    return texts;
}

} // namespace

std::string decimal_text(double number)
{
    const std::string text = number_text(number);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::optional<SceneValue> as_written(ValueType type, const DocumentNode& node)
{
    return type == ValueType::quantity ? quantity_of(node) : list_of(node);
}

std::string form_as_written(ValueType type)
{
    return type == ValueType::quantity ? "a number, or a quantity in quotes"
                                       : "a list of numbers, texts or lists of them, at least one";
}

} // namespace quicksand
