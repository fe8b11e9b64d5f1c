#include "io/keys/scene_value_reader.hpp"

#include "geometry/drawing/nearest_name.hpp"
#include "io/keys/quantity_hints.hpp"
#include "io/keys/written_value.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

using Kind = DocumentNode::Kind;

/// A number with what the user wrote, for the hints.
struct ReadNumber {
    double value = 0.0; // SI
    WrittenQuantity written;
};

class ValueReader {
public:
    ValueReader(const SceneKey& key, std::string path, Diagnostics& findings)
        : key_(key), path_(std::move(path)), findings_(findings)
    {
    }

    std::optional<SceneValue> read(const DocumentNode& node);

private:
    std::optional<double> read_number(const DocumentNode& node);
    std::optional<ReadNumber> read_quantity(const DocumentNode& node);
    std::optional<std::int64_t> read_integer(const DocumentNode& node);
    std::optional<SceneValue> read_text(const DocumentNode& node);
    std::optional<SceneValue> read_word(const DocumentNode& node);
    std::optional<SceneValue> read_pair(const DocumentNode& node);
    std::optional<SceneValue> read_point_list(const DocumentNode& node);
    std::optional<SceneValue> read_number_table(const DocumentNode& node);
    std::optional<SceneValue> read_list_table(const DocumentNode& node);
    std::optional<SceneValue> read_text_list(const DocumentNode& node);
    std::optional<SceneValue> read_number_list(const DocumentNode& node);
    std::optional<SceneValue> read_quantity_list(const DocumentNode& node);
    std::optional<SceneValue> read_count_list(const DocumentNode& node);
    std::optional<SceneValue> read_as_written(const DocumentNode& node);

    bool check_range(double value, const DocumentNode& node, const ReadNumber* read);
    void check_plausibility(const ReadNumber& number, const DocumentNode& node);
    void refuse(const DocumentNode& node, const char* kind, std::string what, std::string expected,
                std::string hint = "")
    {
        findings_.add(error_at(node.place, kind, std::move(what), std::move(expected), std::move(hint)));
    }
    void refuse_type(const DocumentNode& node, std::string expected, std::string hint = "")
    {
        refuse(node, "type", path_ + " is " + describe_kind(node.kind), std::move(expected), std::move(hint));
    }

    const SceneKey& key_;
    std::string path_;
    Diagnostics& findings_;
};

std::optional<ReadNumber> ValueReader::read_quantity(const DocumentNode& node)
{
    if (node.kind == Kind::integer || node.kind == Kind::number) {
        if (std::isfinite(node.number)) return ReadNumber{node.number, {node.number, ""}};
        refuse(node, "not-finite", path_ + " = " + number_text(node.number) + " is not a finite number",
               number_form(key_.dimension));
        return std::nullopt;
    }
    if (node.kind != Kind::text) {
        refuse_type(node, number_form(key_.dimension));
        return std::nullopt;
    }
    const auto quantity = split_quantity(node.text);
    if (!quantity) {
        refuse_type(node, number_form(key_.dimension));
        return std::nullopt;
    }
    if (quantity->unit.empty()) {
        refuse(node, "unit", path_ + " stands in quotes but has no unit", list_units(key_.dimension),
               "without quotes, " + quantity_text(quantity->number, key_.dimension) + " is understood");
        return std::nullopt;
    }
    const auto value = to_si(*quantity, key_.dimension);
    if (!value) {
        const std::string nearest = unit_in_other_case(quantity->unit, key_.dimension);
        refuse(node, "unit", path_ + " has the unit '" + quantity->unit + "'", list_units(key_.dimension),
               nearest.empty() ? "" : "did you mean " + nearest + "?");
        return std::nullopt;
    }
    if (!std::isfinite(*value)) {
        refuse(node, "not-finite", path_ + " is not a finite number", number_form(key_.dimension));
        return std::nullopt;
    }
    return ReadNumber{*value, *quantity};
}

bool ValueReader::check_range(double value, const DocumentNode& node, const ReadNumber* read)
{
    if (key_.allowed.contains(value)) return true;
    const std::string likely = read != nullptr && key_.dimension == Dimension::none
                                   ? likely_quantity(read->written, key_.dimension, key_.plausible)
                                   : "";
    refuse(node, "range", path_ + " = " + quantity_text(value, key_.dimension) + " is out of range",
           describe(key_.allowed, key_.dimension), likely.empty() ? "" : "did you mean " + likely + "?");
    return false;
}

void ValueReader::check_plausibility(const ReadNumber& number, const DocumentNode& node)
{
    if (key_.plausible.contains(number.value)) return;
    const std::string likely = likely_quantity(number.written, key_.dimension, key_.plausible);
    std::string hint = likely.empty() ? "" : "did you mean " + likely + "?";
    if (!key_.caution.empty()) hint += (hint.empty() ? "" : " ") + std::string(key_.caution);
    findings_.add(warning_at(node.place, path_, "plausibility",
                             path_ + " = " + quantity_text(number.value, key_.dimension) + " is unusually " +
                                 (number.value < key_.plausible.lower ? "small" : "large"),
                             "usually " + describe(key_.plausible, key_.dimension), hint));
}

std::optional<double> ValueReader::read_number(const DocumentNode& node)
{
    const auto number = read_quantity(node);
    if (!number || !check_range(number->value, node, &*number)) return std::nullopt;
    check_plausibility(*number, node);
    return number->value;
}

std::optional<std::int64_t> ValueReader::read_integer(const DocumentNode& node)
{
    if (node.kind == Kind::number && std::isfinite(node.number)) {
        refuse(node, "type", path_ + " = " + decimal_text(node.number) + " is not a whole number",
               "a whole number, " + describe(key_.allowed, Dimension::none),
               node.number == std::floor(node.number) ? "write it without the decimal point" : "");
        return std::nullopt;
    }
    if (node.kind != Kind::integer) {
        refuse_type(node, "a whole number, " + describe(key_.allowed, Dimension::none));
        return std::nullopt;
    }
    if (!check_range(node.number, node, nullptr)) return std::nullopt;
    check_plausibility({node.number, {node.number, ""}}, node);
    return node.integer;
}

std::optional<SceneValue> ValueReader::read_text(const DocumentNode& node)
{
    if (node.kind != Kind::text) {
        refuse_type(node, "text in quotes");
        return std::nullopt;
    }
    if (node.text.empty() && key_.required) {
        refuse(node, "range", path_ + " is empty", "text in quotes");
        return std::nullopt;
    }
    return node.text;
}

std::optional<SceneValue> ValueReader::read_word(const DocumentNode& node)
{
    const std::vector<std::string> words(key_.words.begin(), key_.words.end());
    if (node.kind != Kind::text) {
        refuse_type(node, one_of(words));
        return std::nullopt;
    }
    if (std::find(words.begin(), words.end(), node.text) != words.end()) return node.text;
    const std::string nearest = nearest_name(node.text, words);
    refuse(node, "word", path_ + " = \"" + node.text + "\" is not known", one_of(words),
           nearest.empty() ? "" : "did you mean \"" + nearest + "\"?");
    return std::nullopt;
}

std::optional<SceneValue> ValueReader::read_pair(const DocumentNode& node)
{
    const bool counts = key_.type == ValueType::count_pair;
    if (node.kind != Kind::array || node.children.size() != 2) {
        const std::string form = counts ? "two whole numbers, as [3, 3]"
                                        : "[x, y], two numbers in " + std::string(si_symbol(key_.dimension));
        if (node.kind != Kind::array) {
            refuse_type(node, form);
        } else {
            refuse(node, "type", path_ + " is a list of " + std::to_string(node.children.size()), form);
        }
        return std::nullopt;
    }
    if (counts) {
        const auto first = read_integer(node.children[0]), second = read_integer(node.children[1]);
        if (!first || !second) return std::nullopt;
        return std::pair<int, int>(static_cast<int>(*first), static_cast<int>(*second));
    }
    const auto x = read_number(node.children[0]), y = read_number(node.children[1]);
    if (!x || !y) return std::nullopt;
    return Vector2(*x, *y);
}

std::optional<SceneValue> ValueReader::read_point_list(const DocumentNode& node)
{
    if (node.kind != Kind::array || node.children.size() < 2) {
        refuse(node, "type",
               path_ + " is " +
                   (node.kind == Kind::array ? "a list of less than two" : describe_kind(node.kind)),
               "two points or more, as [[0, 1.5], [10, 0.5]]");
        return std::nullopt;
    }
    std::vector<Vector2> points;
    for (const DocumentNode& child : node.children) {
        if (const auto point = read_pair(child)) points.push_back(std::get<Vector2>(*point));
    }
    if (points.size() < node.children.size()) return std::nullopt;
    return points;
}

std::optional<SceneValue> ValueReader::read_number_table(const DocumentNode& node)
{
    if (node.kind != Kind::table) {
        refuse_type(node, "a table of numbers, as { crest_width = 0.15 }");
        return std::nullopt;
    }
    std::map<std::string, double> numbers;
    bool good = true;
    for (const DocumentNode& child : node.children) {
        ValueReader reader(key_, path_ + "." + join_path({child.name}), findings_);
        if (const auto number = reader.read_number(child)) {
            numbers[child.name] = *number;
        } else {
            good = false;
        }
    }
    if (!good) return std::nullopt;
    return numbers;
}

std::optional<SceneValue> ValueReader::read_list_table(const DocumentNode& node)
{
    if (node.kind != Kind::table) {
        refuse_type(node, "a table of lists of numbers, as { settlement = [0.01, 0.005] }");
        return std::nullopt;
    }
    std::map<std::string, std::vector<double>> lists;
    bool good = true;
    for (const DocumentNode& child : node.children) {
        ValueReader reader(key_, path_ + "." + join_path({child.name}), findings_);
        if (child.kind != Kind::array) {
            reader.refuse_type(child, "a list of numbers, as [0.01, 0.005]");
            good = false;
            continue;
        }
        for (const DocumentNode& item : child.children) {
            const auto number = reader.read_number(item);
            good = good && number;
            lists[child.name].push_back(number.value_or(0.0));
        }
    }
    if (!good) return std::nullopt;
    return lists;
}

std::optional<SceneValue> ValueReader::read_count_list(const DocumentNode& node)
{
    if (node.kind != Kind::array || node.children.empty()) {
        refuse_type(node, "a list of whole numbers, as [10, 20, 40]");
        return std::nullopt;
    }
    std::vector<int> counts;
    for (const DocumentNode& child : node.children) {
        const auto count = read_integer(child);
        if (!count) return std::nullopt;
        counts.push_back(static_cast<int>(*count));
    }
    return counts;
}

std::optional<SceneValue> ValueReader::read_text_list(const DocumentNode& node)
{
    std::vector<std::string> texts;
    bool good = node.kind == Kind::array;
    for (const DocumentNode& child : node.children) {
        good = good && child.kind == Kind::text;
        texts.push_back(child.text);
    }
    if (good) return texts;
    refuse_type(node, "a list of texts in quotes, as [\"materials.sand.porosity\"]");
    return std::nullopt;
}

std::optional<SceneValue> ValueReader::read_number_list(const DocumentNode& node)
{
    if (node.kind != Kind::array || node.children.empty()) {
        const std::string form = "a list, each " + number_form(key_.dimension);
        if (node.kind != Kind::array) {
            refuse_type(node, form);
        } else {
            refuse(node, "type", path_ + " is an empty list", form);
        }
        return std::nullopt;
    }
    std::vector<double> numbers;
    for (const DocumentNode& child : node.children) {
        if (const auto number = read_number(child)) numbers.push_back(*number);
    }
    if (numbers.size() < node.children.size()) return std::nullopt;
    return numbers;
}

std::optional<SceneValue> ValueReader::read_quantity_list(const DocumentNode& node)
{
    std::vector<std::string> texts;
    bool good = node.kind == Kind::array && !node.children.empty();
    for (const DocumentNode& child : node.children) {
        const bool plain = child.kind == Kind::integer || child.kind == Kind::number;
        good = good && (plain || child.kind == Kind::text);
        texts.push_back(plain ? number_text(child.number) : child.text);
    }
    if (good) return texts;
    refuse(node, "type",
           path_ + " is " + (node.kind == Kind::array ? "not a list of numbers" : describe_kind(node.kind)),
           "a list of numbers, or of quantities in quotes");
    return std::nullopt;
}

std::optional<SceneValue> ValueReader::read_as_written(const DocumentNode& node)
{
    auto value = as_written(key_.type, node);
    if (!value) refuse_type(node, form_as_written(key_.type));
    return value;
}

std::optional<SceneValue> ValueReader::read(const DocumentNode& node)
{
    switch (key_.type) {
    case ValueType::number:
        return read_number(node);
    case ValueType::integer:
        return read_integer(node);
    case ValueType::text:
    case ValueType::path:
        return read_text(node);
    case ValueType::word:
        return read_word(node);
    case ValueType::point:
    case ValueType::count_pair:
        return read_pair(node);
    case ValueType::point_list:
        return read_point_list(node);
    case ValueType::number_table:
        return read_number_table(node);
    case ValueType::list_table:
        return read_list_table(node);
    case ValueType::text_list:
        return read_text_list(node);
    case ValueType::number_list:
        return read_number_list(node);
    case ValueType::quantity_list:
        return read_quantity_list(node);
    case ValueType::count_list:
        return read_count_list(node);
    case ValueType::quantity:
    case ValueType::value_list:
        return read_as_written(node);
    case ValueType::table:
    case ValueType::named_tables:
        break;
    }
    return std::nullopt;
}

} // namespace

std::optional<SceneValue> read_value(const SceneKey& key, const std::string& path, const DocumentNode& node,
                                     Diagnostics& findings)
{
    return ValueReader(key, path, findings).read(node);
}

std::string describe_kind(DocumentNode::Kind kind)
{
    switch (kind) {
    case Kind::table:
        return "a table";
    case Kind::array:
        return "a list";
    case Kind::text:
        return "text";
    case Kind::integer:
    case Kind::number:
        return "a number";
    case Kind::boolean:
        return "true or false";
    case Kind::date:
        return "a date or time";
    }
    return "";
}

} // namespace quicksand
